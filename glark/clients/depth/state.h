// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The mesh of a Tagger, and preallocated arrays for its computations.
#pragma once

#include <glark/depth.h>

#include <vector>

#include "glark/clients/common/vector.h"
#include "glark/clients/depth/curvature_tensors.h"

namespace glark::depth {

struct Tagger::State {
  State(std::size_t vertices, std::span<const std::uint32_t> given)
      : triangles(given.begin(), given.end()),
        longest(vertices),
        areas(vertices),
        curvature(vertices, given.size() / 3) {}

  // The vertex after corner i in its triangle.
  std::uint32_t after(std::size_t i) const { return triangles[i % 3 == 2 ? i - 2 : i + 1]; }
  // Sets `longest` to the longest edge at each vertex.
  void measure_rings(std::span<const float> positions);

  std::vector<std::uint32_t> triangles;
  std::vector<float> longest;  // a length, or a sum, for each vertex
  std::vector<float> areas;    // for each vertex
  CurvatureTensors curvature;
};

}  // namespace glark::depth
