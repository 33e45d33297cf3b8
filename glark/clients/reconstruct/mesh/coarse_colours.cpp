// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/reconstruct/mesh/coarse_colours.h"

namespace glark::reconstruct {
namespace {

constexpr std::size_t grain = 1024;
constexpr float reach = 0.7F;  // the radius around a vertex for its colour, in sides of the finest cells

// Gives a vertex without colour the mean colour of its neighbours. The fourth float is 1 for vertices with a colour.
// Returns whether any vertex got a colour.
bool spread(const std::vector<std::uint32_t>& triangles, std::vector<Float4>& colours) {
  std::vector<Float4> sums(colours.size());
  for (std::size_t t = 0; t < triangles.size(); t += 3) {
    const Float4 sum = colours[triangles[t]] + colours[triangles[t + 1]] + colours[triangles[t + 2]];
    for (std::size_t i = t; i < t + 3; ++i) sums[triangles[i]] += sum;
  }
  bool any = false;
  for (std::size_t i = 0; i < colours.size(); ++i) {
    if (colours[i][3] > 0 || !(sums[i][3] > 0)) continue;
    colours[i] = sums[i] / sums[i][3];
    any = true;
  }
  return any;
}

}  // namespace

std::vector<Float4> coarse_colours(const std::vector<Float4>& points, const std::vector<Float4>& normals,
                                   const std::vector<std::uint32_t>& triangles, const Octree& octree,
                                   const Workers& workers) {
  std::vector<Float4> colours(points.size());
  workers.each(points.size(), grain, [&](std::size_t begin, std::size_t end) {
    LocalSurface surface(octree);
    for (std::size_t i = begin; i < end; ++i) {
      const LocalEstimate estimate = surface.near(points[i], normals[i], reach * octree.finest().side());
      if (!estimate.found) continue;
      colours[i] = estimate.colour;
      colours[i][3] = 1;
    }
  });
  while (spread(triangles, colours)) {
  }
  return colours;
}

}  // namespace glark::reconstruct
