// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A library that asks for the functions behind it. RTLD_NEXT must give the driver's functions, according to the
// library's position.
#include "draw.h"

const char* next_draw_arrays_is(void) { return is_ours(dlsym(RTLD_NEXT, "glDrawArrays")) ? "ours" : "the driver's"; }

// Makes a context current without the shim seeing it.
int make_current_unseen(OSMesaContext context, void* buffer) {
  GLboolean (*make_current)(OSMesaContext, void*, GLenum, GLsizei, GLsizei) = dlsym(RTLD_NEXT, "OSMesaMakeCurrent");
  return make_current(context, buffer, GL_UNSIGNED_BYTE, 16, 16);
}
