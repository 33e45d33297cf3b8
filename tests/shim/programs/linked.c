// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Linked with libOSMesa: as an executable, and as a plug-in (draw_as_plugin).
#include "draw.h"

int draw_as_plugin(void) {
  const struct Functions gl = {
      glClear,     glDrawArrays, glVertexPointer,        glEnableClientState, glColor3f,           glFinish,
      glGetString, glGetError,   OSMesaCreateContextExt, OSMesaMakeCurrent,   OSMesaDestroyContext};
  return draw(&gl);
}

#ifndef PLUGIN
int main(void) { return draw_as_plugin(); }
#endif
