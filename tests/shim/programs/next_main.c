// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "draw.h"

const char* next_draw_arrays_is(void);
int make_current_unseen(OSMesaContext context, void* buffer);

int main(void) {
  static unsigned char pixels[16 * 16 * 4];
  printf("next glDrawArrays is %s\n", next_draw_arrays_is());
  OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, NULL);
  if (!make_current_unseen(context, pixels)) return 3;
  printf("adopted %s\n", strstr((const char*)glGetString(GL_EXTENSIONS), "GL_ARK_adaptive_refinement") ? "yes" : "no");
  OSMesaDestroyContext(context);
  return 0;
}
