// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/scan/simplify/connections.h"

#include <fmt/format.h>

#include "glark/clients/geometry/measure/topology.h"

namespace glark::tool {

Report connections_report(const geometry::Geometry& before, const geometry::Geometry& after,
                          const std::string& output) {
  const std::size_t parts = geometry::component_count(before);
  const geometry::Connections now = geometry::connections_of(after);
  // Counting the edges of the input takes longer than the rest, and most results have no such edges.
  const std::size_t edges = now.non_manifold_edges > 0 ? geometry::connections_of(before).non_manifold_edges : 0;
  const std::size_t more_edges = now.non_manifold_edges > edges ? now.non_manifold_edges - edges : 0;
  if (now.components != parts)
    warn(fmt::format("{}: {} connected part{} became {}", output, parts, parts == 1 ? "" : "s", now.components));
  if (more_edges > 0)
    warn(fmt::format("{}: edges of more than two triangles: {}; the input has {}", output, now.non_manifold_edges,
                     edges));
  Report report;
  report["parts_before"] = parts;
  report["parts_after"] = now.components;
  report["non_manifold_edges_added"] = more_edges;
  return report;
}

}  // namespace glark::tool
