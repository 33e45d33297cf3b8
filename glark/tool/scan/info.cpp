// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glark info FILE: what is in it, and whether the mesh is closed and manifold.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "glark/clients/geometry/topology.h"
#include "glark/tool/scan/commands.h"
#include "glark/tool/scan/files.h"

namespace glark::tool {
namespace {

Report bounds_of(const geometry::Geometry& geometry) {
  std::array<double, 3> low{};
  std::array<double, 3> high{};
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < geometry.positions.size(); ++i) {
    const double coordinate = geometry.origin[i % 3] + static_cast<double>(geometry.positions[i]);
    low[i % 3] = std::min(low[i % 3], coordinate);
    high[i % 3] = std::max(high[i % 3], coordinate);
  }
  Report report;
  report["low"] = low;
  report["high"] = high;
  report["diagonal"] = std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
  return report;
}

Report topology_report(const geometry::Geometry& geometry) {
  const geometry::Topology topology = geometry::topology_of(geometry);
  Report report;
  report["points_at_the_place_of_another"] = geometry.point_count() - topology.places;
  if (geometry.triangles.empty()) return report;
  report["points_without_triangles"] = topology.unused_points;
  report["degenerate_triangles"] = topology.degenerate_triangles;
  report["boundary_edges"] = topology.boundary_edges;
  report["non_manifold_edges"] = topology.non_manifold_edges;
  report["components"] = topology.components;
  report["triangles_of_the_largest"] = topology.largest_component;
  report["closed"] = topology.boundary_edges == 0 && topology.non_manifold_edges == 0;
  return report;
}

void info(const Files& files) {
  const geometry::Geometry geometry = load(files.input, files);
  Report report;
  report["file"] = files.input;
  report.update(contents_of(geometry));
  report["bounding_box"] = bounds_of(geometry);
  if (geometry.origin != std::array<double, 3>{}) report["origin"] = geometry.origin;
  report["topology"] = topology_report(geometry);
  print(report, files.json);
}

}  // namespace

void add_info(CLI::App& app) {
  CLI::App* command = app.add_subcommand("info", "Say what a file of points or triangles has");
  const auto files = std::make_shared<Files>();
  describe_input(*command, *files);
  command->callback([files] { info(*files); });
}

}  // namespace glark::tool
