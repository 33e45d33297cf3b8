// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/sample/pass/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace glark::stream {
namespace {

constexpr int most_bits = 10;                                 // a key of a micro-cluster has 3 * 10 bits
constexpr double parts_a_sample = 2.5, clusters_a_part = 4;   // as in vstree::simplify(), and micro-clusters of a part
constexpr std::size_t program_bytes = std::size_t{24} << 20;  // the program itself and its buffers
constexpr double bytes_a_node = 420;                          // of a tree under construction, for each micro-cluster
constexpr double bytes_unfinished = 180;  // of a micro-cluster in a table, with the growth of the table
constexpr double most_clusters = 1 << 16, least_clusters = 256;
constexpr double least_volume = 2.5;  // the dimension of points that fill a volume, or a part of one
constexpr double bytes_a_cube = 256;  // of the first pass: a cube in the tables of all threads

constexpr double bytes_a_cell = 768;  // in the plan, the tree over all cells, the report and the index

// What is left for the pass.
double room_of(std::size_t memory) { return static_cast<double>(memory - std::min(memory / 5 * 3, program_bytes)); }

// Estimates the points of a micro-cluster. Its side is that of a counted cube, halved so often.
class ClusterPoints {
 public:
  explicit ClusterPoints(const Census& census)
      : a_cube_(static_cast<double>(census.points - census.left_out) / static_cast<double>(census.cubes.size())),
        dimension_(census.dimension()) {
    if (dimension_ < least_volume) dimension_ = 2;
  }
  double after(int halvings) const { return std::max(1.0, a_cube_ * std::exp2(-halvings * dimension_)); }

 private:
  double a_cube_, dimension_;
};

}  // namespace

std::size_t most_cubes(std::size_t memory) {
  return std::bit_floor(static_cast<std::size_t>(room_of(memory) / bytes_a_cube));
}

Plan make_plan(const Census& census, const SampleOptions& options) {
  Plan plan;
  plan.lattice = census.lattice;
  plan.by_error = options.target == 0;
  plan.memory = options.memory;
  const auto points = static_cast<double>(census.points - census.left_out);
  const double part =
      std::max(1.0, points / (parts_a_sample * static_cast<double>(std::max<std::size_t>(1, options.target))));
  const ClusterPoints cluster_points(census);
  const int level = static_cast<int>(census.level);
  const auto is_fine = [&](int finer) {
    return plan.by_error ? std::ldexp(census.lattice.side, -finer) <= options.error * census.diagonal()
                         : cluster_points.after(finer + level) <= std::max(1.0, part / clusters_a_part);
  };
  plan.finer = -level;
  while (plan.finer < most_bits - level && !is_fine(plan.finer)) ++plan.finer;
  const double each = cluster_points.after(plan.finer + level);
  if (!plan.by_error) plan.least = static_cast<std::uint32_t>(std::clamp(part / each, 1.0, 1e6));

  const double room = room_of(options.memory);
  plan.open_bytes = static_cast<std::size_t>(0.4 * room);
  const double at_once = std::min(most_clusters, 0.3 * room / static_cast<double>(trees_at_a_time) / bytes_a_node);
  plan.tree_clusters = static_cast<std::size_t>(static_cast<double>(trees_at_a_time) * at_once);
  const auto cells_with = [&](double clusters) {
    return cells_of(census.cubes, {.points = static_cast<std::uint64_t>(std::max(1.0, clusters * each)),
                                   .least_level = census.level,
                                   .most_level = static_cast<unsigned>(most_bits - plan.finer)});
  };
  const auto most_cells = static_cast<std::size_t>(room / bytes_a_cell);
  for (double clusters = at_once; clusters >= least_clusters; clusters /= 2) {
    plan.cells = cells_with(clusters);
    if (plan.cells.size() > most_cells) break;
    const double open = most_open_points(plan.cells) / each;
    if (open * bytes_unfinished <= static_cast<double>(plan.open_bytes)) return plan;
  }
  plan.is_shuffled = true;
  plan.cells = cells_with(at_once);
  if (plan.cells.size() > most_cells)
    throw Error(
        Element::option, 0,
        fmt::format("glark-stream: memory is {} bytes, which {} cells fit into; this sampling needs {}: raise the "
                    "memory, or take fewer samples",
                    options.memory, most_cells, plan.cells.size()));
  return plan;
}

}  // namespace glark::stream
