// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A camera that circles around a point.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace glark::tool {

struct Camera {
  glm::vec3 target{0};   // in the positions' space
  float radius = 1;      // the radius of a sphere about the target that holds everything
  float yaw = 30;        // degrees about the upright axis
  float pitch = 20;      // degrees above the horizon, -90 to 90
  float zoom = 1;        // 1 shows everything; 2 shows half of the width
  bool z_is_up = false;  // true: the z axis points up; false: the y axis

  float distance() const;
  glm::mat4 projection(int width, int height) const;
  glm::mat4 view() const;
  // The size in pixels of a length of 1 at a distance of 1.
  float pixels_per_length(int height) const;
  // Turns and shifts by pixels of the picture.
  void turn(float pixels_x, float pixels_y);
  void shift(float pixels_x, float pixels_y, int height);
};

}  // namespace glark::tool
