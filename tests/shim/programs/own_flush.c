// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A program that defines a GL function itself calls its own function.
#include "draw.h"

static int flushed = 0;
void glFlush(void) { flushed += 1; }

int main(void) {
  glFlush();
  ((void (*)(void))dlsym(RTLD_DEFAULT, "glFlush"))();
  ((void (*)(void))dlsym(dlopen(NULL, RTLD_NOW), "glFlush"))();
  printf("flushed %d\n", flushed);
  return 0;
}
