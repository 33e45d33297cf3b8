// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Table 5.1 of the thesis: the rows of `glark-bench --filter surfel/`, a program in the same folder, and the number of
// indices of meshoptimizer's strips for the same triangles.
#include <glark/surfel.h>
#include <meshoptimizer.h>
#include <unistd.h>

#include <algorithm>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tests/bench_points/groups.h"
#include "tests/bench_points/measure/scan.h"

namespace glark::bench {
namespace {

std::string quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

// Returns the triangles of each strip as a list.
std::vector<std::vector<std::uint32_t>> patches_of(const surfel::Strips& strips) {
  std::vector<std::vector<std::uint32_t>> patches;
  for (const surfel::Node& node : strips.nodes()) {
    if (node.left != surfel::none || node.count == 0) continue;
    const auto strip = strips.indices().subspan(node.first, node.count);
    std::vector<std::uint32_t>& triangles = patches.emplace_back();
    for (std::size_t i = 0; i + 2 < strip.size(); ++i) {
      const std::uint32_t a = strip[i + i % 2], b = strip[i + 1 - i % 2], c = strip[i + 2];
      if (a != b && b != c && c != a) triangles.insert(triangles.end(), {a, b, c});
    }
  }
  return patches;
}

std::size_t meshoptimizer_indices(const std::vector<std::uint32_t>& triangles, std::size_t points,
                                  std::uint32_t restart) {
  std::vector<std::uint32_t> sorted(triangles.size()), strip(meshopt_stripifyBound(triangles.size()));
  meshopt_optimizeVertexCacheStrip(sorted.data(), triangles.data(), triangles.size(), points);
  return meshopt_stripify(strip.data(), sorted.data(), sorted.size(), points, restart);
}

std::vector<Cell> indices_of(const std::string& name, const Scan& scan) {
  const surfel::Cloud cloud{scan.positions, scan.normals};
  const surfel::Strips turned(cloud), as_triangulated(cloud, {.turn_edges = false});
  const auto patches = patches_of(as_triangulated);
  std::vector<std::uint32_t> all;
  std::size_t in_patches = 0;
  constexpr std::uint32_t restart = 0xFFFFFFFFU;
  const std::size_t points = scan.positions.size() / 3;
  for (const std::vector<std::uint32_t>& patch : patches) {
    all.insert(all.end(), patch.begin(), patch.end());
    in_patches += meshoptimizer_indices(patch, points, 0);
  }
  const auto ratio = [](std::size_t indices, std::size_t triangles) {
    return Number{static_cast<double>(indices) / static_cast<double>(std::max<std::size_t>(triangles, 1)), 3};
  };
  const std::size_t triangles = all.size() / 3;
  return {name,
          Number{static_cast<double>(triangles), 0},
          ratio(turned.indices().size(), turned.counts().valid),
          ratio(as_triangulated.indices().size(), as_triangulated.counts().valid),
          ratio(in_patches, triangles),
          ratio(meshoptimizer_indices(all, points, 0), triangles),
          ratio(meshoptimizer_indices(all, points, restart), triangles)};
}

Table indices_table(const Settings& settings) {
  Table table{"Indices a triangle",
              {"", "triangles", "strips", "the same, edges as triangulated", "meshoptimizer, each patch",
               "meshoptimizer, all in one strip", "the same with restart indices"},
              {}};
  for (const std::string name : {"igea", "horse", "bunny", "armadillo", "nefertiti", "bunny_scans"})
    table.rows.push_back(indices_of(name, read_scan(settings.data, name)));
  table.note =
      "meshoptimizer's columns use the same triangles as the column before them. One strip over all triangles cannot "
      "be "
      "culled or updated in parts.";
  return table;
}

Table stripping_table(const Settings& settings) {
  namespace fs = std::filesystem;
  const fs::path program = fs::read_symlink("/proc/self/exe").parent_path() / "glark-bench";
  if (!fs::exists(program)) throw std::runtime_error(program.string() + " is missing; build it");
  const fs::path file = fs::temp_directory_path() / ("glark-bench-points." + std::to_string(getpid()) + ".json");
  const std::string command = quoted(program) + " --filter surfel/ --json " + quoted(file) +
                              (settings.rounds < 5 ? " --quick" : "") + " >/dev/null 2>&1";
  const int status = std::system(command.c_str());  // not 0 either if a target is missed
  std::ifstream in(file);
  const nlohmann::json report = nlohmann::json::parse(in, nullptr, false);
  in.close();
  fs::remove(file);
  if (report.is_discarded()) throw std::runtime_error(command + " gave no report but status " + std::to_string(status));
  Table table{"Surfel strips, on one core", {"", "measured", "unit", "target", "thesis"}, {}};
  for (const nlohmann::json& row : report.at("rows")) {
    table.rows.push_back(
        {row.at("measure").get<std::string>(), Number{row.at("measured").get<double>(), 2},
         row.at("unit").get<std::string>(),
         row.value("target", nlohmann::json()).is_number() ? Cell{Number{row.at("target").get<double>(), 1}} : Cell{},
         row.value("best_known", std::string())});
  }
  table.note =
      "Table 5.1 of the thesis, preprocessing: face, 40881 points, 2 s; David, 258332, 12 s; Buddha, 543654, 26 s; "
      "Asian "
      "dragon, 3609601, 131 s: .020 to .028 M points/s.";
  return table;
}

}  // namespace

std::vector<Table> surfel_tables(const Settings& settings) {
  return {stripping_table(settings), indices_table(settings)};
}

}  // namespace glark::bench
