// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glark/c/types.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace glark::test {

inline const std::vector<float> octahedron = {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1};
inline const std::vector<std::uint32_t> octahedron_triangles = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4,
                                                                2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};

// Points that lie evenly on the unit sphere; each is its own normal.
inline std::vector<float> sphere(int count) {
  std::vector<float> positions;
  for (int i = 0; i < count; ++i) {
    const float z = 1 - (2 * static_cast<float>(i) + 1) / static_cast<float>(count);
    const float radius = std::sqrt(1 - z * z);
    const float turn = 2.39996323F * static_cast<float>(i);
    positions.insert(positions.end(), {radius * std::cos(turn), radius * std::sin(turn), z});
  }
  return positions;
}

inline glark_floats array(const std::vector<float>& values) { return {values.data(), values.size()}; }
inline glark_indices array(const std::vector<std::uint32_t>& values) { return {values.data(), values.size()}; }
inline glark_float_output output(std::vector<float>& values) { return {values.data(), values.size()}; }

inline std::vector<float> copy(glark_floats values) { return {values.data, values.data + values.count}; }
inline std::vector<std::uint32_t> copy(glark_indices values) { return {values.data, values.data + values.count}; }
inline std::vector<std::uint8_t> copy(glark_bytes values) { return {values.data, values.data + values.count}; }

inline bool contains(const glark_error& error, const char* text) {
  return std::string(error.message).find(text) != std::string::npos;
}

}  // namespace glark::test
