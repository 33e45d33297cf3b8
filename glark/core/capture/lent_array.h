// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A vertex array that a draw of the application does not enable, and that its capture needs: the normals of its mesh.
#pragma once

#include "glark/core/state/arrays/array_state.h"
#include "glark/core/state/arrays/vertex_arrays.h"
#include "glark/gl/dispatch.h"

namespace glark::capture {

struct LentArray {
  core::AttributeSource source;  // in a buffer
  GLuint attribute = 0;          // generic; the application has left it in its initial state

  // Enables the array in the bound vertex array object.
  void lend(const gl::Dispatch& gl, core::ArrayState& arrays) const;
  // Gives the attribute its initial state again.
  void take_back(const gl::Dispatch& gl, core::ArrayState& arrays) const;
};

}  // namespace glark::capture
