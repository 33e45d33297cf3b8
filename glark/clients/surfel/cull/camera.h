// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Tests of tree nodes against a view.
#pragma once

#include <glark/surfel.h>

#include <array>

#include "glark/clients/surfel/tree/vector.h"

namespace glark::surfel {

class Camera {
 public:
  // The view must have a size and a finite matrix.
  explicit Camera(const View& view);

  // Returns whether the node's box is outside the frustum. `planes` is the set of planes to test. The call removes the
  // planes for which the whole box is inside.
  bool is_outside(const Node& node, unsigned& planes) const;
  // Returns whether all triangles of the node are back-facing.
  bool is_back_facing(const Node& node) const;
  // Returns an upper bound of a sphere's size on the screen, in pixels. The bound is infinite for a sphere around the
  // eye.
  float projected_diameter(Vector centre, float radius) const;

 private:
  using Plane = std::array<float, 4>;
  void find_eye();

  Plane x_{}, y_{}, z_{}, w_{};  // the rows of the matrix
  std::array<Plane, 6> planes_{};
  Vector eye_;  // for a parallel projection: the direction to the eye
  bool parallel_ = false;
  float half_width_, half_height_;
};

}  // namespace glark::surfel
