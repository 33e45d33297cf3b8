// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "glark/clients/maps/charts/chart.h"

namespace glark::maps {

// Knows which edges of the mesh are seams of the maps. Keeps references to its arguments.
class ChartEdges {
 public:
  ChartEdges(const Surface& surface, const std::vector<Chart>& charts);

  std::uint32_t chart_of(std::uint32_t triangle) const { return chart_of_[triangle]; }
  // Whether the triangle and its neighbour across an edge have different places there. The edge has a neighbour.
  bool is_seam(std::uint32_t triangle, std::size_t edge) const;

 private:
  const Surface& surface_;
  const std::vector<Chart>& charts_;
  std::vector<std::uint32_t> chart_of_;
};

}  // namespace glark::maps
