// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Two threads, each with a context that shares with a first one, destroyed while current and not.
#include <pthread.h>
#include <stdlib.h>

#include "draw.h"

static OSMesaContext first;

static void* draw_in_thread(void* unused) {
  (void)unused;
  unsigned char* pixels = malloc(16 * 16 * 4);
  for (int i = 0; i < 20; ++i) {
    OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, first);
    OSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, 16, 16);
    glBegin(GL_TRIANGLES);
    glVertex2f(-1, -1);
    glVertex2f(3, -1);
    glVertex2f(-1, 3);
    glEnd();
    glFinish();
    if (i % 2) OSMesaMakeCurrent(NULL, NULL, 0, 0, 0);
    OSMesaDestroyContext(context);
  }
  free(pixels);
  return NULL;
}

int main(void) {
  first = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, NULL);
  pthread_t threads[2];
  for (int i = 0; i < 2; ++i) pthread_create(&threads[i], NULL, draw_in_thread, NULL);
  for (int i = 0; i < 2; ++i) pthread_join(threads[i], NULL);
  OSMesaDestroyContext(first);
  printf("done\n");
  return 0;
}
