// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// GL as a client of libGLARK sees it: linked functions, or found by name if libOSMesa does not export them.
#pragma once

#define GL_GLEXT_PROTOTYPES
#include <GL/osmesa.h>

#include <GL/glext.h>

#include <include/GL/glark.h>

namespace glark::core::test {

// GLARK_PROC(NamedBufferSubData, NAMEDBUFFERSUBDATA)(...)
template <typename Function>
Function proc(const char* name) {
  return reinterpret_cast<Function>(OSMesaGetProcAddress(name));
}

}  // namespace glark::core::test
