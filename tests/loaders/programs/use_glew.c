// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Compiled with a GLEW that was generated with glark.xml.
#include <GL/glew.h>

#include "context.h"

int main(void) {
  if (!make_context()) return 3;
  if (glewInit() != GLEW_OK) return 5;
  if (!GLEW_ARK_adaptive_refinement || !glewIsSupported("GL_ARK_adaptive_refinement")) return 4;
  return use_extension();
}
