// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Meshes from clouds whose surface is known: uneven density, outliers, noise.
#include <glark/reconstruct.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "tests/bench_points/groups.h"
#include "tests/bench_points/measure/measure.h"
#include "tests/bench_points/measure/surface_distance.h"
#include "tests/bench_points/peer.h"
#include "tests/shapes/clouds.h"

namespace glark::bench {
namespace {

using shapes::Cloud;
using shapes::CloudOptions;
using shapes::Statue;

constexpr std::size_t samples = 50000;

// The distances between a mesh and the statue, in % of the statue's diagonal.
struct Distances {
  double from_surface = 0, to_surface = 0, greatest = 0;
};

Distances distances_of(const Statue& statue, std::span<const float> positions,
                       std::span<const std::uint32_t> triangles) {
  if (triangles.empty()) return {100, 100, 100};
  const double percent = 100 / statue.diagonal();
  Distances result;
  const std::vector<float> on_mesh = samples_of(positions, triangles, samples);
  for (std::size_t i = 0; i < on_mesh.size(); i += 3) {
    const double off = statue.distance(
        {static_cast<double>(on_mesh[i]), static_cast<double>(on_mesh[i + 1]), static_cast<double>(on_mesh[i + 2])});
    result.to_surface += off * off;
  }
  result.to_surface = std::sqrt(result.to_surface / samples) * percent;
  const SurfaceDistance to_mesh(positions, triangles);
  const Cloud surface = cloud_of(statue, 1, {.samples = samples});
  for (std::size_t i = 0; i < surface.positions.size(); i += 3) {
    const double square =
        to_mesh.squared({static_cast<double>(surface.positions[i]), static_cast<double>(surface.positions[i + 1]),
                         static_cast<double>(surface.positions[i + 2])});
    result.from_surface += square;
    result.greatest = std::max(result.greatest, square);
  }
  result.from_surface = std::sqrt(result.from_surface / samples) * percent;
  result.greatest = std::sqrt(result.greatest) * percent;
  return result;
}

void add_row(const Statue& statue, const std::string& name, double seconds, std::span<const float> positions,
             std::span<const std::uint32_t> triangles, Table& table) {
  const Distances distances = distances_of(statue, positions, triangles);
  const Edges edges = edges_of(triangles);
  table.rows.push_back({name, Number{seconds, 3}, Number{static_cast<double>(triangles.size()) / 3, 0},
                        Number{distances.from_surface, 4}, Number{distances.to_surface, 4},
                        Number{distances.greatest, 3}, Number{static_cast<double>(edges.boundary), 0},
                        Number{static_cast<double>(edges.non_manifold), 0}});
}

void add_rows(const CloudOptions& options, unsigned seed, const std::string& name, bool is_with_peer, int rounds,
              Table& table) {
  const Statue statue(seed);
  const Cloud cloud = cloud_of(statue, seed, options);
  reconstruct::Reconstructed mesh;
  std::vector<Work> works{{name, [&] {
                             mesh = reconstruct::reconstruct({.positions = cloud.positions, .normals = cloud.normals},
                                                             {.threads = 1});
                           }}};
  take_turns(works, rounds);
  add_row(statue, name, works[0].cpu_seconds, mesh.positions, mesh.triangles, table);
  if (!is_with_peer) return;
  const auto front = peer("front", name, cloud.positions, 1);
  if (front)
    add_row(statue, name + ", advancing front", front->work.cpu_seconds, cloud.positions, front->triangles, table);
}

std::string percent(double share) {
  std::string text = std::to_string(100 * share);
  return text.substr(0, text.find('.') + 2) + " %";
}

const std::vector<std::string> columns{
    "",          "CPU s",    "triangles",      "RMS from the surface, % of the diagonal",
    "RMS to it", "greatest", "boundary edges", "non-manifold edges"};

}  // namespace

std::vector<Table> generated_cloud_tables(const Settings& settings) {
  const int rounds = std::min(settings.rounds, 3);
  Table density{"Density that varies over a statue, 100000 samples", columns, {}};
  for (const double ratio : {1.0, 10.0, 100.0, 1000.0}) {
    for (const unsigned seed : {1U, 2U})
      add_rows({.density_ratio = ratio}, seed,
               std::to_string(std::lround(ratio)) + ":1, statue " + std::to_string(seed), true, rounds, density);
  }
  Table outliers{"Outliers and noise, 100000 samples of a statue", columns, {}};
  for (const double noise : {0.0, 0.001, 0.002, 0.003}) {
    for (const double share : {0.0, 0.01, 0.05, 0.2}) {
      const Statue statue(3);
      add_rows({.noise = noise * statue.diagonal(), .outliers = share}, 3,
               "noise " + percent(noise) + ", outliers " + percent(share), false, rounds, outliers);
    }
  }
  return {density, outliers};
}

}  // namespace glark::bench
