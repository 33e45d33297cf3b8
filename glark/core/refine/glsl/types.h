// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The numeric types of GLSL that a vertex attribute or an output can have.
#pragma once

#include <string_view>

#include "glark/gl/types.h"

namespace glark::refine {

enum class Scalar { float32, float64, int32, uint32, boolean };

struct NumericType {
  std::string_view name;  // in GLSL: "vec3", "mat4x3"
  GLenum gl = 0;          // in the API: GL_FLOAT_VEC3
  Scalar scalar = Scalar::float32;
  int columns = 1;  // 1 for scalars and vectors
  int rows = 1;     // components of a column

  int components() const { return columns * rows; }
  int words() const { return components() * (scalar == Scalar::float64 ? 2 : 1); }
  bool interpolates() const { return scalar == Scalar::float32 || scalar == Scalar::float64; }
};

// nullptr for any other type.
const NumericType* numeric_type(GLenum gl);
const NumericType* numeric_type(std::string_view glsl_name);

}  // namespace glark::refine
