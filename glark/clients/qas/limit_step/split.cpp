// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/qas/limit_step/split.h"

namespace glark::qas {

Topology split(const Topology& topology, const std::vector<Patch>& patches) {
  std::vector<std::uint32_t> triangles, creases;
  triangles.reserve(12 * patches.size());
  for (const Patch& patch : patches) {
    const auto& p = patch.positions;
    triangles.insert(triangles.end(), {p[0], p[3], p[5], p[3], p[1], p[4], p[5], p[4], p[2], p[3], p[4], p[5]});
  }
  for (std::uint32_t e = 0; e < topology.edges.size(); ++e) {
    const Edge& edge = topology.edges[e];
    if (!edge.marked) continue;
    const std::uint32_t middle = topology.vertex_count + e;
    creases.insert(creases.end(), {edge.ends[0], middle, middle, edge.ends[1]});
  }
  return analyse({topology.vertex_count + topology.edges.size(), triangles, creases});
}

std::vector<std::array<std::uint32_t, 2>> parents(const Topology& topology) {
  std::vector<std::array<std::uint32_t, 2>> result;
  result.reserve(topology.vertex_count + topology.edges.size());
  for (std::uint32_t v = 0; v < topology.vertex_count; ++v) result.push_back({v, v});
  for (const Edge& edge : topology.edges) result.push_back(edge.ends);
  return result;
}

}  // namespace glark::qas
