// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The current matrices of the fixed function, as far as rules for draws need them.
#pragma once

#include <cstdint>

#include "glark/gl/dispatch.h"

namespace glark::core {

struct MatrixTraits {
  bool affine = false;          // the projection is without perspective
  bool projects_plane = false;  // as gluOrtho2D does, or into a space much thinner than it is wide
  bool moves_in_plane = false;  // the modelview matrix leaves z alone
};

class Matrices {
 public:
  // The matrix of this mode may have changed.
  void touch(GLenum mode) {
    (mode == GL_PROJECTION ? projection_stale_ : modelview_stale_) = true;
    program_stamp_ += mode >= GL_MATRIX0_ARB && mode <= GL_MATRIX31_ARB ? 1 : 0;
  }
  void touch_all() {
    projection_stale_ = modelview_stale_ = true;
    ++program_stamp_;
  }
  // Queries what may have changed. `moves_in_plane` is valid only with `projects_plane`.
  const MatrixTraits& traits(const gl::Dispatch& gl);
  // Changes whenever a matrix for assembly programs (GL_MATRIX0_ARB ...) may have changed.
  std::uint64_t program_stamp() const { return program_stamp_; }

 private:
  MatrixTraits traits_;
  bool projection_stale_ = true;
  bool modelview_stale_ = true;
  std::uint64_t program_stamp_ = 1;
};

}  // namespace glark::core
