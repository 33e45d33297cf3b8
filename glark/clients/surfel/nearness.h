// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Which places of a plane are near to some points of it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace glark::surfel {

// Bits of a grid that all its distances share. What it says is right to a cell, a thirtieth of the points' extent or of the greatest distance.
class Nearness {
 public:
  using Place = std::array<float, 2>;

  // Of these points, which stay where they are, and distances up to `most`.
  void begin(std::span<const Place> points, float most);
  // Whether a place is that near to one of the points, or to a little more.
  bool is_near(Place place, float distance);

 private:
  static constexpr int cells = 64;  // along either axis
  struct Layer {
    float distance;
    std::array<std::uint64_t, cells> rows;
  };

  const Layer& layer(float distance);
  void stamp(Layer& layer) const;

  std::span<const Place> points_;
  Place low_{}, scale_{};  // of the grid, and cells a unit
  float most_ = 0;
  std::vector<Layer> layers_;
  std::size_t used_ = 0;  // of the layers
  std::size_t latest_ = 0;
};

}  // namespace glark::surfel
