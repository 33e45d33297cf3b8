// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/view/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glark::tool {
namespace {

constexpr float degree = std::numbers::pi_v<float> / 180;
constexpr float half_opening = 20 * degree;
constexpr float degrees_per_pixel = 0.3F;

Matrix about_x(float angle) {
  const float c = std::cos(angle);
  const float s = std::sin(angle);
  return {1, 0, 0, 0, 0, c, s, 0, 0, -s, c, 0, 0, 0, 0, 1};
}

Matrix about_y(float angle) {
  const float c = std::cos(angle);
  const float s = std::sin(angle);
  return {c, 0, -s, 0, 0, 1, 0, 0, s, 0, c, 0, 0, 0, 0, 1};
}

Matrix translation(float x, float y, float z) { return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1}; }

}  // namespace

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix result{};
  for (std::size_t column = 0; column < 4; ++column)
    for (std::size_t row = 0; row < 4; ++row)
      for (std::size_t k = 0; k < 4; ++k) result[4 * column + row] += a[4 * k + row] * b[4 * column + k];
  return result;
}

float Camera::distance() const { return radius / std::sin(half_opening) / zoom; }

float Camera::pixels_per_length(int height) const { return static_cast<float>(height) / (2 * std::tan(half_opening)); }

Matrix Camera::projection(int width, int height) const {
  const float far = distance() + radius;
  const float near = std::max(distance() - radius, far * 1e-3F);
  const float scale = 1 / std::tan(half_opening);
  const float aspect = static_cast<float>(width) / static_cast<float>(height);
  // What fits into the shorter side is shown whole.
  const float shorter = std::min(aspect, 1.0F);
  return {scale * shorter / aspect,      0, 0, 0, 0, scale * shorter, 0, 0, 0, 0, (far + near) / (near - far), -1, 0, 0,
          2 * far * near / (near - far), 0};
}

Matrix Camera::view() const {
  const Matrix turned = product(about_x(pitch * degree), about_y(-yaw * degree));
  const Matrix upright = z_is_up ? product(turned, about_x(-90 * degree)) : turned;
  return product(product(translation(0, 0, -distance()), upright), translation(-target[0], -target[1], -target[2]));
}

void Camera::turn(float pixels_x, float pixels_y) {
  yaw = std::remainder(yaw - pixels_x * degrees_per_pixel, 360.0F);
  pitch = std::clamp(pitch + pixels_y * degrees_per_pixel, -90.0F, 90.0F);
}

void Camera::shift(float pixels_x, float pixels_y, int height) {
  const Matrix matrix = view();
  const float length = distance() / pixels_per_length(height);
  for (std::size_t axis = 0; axis < 3; ++axis)
    target[axis] -= length * (pixels_x * matrix[4 * axis] - pixels_y * matrix[4 * axis + 1]);
}

}  // namespace glark::tool
