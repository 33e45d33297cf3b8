// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Reduces meshes to a tenth of their triangles, and compares with meshoptimizer.
#include <glark/vstree.h>
#include <meshoptimizer.h>

#include "tests/bench_points/groups.h"
#include "tests/bench_points/measure/measure.h"
#include "tests/bench_points/measure/scan.h"
#include "tests/bench_points/measure/surface_distance.h"

namespace glark::bench {
namespace {

struct Result {
  std::vector<float> positions;
  std::vector<std::uint32_t> triangles;
};

void add_quality(std::vector<Cell>& row, const Result& result, const Scan& scan, const std::vector<float>& samples) {
  const double diagonal = diagonal_of(scan.positions);
  const double there = SurfaceDistance(result.positions, result.triangles).rms(samples) / diagonal * 100;
  const double back = SurfaceDistance(scan.positions, scan.triangles)
                          .rms(samples_of(result.positions, result.triangles, samples.size() / 3)) /
                      diagonal * 100;
  const Edges edges = edges_of(result.triangles);
  row.emplace_back(Number{static_cast<double>(result.triangles.size()) / 3, 0});
  row.emplace_back(Number{there, 4});
  row.emplace_back(Number{back, 4});
  row.emplace_back(Number{static_cast<double>(edges.non_manifold), 0});
  row.emplace_back(Number{static_cast<double>(edges.boundary), 0});
}

// Work i writes to results[i].
std::vector<Work> works_of(const Scan& scan, std::size_t target, std::vector<Result>& results) {
  std::vector<Work> works;
  const auto peer = [&](const char* name, const auto& call) {
    works.push_back({name, [&scan, &result = results[works.size()], call] {
                       result.positions = scan.positions;
                       result.triangles.resize(scan.triangles.size());
                       result.triangles.resize(call(result.triangles.data()));
                     }});
  };
  const std::size_t points = scan.positions.size() / 3;
  peer("meshoptimizer sloppy", [&scan, target, points](std::uint32_t* to) {
    return meshopt_simplifySloppy(to, scan.triangles.data(), scan.triangles.size(), scan.positions.data(), points, 12,
                                  3 * target, 1, nullptr);
  });
  peer("meshoptimizer simplify", [&scan, target, points](std::uint32_t* to) {
    return meshopt_simplify(to, scan.triangles.data(), scan.triangles.size(), scan.positions.data(), points, 12,
                            3 * target, 1, 0, nullptr);
  });
  const auto ours = [&](const char* name, const vstree::SimplifyOptions& options) {
    works.push_back({name, [&scan, &result = results[works.size()], options] {
                       vstree::Simplified few = vstree::simplify(
                           {{.positions = scan.positions, .normals = scan.normals}, scan.triangles}, options);
                       result = {std::move(few.positions), std::move(few.triangles)};
                     }});
  };
  using vstree::Clustering, vstree::Representative;
  ours("volume-surface tree", {.target = target, .threads = 1});
  ours("the same, 2 threads", {.target = target, .threads = 2});
  ours("the same, centroids", {.representative = Representative::centroid, .target = target, .threads = 1});
  ours("octree", {.clustering = Clustering::octree, .target = target, .threads = 1});
  ours("grid", {.clustering = Clustering::grid, .target = target, .threads = 1});
  return works;
}

Table simplification_of(const Settings& settings, const std::string& name, std::size_t target) {
  const Scan scan = read_scan(settings.data, name);
  std::vector<Result> results(7);
  std::vector<Work> works = works_of(scan, target, results);
  take_turns(works, settings.rounds);
  Table table{name + ", " + std::to_string(scan.triangles.size() / 3) + " triangles, to " + std::to_string(target),
              cost_columns,
              {}};
  for (const char* column :
       {"triangles", "RMS from the original, % of the diagonal", "RMS to it", "non-manifold edges", "boundary edges"})
    table.columns.emplace_back(column);
  const std::vector<float> samples = samples_of(scan.positions, scan.triangles, 200000);
  for (std::size_t i = 0; i < works.size(); ++i) {
    table.rows.push_back(costs_of(works[i], works[0], static_cast<double>(scan.positions.size()) / 3));
    add_quality(table.rows.back(), results[i], scan, samples);
  }
  return table;
}

}  // namespace

std::vector<Table> simplification_tables(const Settings& settings) {
  return {simplification_of(settings, "igea", 25700), simplification_of(settings, "armadillo", 8600),
          simplification_of(settings, "bunny", 7000)};
}

}  // namespace glark::bench
