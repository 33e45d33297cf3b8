// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/state/fixed_function/matrices.h"

#include <algorithm>
#include <cmath>

namespace glark::core {
namespace {

// Matrices are stored by columns. Without perspective, the last row is (0, 0, 0, 1).
bool is_affine(const GLfloat* m) { return m[3] == 0 && m[7] == 0 && m[11] == 0 && m[15] == 1; }

bool keeps_z_apart(const GLfloat* m) { return is_affine(m) && m[2] == 0 && m[6] == 0 && m[8] == 0 && m[9] == 0; }

// Moves, turns and scales in the plane.
bool keeps_z(const GLfloat* m) { return keeps_z_apart(m) && m[10] == 1 && m[14] == 0; }

// gluOrtho2D, or a very flat space between near and far plane: some scene graphs fit these planes to the scene.
bool projects_plane(const GLfloat* m) {
  constexpr GLfloat thin = 8;
  const bool sheet = std::abs(m[10]) >= thin * std::max(std::abs(m[0]), std::abs(m[5]));
  return keeps_z_apart(m) && ((m[10] == -1 && m[14] == 0) || sheet);
}

}  // namespace

const MatrixTraits& Matrices::traits(const gl::Dispatch& gl) {
  GLfloat matrix[16];
  if (projection_stale_) {
    projection_stale_ = false;
    gl.GetFloatv(GL_PROJECTION_MATRIX, matrix);
    traits_.affine = is_affine(matrix);
    traits_.projects_plane = projects_plane(matrix);
  }
  if (modelview_stale_ && traits_.projects_plane) {
    modelview_stale_ = false;
    gl.GetFloatv(GL_MODELVIEW_MATRIX, matrix);
    traits_.moves_in_plane = keeps_z(matrix);
  }
  return traits_;
}

}  // namespace glark::core
