// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>

#include "glark/clients/common/vector.h"

namespace glark::edit {

inline double radians(double degrees) { return degrees * (std::numbers::pi / 180); }

// Turns a vector about a unit axis. Source: O. Rodrigues, 1840.
inline common::Vector3d rotated(const common::Vector3d& v, const common::Vector3d& axis, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return v * c + common::cross(axis, v) * s + axis * (common::dot(axis, v) * (1 - c));
}

}  // namespace glark::edit
