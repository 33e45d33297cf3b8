// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glark info FILE: reports the contents of a file, and whether its mesh is closed and manifold.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

#include "glark/tool/scan/commands.h"
#include "glark/tool/scan/files.h"
#include "glark/tool/scan/info/contents.h"
#include "glark/tool/scan/quality.h"
#include "glark/tool/scan/validators.h"

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

CLI::Validator at_least_32_mb() {
  return {[](std::string& text) -> std::string {
            std::uint64_t bytes = 0;
            const bool is_enough = CLI::detail::lexical_cast(text, bytes) && bytes >= (std::uint64_t{32} << 20);
            return is_enough ? "" : text + " bytes are less than 32MB, which reading a file in parts may take";
          },
          ""};
}

void info_in_parts(const Files& files, const std::string& reference) {
  if (!reference.empty())
    throw std::runtime_error(files.input +
                             ": --measure keeps the whole file in the memory; give enough with --memory, and a format "
                             "that is read as a whole (PLY, OBJ, STL, XYZ ...)");
  const Report report = contents_in_parts(files);
  warn(files.input + ": read in parts; what needs the whole file in the memory (topology) is not reported");
  print(report, files.json);
}

void info(const Files& files, const Memory& memory, const std::string& reference) {
  // Without a given memory, a file that is measured is read as a whole.
  constexpr auto unlimited = std::numeric_limits<std::uint64_t>::max();
  const bool is_unlimited = !reference.empty() && !memory.is_given;
  if (must_read_in_parts(files, is_unlimited ? Memory{unlimited} : memory)) return info_in_parts(files, reference);
  const geometry::Geometry geometry = load(files.input, files, false, true);
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
  describe_input(*command, *files, {"las", "raw"});
  describe_measure(*command, *reference);
  const auto memory = std::make_shared<Memory>();
  CLI::Option* option =
      command
          ->add_option("--memory", memory->bytes,
                       "The most memory, as 64MB or 4GB, 32MB or more; default 256MB. Larger files are read in parts, "
                       "and their topology is not reported")
          ->transform(bytes_above_zero())
          ->check(at_least_32_mb())
          ->type_name("BYTES");
  command->callback([files, memory, reference, option] {
    memory->is_given = option->count() > 0;
    info(*files, *memory, *reference);
  });
}

}  // namespace glark::tool
