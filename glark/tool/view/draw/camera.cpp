// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/view/draw/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace glark::tool {
namespace {

constexpr float half_opening_degrees = 20;
constexpr float degrees_per_pixel = 0.3F;
constexpr glm::vec3 x_axis{1, 0, 0}, y_axis{0, 1, 0};

// The tangent of half the opening angle. A zoom above 1 narrows the angle and does not move the camera: so it cannot enter
// the object.
float half_opening_tangent(float zoom) { return std::tan(glm::radians(half_opening_degrees)) / std::max(zoom, 1.0F); }

}  // namespace

float Camera::distance() const { return radius / std::sin(glm::radians(half_opening_degrees)) / std::min(zoom, 1.0F); }

float Camera::pixels_per_length(int height) const {
  return static_cast<float>(height) / (2 * half_opening_tangent(zoom));
}

// At a zoom of 1, the projection fits the whole sphere into the shorter side of the picture.
glm::mat4 Camera::projection(int width, int height) const {
  const float far = distance() + radius;
  const float near = std::max(distance() - radius, far * 1e-3F);
  const float aspect = static_cast<float>(width) / static_cast<float>(height);
  const float half_height = near * half_opening_tangent(zoom) / std::min(aspect, 1.0F);
  return glm::frustum(-half_height * aspect, half_height * aspect, -half_height, half_height, near, far);
}

glm::mat4 Camera::view() const {
  glm::mat4 matrix = glm::translate(glm::mat4(1), {0, 0, -distance()});
  matrix = glm::rotate(matrix, glm::radians(pitch), x_axis);
  matrix = glm::rotate(matrix, glm::radians(-yaw), y_axis);
  if (z_is_up) matrix = glm::rotate(matrix, glm::radians(-90.0F), x_axis);
  return glm::translate(matrix, -target);
}

void Camera::turn(float pixels_x, float pixels_y) {
  yaw = std::remainder(yaw - pixels_x * degrees_per_pixel, 360.0F);
  pitch = std::clamp(pitch + pixels_y * degrees_per_pixel, -90.0F, 90.0F);
}

void Camera::shift(float pixels_x, float pixels_y, int height) {
  const glm::mat4 matrix = view();
  const glm::vec3 right(glm::row(matrix, 0)), up(glm::row(matrix, 1));
  target -= distance() / pixels_per_length(height) * (pixels_x * right - pixels_y * up);
}

}  // namespace glark::tool
