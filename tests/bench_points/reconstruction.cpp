// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Meshes from points: table 3.2 of the thesis.
#include <glark/reconstruct.h>

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "tests/bench_points/groups.h"
#include "tests/bench_points/measure/measure.h"
#include "tests/bench_points/measure/scan.h"
#include "tests/bench_points/measure/surface_distance.h"
#include "tests/bench_points/peer.h"

namespace glark::bench {
namespace {

struct Kind {
  const char* name;
  vstree::ReconstructOptions options;
};

// For a model with triangles, returns the distances both ways. For raw scans, returns only the distance from the points
// to the mesh, which includes their noise.
std::vector<Cell> distances(const Scan& scan, std::span<const float> positions,
                            std::span<const std::uint32_t> triangles) {
  constexpr std::size_t samples = 100000, stride = 50;
  const double percent = 100 / diagonal_of(scan.positions);
  const SurfaceDistance to_mesh(positions, triangles);
  if (scan.triangles.empty()) {
    std::vector<float> some;
    for (std::size_t i = 0; i < scan.positions.size(); i += 3 * stride)
      some.insert(some.end(), &scan.positions[i], &scan.positions[i] + 3);
    return {{}, Number{to_mesh.rms(some) * percent, 4}};
  }
  const SurfaceDistance to_scan(scan.positions, scan.triangles);
  return {Number{to_scan.rms(samples_of(positions, triangles, samples)) * percent, 4},
          Number{to_mesh.rms(samples_of(scan.positions, scan.triangles, samples)) * percent, 4}};
}

std::vector<Cell> row_of(const Scan& scan, const Work& work, std::span<const float> positions,
                         std::span<const std::uint32_t> triangles) {
  const auto points = static_cast<double>(scan.positions.size()) / 3;
  const Edges edges = edges_of(triangles);
  std::vector<Cell> row{work.name,
                        Number{points, 0},
                        Number{work.cpu_seconds, 3},
                        Number{points / work.cpu_seconds * 1e-6, 2},
                        work.peak_bytes ? Cell{Number{*work.peak_bytes / points, 0}} : Cell{},
                        Number{static_cast<double>(triangles.size()) / 3, 0},
                        Number{static_cast<double>(edges.boundary), 0},
                        Number{static_cast<double>(edges.non_manifold), 0}};
  const std::vector<Cell> rms = distances(scan, positions, triangles);
  row.insert(row.end(), rms.begin(), rms.end());
  return row;
}

// The peer needs minutes for raw scans, so it only runs if `is_with_peer` is true.
void add_rows(const Settings& settings, const char* name, bool is_with_peer, Table& table) {
  const Scan scan = read_scan(settings.data, name);
  constexpr std::array<Kind, 2> kinds{{{"", {.threads = 1}}, {", once refined", {.levels = 1, .threads = 1}}}};
  std::array<vstree::Reconstructed, 2> meshes;
  std::vector<Work> works;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    works.push_back({std::string(name) + kinds[i].name, [&, i] {
                       meshes[i] = glark::reconstruct::reconstruct(
                           {.positions = scan.positions, .normals = scan.normals}, kinds[i].options);
                     }});
  }
  take_turns(works, settings.rounds);
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (i > 0 && meshes[i].levels == meshes[0].levels) continue;
    table.rows.push_back(row_of(scan, works[i], meshes[i].positions, meshes[i].triangles));
  }
  if (is_with_peer) {
    const auto front = peer("front", std::string(name) + ", CGAL's advancing front", scan.positions, 2);
    if (front) table.rows.push_back(row_of(scan, front->work, scan.positions, front->triangles));
  }
}

}  // namespace

std::vector<Table> reconstruction_tables(const Settings& settings) {
  Table table{"Reconstruction, one thread",
              {"", "points", "CPU s", "M points/s", "peak B a point", "triangles", "boundary edges",
               "non-manifold edges", "RMS to the model, % of the diagonal", "RMS from it"},
              {}};
  for (const char* name : {"igea", "horse", "armadillo", "nefertiti", "bunny", "bunny_scans", "happy_stand_scans"})
    add_rows(settings, name, std::string_view(name) == "igea", table);
  table.note =
      "Table 3.2 of the thesis: bunny, 35949 points, .85 s; igea, 134346, 1.81 s; dragon, 437647, 5.40 s; happy "
      "Buddha, 543652, 6.38 s. Of a raw scan RMS is from its points, with their noise.";
  return {table};
}

}  // namespace glark::bench
