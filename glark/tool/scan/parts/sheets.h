// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The triangles of a coarse mesh, counted. Two with the same corners and opposite sides are a fold; both go.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace glark::tool {

// Triangles with the same corners: how many more have this orientation than the other one.
struct Sheet {
  std::array<std::uint32_t, 3> corners;  // ascending
  std::int32_t count;
};

class Sheets {
 public:
  // samples: the points that triangles connect.
  explicit Sheets(std::size_t samples);

  // Adds a triangle of samples. It is left out if two corners are the same, or if one is SampleSearch::no_sample.
  void add(std::array<std::uint32_t, 3> samples);
  // Adds sheets that were counted elsewhere. The order of all calls makes no difference to the result.
  void add(std::span<const Sheet> sheets);
  // All sheets, each once, in the order of their corners.
  std::span<const Sheet> merged();
  // Returns the triangles as indices of samples, three each.
  std::vector<std::uint32_t> take_triangles();

 private:
  void merge();

  std::vector<Sheet> sheets_;
  std::size_t next_cleaning_;
};

}  // namespace glark::tool
