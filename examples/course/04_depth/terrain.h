// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

// A coarse terrain of 2 * 10 * 10 triangles around a peak. The y axis points up.
struct Terrain {
  static constexpr unsigned side = 10;

  std::vector<float> positions, normals;  // three for each vertex
  std::vector<unsigned> triangles;        // three for each triangle

  Terrain() {
    for (unsigned j = 0; j <= side; ++j) {
      for (unsigned i = 0; i <= side; ++i) {
        const float x = 8.0F * static_cast<float>(i) / side - 4;
        const float z = 8.0F * static_cast<float>(j) / side - 4;
        const float step = 0.01F;
        const float dx = (height(x + step, z) - height(x - step, z)) / (2 * step);
        const float dz = (height(x, z + step) - height(x, z - step)) / (2 * step);
        const float length = std::hypot(dx, 1.0F, dz);
        positions.insert(positions.end(), {x, height(x, z), z});
        normals.insert(normals.end(), {-dx / length, 1 / length, -dz / length});
        const unsigned at = j * (side + 1) + i;
        if (i < side && j < side)
          triangles.insert(triangles.end(), {at, at + side + 2, at + 1, at, at + side + 1, at + side + 2});
      }
    }
  }

  std::size_t vertices() const { return positions.size() / 3; }

  static float height(float x, float z) {
    return 0.4F * std::sin(1.3F * x + 0.4F) * std::cos(1.1F * z) + 1.5F * std::exp(-1.2F * (x * x + z * z));
  }
};

// Whether each tag is the wanted one less a number that is the same for all; tags below 0 count as 0.
inline bool lowered_alike(const std::vector<float>& tags, const std::vector<float>& wanted) {
  const auto finest = static_cast<std::size_t>(std::max_element(wanted.begin(), wanted.end()) - wanted.begin());
  const float less = wanted[finest] - tags[finest];
  for (std::size_t i = 0; i < tags.size(); ++i)
    if (std::abs(std::max(wanted[i] - less, 0.0F) - std::max(tags[i], 0.0F)) > 0.01F) return false;
  return true;
}
