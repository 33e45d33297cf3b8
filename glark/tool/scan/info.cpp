// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glark info FILE: reports the contents of a file, and whether its mesh is closed and manifold.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "glark/tool/scan/commands.h"
#include "glark/tool/scan/files.h"
#include "glark/tool/scan/quality.h"

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

void info(const Files& files, const std::string& reference) {
  const geometry::Geometry geometry = load(files.input, files);
  Report report;
  report["file"] = files.input;
  report.update(contents_of(geometry));
  report["bounding_box"] = bounds_of(geometry);
  if (geometry.origin != std::array<double, 3>{}) report["origin"] = geometry.origin;
  report["topology"] = topology_report(geometry);
  if (!reference.empty()) report["quality"] = quality_report(geometry, reference, files);
  print(report, files.json);
}

}  // namespace

void add_info(CLI::App& app) {
  CLI::App* command = app.add_subcommand("info", "Report the contents of a file of points or triangles");
  const auto files = std::make_shared<Files>();
  const auto reference = std::make_shared<std::string>();
  describe_input(*command, *files);
  describe_measure(*command, *reference);
  command->callback([files, reference] { info(*files, *reference); });
}

}  // namespace glark::tool
