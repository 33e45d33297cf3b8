// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/glsl/types.h"

namespace glark::refine {
namespace {

constexpr NumericType types[] = {
    {"float", GL_FLOAT, Scalar::float32, 1, 1},
    {"vec2", GL_FLOAT_VEC2, Scalar::float32, 1, 2},
    {"vec3", GL_FLOAT_VEC3, Scalar::float32, 1, 3},
    {"vec4", GL_FLOAT_VEC4, Scalar::float32, 1, 4},
    {"mat2", GL_FLOAT_MAT2, Scalar::float32, 2, 2},
    {"mat3", GL_FLOAT_MAT3, Scalar::float32, 3, 3},
    {"mat4", GL_FLOAT_MAT4, Scalar::float32, 4, 4},
    {"mat2x3", GL_FLOAT_MAT2x3, Scalar::float32, 2, 3},
    {"mat2x4", GL_FLOAT_MAT2x4, Scalar::float32, 2, 4},
    {"mat3x2", GL_FLOAT_MAT3x2, Scalar::float32, 3, 2},
    {"mat3x4", GL_FLOAT_MAT3x4, Scalar::float32, 3, 4},
    {"mat4x2", GL_FLOAT_MAT4x2, Scalar::float32, 4, 2},
    {"mat4x3", GL_FLOAT_MAT4x3, Scalar::float32, 4, 3},
    {"double", GL_DOUBLE, Scalar::float64, 1, 1},
    {"dvec2", GL_DOUBLE_VEC2, Scalar::float64, 1, 2},
    {"dvec3", GL_DOUBLE_VEC3, Scalar::float64, 1, 3},
    {"dvec4", GL_DOUBLE_VEC4, Scalar::float64, 1, 4},
    {"dmat2", GL_DOUBLE_MAT2, Scalar::float64, 2, 2},
    {"dmat3", GL_DOUBLE_MAT3, Scalar::float64, 3, 3},
    {"dmat4", GL_DOUBLE_MAT4, Scalar::float64, 4, 4},
    {"dmat2x3", GL_DOUBLE_MAT2x3, Scalar::float64, 2, 3},
    {"dmat2x4", GL_DOUBLE_MAT2x4, Scalar::float64, 2, 4},
    {"dmat3x2", GL_DOUBLE_MAT3x2, Scalar::float64, 3, 2},
    {"dmat3x4", GL_DOUBLE_MAT3x4, Scalar::float64, 3, 4},
    {"dmat4x2", GL_DOUBLE_MAT4x2, Scalar::float64, 4, 2},
    {"dmat4x3", GL_DOUBLE_MAT4x3, Scalar::float64, 4, 3},
    {"int", GL_INT, Scalar::int32, 1, 1},
    {"ivec2", GL_INT_VEC2, Scalar::int32, 1, 2},
    {"ivec3", GL_INT_VEC3, Scalar::int32, 1, 3},
    {"ivec4", GL_INT_VEC4, Scalar::int32, 1, 4},
    {"uint", GL_UNSIGNED_INT, Scalar::uint32, 1, 1},
    {"uvec2", GL_UNSIGNED_INT_VEC2, Scalar::uint32, 1, 2},
    {"uvec3", GL_UNSIGNED_INT_VEC3, Scalar::uint32, 1, 3},
    {"uvec4", GL_UNSIGNED_INT_VEC4, Scalar::uint32, 1, 4},
    {"bool", GL_BOOL, Scalar::boolean, 1, 1},
    {"bvec2", GL_BOOL_VEC2, Scalar::boolean, 1, 2},
    {"bvec3", GL_BOOL_VEC3, Scalar::boolean, 1, 3},
    {"bvec4", GL_BOOL_VEC4, Scalar::boolean, 1, 4},
    // Other spellings; the API reports the first.
    {"mat2x2", GL_FLOAT_MAT2, Scalar::float32, 2, 2},
    {"mat3x3", GL_FLOAT_MAT3, Scalar::float32, 3, 3},
    {"mat4x4", GL_FLOAT_MAT4, Scalar::float32, 4, 4},
    {"dmat2x2", GL_DOUBLE_MAT2, Scalar::float64, 2, 2},
    {"dmat3x3", GL_DOUBLE_MAT3, Scalar::float64, 3, 3},
    {"dmat4x4", GL_DOUBLE_MAT4, Scalar::float64, 4, 4},
};

}  // namespace

const NumericType* numeric_type(GLenum gl) {
  for (const NumericType& type : types) {
    if (type.gl == gl) return &type;
  }
  return nullptr;
}

const NumericType* numeric_type(std::string_view glsl_name) {
  for (const NumericType& type : types) {
    if (type.name == glsl_name) return numeric_type(type.gl);
  }
  return nullptr;
}

}  // namespace glark::refine
