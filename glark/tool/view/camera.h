// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A camera that circles around a point.
#pragma once

#include <array>

namespace glark::tool {

using Matrix = std::array<float, 16>;  // column-major, as GL has it

struct Camera {
  std::array<float, 3> target{};  // in the positions' space
  float radius = 1;               // of the sphere about the target that holds everything
  float yaw = 30;                 // degrees about the y axis
  float pitch = 20;               // degrees above the horizon, -90 to 90
  float zoom = 1;                 // 1 shows everything
  bool z_is_up = false;

  float distance() const;
  Matrix projection(int width, int height) const;
  Matrix view() const;
  // In pixels, of a length of 1 at a distance of 1.
  float pixels_per_length(int height) const;
  void turn(float pixels_x, float pixels_y);
  // By so many pixels of the picture.
  void shift(float pixels_x, float pixels_y, int height);
};

Matrix product(const Matrix& a, const Matrix& b);

}  // namespace glark::tool
