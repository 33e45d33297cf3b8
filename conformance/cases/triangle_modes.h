// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The modes of drawing commands that give triangles.
#pragma once

#include "conformance/gl/gl.h"

namespace glark::conformance {

struct TriangleMode {
  const char* name;
  GLenum mode;
  bool is_legacy;  // in the compatibility profile only
};
inline constexpr TriangleMode triangle_modes[] = {
    {"triangles", GL_TRIANGLES, false},       {"triangle_strip", GL_TRIANGLE_STRIP, false},
    {"triangle_fan", GL_TRIANGLE_FAN, false}, {"quads", GL_QUADS, true},
    {"quad_strip", GL_QUAD_STRIP, true},      {"polygon", GL_POLYGON, true}};

}  // namespace glark::conformance
