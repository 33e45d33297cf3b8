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
  // The view has a size and a finite matrix.
  explicit Camera(const View& view);

  // Whether the node's box is outside the frustum. `planes` is the set of planes to test; planes that the whole box is
  // inside of are removed.
  bool is_outside(const Node& node, unsigned& planes) const;
  // Whether all triangles of the node are back-facing.
  bool is_back_facing(const Node& node) const;
  // An upper bound of a sphere's size on the screen, in pixels. Infinite for a sphere around the eye.
  float projected_diameter(Vector centre, float radius) const;

 private:
  using Plane = std::array<float, 4>;
  void find_eye();

  Plane x_{}, y_{}, z_{}, w_{};  // rows of the matrix
  std::array<Plane, 6> planes_{};
  Vector eye_;  // for a parallel projection: the direction to the eye
  bool parallel_ = false;
  float half_width_, half_height_;
};

}  // namespace glark::surfel
