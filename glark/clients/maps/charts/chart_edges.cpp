// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/charts/chart_edges.h"

namespace glark::maps {

ChartEdges::ChartEdges(const Surface& surface, const std::vector<Chart>& charts)
    : surface_(surface), charts_(charts), chart_of_(surface.triangles.size(), none) {
  for (std::uint32_t c = 0; c < charts.size(); ++c)
    for (const std::uint32_t t : charts[c].triangles) chart_of_[t] = c;
}

bool ChartEdges::is_seam(std::uint32_t triangle, std::size_t edge) const {
  const std::uint32_t other = surface_.neighbours[triangle][edge];
  if (chart_of_[triangle] != chart_of_[other]) return true;
  const Chart& chart = charts_[chart_of_[triangle]];
  if (!chart.is_own) return false;  // a vertex has one place in the plane of projection
  for (const std::size_t k : {edge, (edge + 1) % 3}) {
    const std::uint32_t vertex = surface_.triangles[triangle][k];
    if (wedge_at(chart, triangle, k) != wedge_at(chart, other, corner_at(surface_, other, vertex))) return true;
  }
  return false;
}

}  // namespace glark::maps
