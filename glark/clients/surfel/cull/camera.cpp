// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/cull/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glark::surfel {
namespace {

// The signed distance of a point from a plane, times the length of the plane's normal.
float evaluate(const std::array<float, 4>& plane, Vector point) {
  return plane[0] * point.x + plane[1] * point.y + plane[2] * point.z + plane[3];
}

float slope(const std::array<float, 4>& plane) { return length(Vector{plane[0], plane[1], plane[2]}); }

// Returns the determinant of the three rows without one column.
double minor(const std::array<std::array<float, 4>, 3>& rows, std::size_t without) {
  std::array<std::size_t, 3> columns{};
  for (std::size_t k = 0, c = 0; c < 4; ++c) {
    if (c != without) columns[k++] = c;
  }
  const auto m = [&](std::size_t r, std::size_t c) { return double{rows[r][columns[c]]}; };
  return m(0, 0) * (m(1, 1) * m(2, 2) - m(1, 2) * m(2, 1)) - m(0, 1) * (m(1, 0) * m(2, 2) - m(1, 2) * m(2, 0)) +
         m(0, 2) * (m(1, 0) * m(2, 1) - m(1, 1) * m(2, 0));
}

}  // namespace

Camera::Camera(const View& view)
    : half_width_(0.5F * static_cast<float>(view.width)), half_height_(0.5F * static_cast<float>(view.height)) {
  for (std::size_t column = 0; column < 4; ++column) {
    x_[column] = view.clip_from_object[4 * column];
    y_[column] = view.clip_from_object[4 * column + 1];
    z_[column] = view.clip_from_object[4 * column + 2];
    w_[column] = view.clip_from_object[4 * column + 3];
    planes_[0][column] = w_[column] + x_[column];
    planes_[1][column] = w_[column] - x_[column];
    planes_[2][column] = w_[column] + y_[column];
    planes_[3][column] = w_[column] - y_[column];
    planes_[4][column] = w_[column] + z_[column];
    planes_[5][column] = w_[column] - z_[column];
  }
  find_eye();
}

// The eye is the point that the matrix maps to x = y = w = 0. In a parallel projection, the eye is a direction, and z
// determines its sign.
void Camera::find_eye() {
  const std::array<std::array<float, 4>, 3> rows = {x_, y_, w_};
  std::array<double, 4> eye{};
  for (std::size_t k = 0; k < 4; ++k) eye[k] = (k % 2 == 0 ? 1 : -1) * minor(rows, k);
  const double size = std::max({std::fabs(eye[0]), std::fabs(eye[1]), std::fabs(eye[2])});
  parallel_ = w_[0] == 0 && w_[1] == 0 && w_[2] == 0;
  if (parallel_) {
    eye_ = size > 0 ? unit(Vector{static_cast<float>(eye[0] / size), static_cast<float>(eye[1] / size),
                                  static_cast<float>(eye[2] / size)})
                    : Vector{};
    if (dot(Vector{z_[0], z_[1], z_[2]}, eye_) * w_[3] > 0) eye_ = eye_ * -1.0F;
  } else {
    eye_ = {static_cast<float>(eye[0] / eye[3]), static_cast<float>(eye[1] / eye[3]),
            static_cast<float>(eye[2] / eye[3])};
  }
}

bool Camera::is_outside(const Node& node, unsigned& planes) const {
  for (unsigned k = 0; k < 6; ++k) {
    if ((planes >> k & 1) == 0) continue;
    const Plane& plane = planes_[k];
    Vector nearest, farthest;
    const auto choose = [&](float slope_of_axis, float low, float high, float& near, float& far) {
      near = slope_of_axis > 0 ? low : high;
      far = slope_of_axis > 0 ? high : low;
    };
    choose(plane[0], node.low[0], node.high[0], nearest.x, farthest.x);
    choose(plane[1], node.low[1], node.high[1], nearest.y, farthest.y);
    choose(plane[2], node.low[2], node.high[2], nearest.z, farthest.z);
    if (evaluate(plane, farthest) < 0) return true;
    if (evaluate(plane, nearest) >= 0) planes &= ~(1U << k);
  }
  return false;
}

bool Camera::is_back_facing(const Node& node) const {
  if (node.cone_sine >= 1) return false;
  const Vector axis = to_vector(node.cone_axis);
  if (parallel_) return -dot(eye_, axis) > node.cone_sine;
  const Vector away = to_vector(node.cone_apex) - eye_;
  return dot(away, axis) > node.cone_sine * robust_length(away);
}

// A step d from the centre changes x / w by (slope of x - x / w * slope of w) * d, divided by w after the step.
float Camera::projected_diameter(Vector centre, float radius) const {
  const float w = evaluate(w_, centre), least = w - radius * slope(w_);
  if (!(least > 0)) return std::numeric_limits<float>::infinity();
  const auto pixels = [&](const Plane& axis, float half_size) {
    const float projected = evaluate(axis, centre) / w;
    return half_size *
           slope({axis[0] - projected * w_[0], axis[1] - projected * w_[1], axis[2] - projected * w_[2], 0});
  };
  return 2 * radius * std::max(pixels(x_, half_width_), pixels(y_, half_height_)) / least;
}

}  // namespace glark::surfel
