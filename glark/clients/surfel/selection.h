// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What a view shows of a level of detail.
#pragma once

#include <glark/surfel.h>

#include <array>
#include <span>

#include "glark/clients/surfel/vector.h"

namespace glark::surfel {

class Camera {
 public:
  // Throws Error.
  explicit Camera(const View& view);

  // Whether the box is outside of a plane of the frustum; planes that it is inside of leave the set.
  bool outside(const Node& node, unsigned& planes) const;
  // Whether all triangles of the node turn their back.
  bool back_face(const Node& node) const;
  // Of a sphere, in pixels: an upper bound; infinite where it holds the eye.
  float diameter(Vector centre, float radius) const;

 private:
  using Plane = std::array<float, 4>;
  void find_eye();

  Plane x_{}, y_{}, z_{}, w_{};  // rows of the matrix
  std::array<Plane, 6> planes_{};
  Vector eye_;
  bool parallel_ = false;  // then eye_ is the direction to it
  float half_width_, half_height_;
};

void select_nodes(std::span<const Node> nodes, const View& view, const Camera& camera, Frame& frame);

}  // namespace glark::surfel
