// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Linked to a libepoxy that was generated with glark.xml.
#include <epoxy/gl.h>

#include <stdbool.h>

#include "context.h"

int main(void) {
  if (!make_context()) return 3;
  if (!epoxy_has_gl_extension("GL_ARK_adaptive_refinement")) return 4;
#ifndef GL_ARK_adaptive_refinement
#error "the header does not name the extension"
#endif
  return use_extension();
}
