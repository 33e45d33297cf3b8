// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A temporary folder for the files of each test, and small geometry for them.
#pragma once

#include <cmath>
#include <random>

#include "glark/clients/geometry/formats.h"
#include "tests/common/temporary_folder.h"

namespace glark::geometry {

class TemporaryFolder : public test::TemporaryFolder {
 protected:
  // Returns the error message of the read, or an empty text if the file can be read.
  static std::string problem_with(const std::filesystem::path& file, const ReadOptions& options = {}) {
    try {
      read_file(file, options);
    } catch (const Error& error) {
      return error.what();
    }
    return {};
  }
};

// Points on a grid with a bit of noise, with the given attributes.
struct Shape {
  bool normals = false;
  bool colours = false;
  bool texture_coordinates = false;
  bool triangles = false;
};

inline Geometry random_geometry(unsigned seed, const Shape& shape) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> noise(-1, 1);
  constexpr std::uint32_t side = 7;
  Geometry geometry;
  for (std::uint32_t i = 0; i < side * side; ++i) {
    const std::uint32_t row = i / side;
    const float x = static_cast<float>(i % side);
    const auto y = static_cast<float>(row);
    geometry.positions.insert(geometry.positions.end(),
                              {x + 0.3F * noise(random), y + 0.3F * noise(random), 1e-3F * noise(random)});
    if (shape.normals) {
      const float slope = 0.6F * noise(random);
      geometry.normals.insert(geometry.normals.end(), {slope, 0, std::sqrt(1 - slope * slope)});
    }
    if (shape.colours)
      for (int k = 0; k < 4; ++k) geometry.colours.push_back(k == 3 ? 255 : static_cast<std::uint8_t>(random() & 255U));
    if (shape.texture_coordinates)
      geometry.texture_coordinates.insert(geometry.texture_coordinates.end(), {x / side, y / side});
  }
  for (std::uint32_t i = 0; shape.triangles && i < side * side; ++i) {
    if (i % side == side - 1 || i / side == side - 1) continue;
    geometry.triangles.insert(geometry.triangles.end(), {i, i + 1, i + side, i + 1, i + side + 1, i + side});
  }
  return geometry;
}

}  // namespace glark::geometry
