// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/sample/pass/plan.h"

#include <algorithm>

namespace glark::stream {
namespace {

constexpr unsigned most_bits = 10;                            // a key of a micro-cluster has 3 * 10 bits
constexpr double parts_a_sample = 2.5, clusters_a_part = 4;   // as in vstree::simplify(), and micro-clusters of a part
constexpr std::size_t program_bytes = std::size_t{24} << 20;  // the program itself and its buffers
constexpr double bytes_a_node = 420;                          // of a tree under construction, for each micro-cluster
constexpr double bytes_unfinished = 180;  // of a micro-cluster in a table, with the growth of the table
constexpr double most_clusters = 1 << 16, least_clusters = 256;

// The micro-clusters that the points of an occupied cube make.
double points_a_cluster(const Census& census, unsigned finer) {
  const double a_cube = static_cast<double>(census.points - census.left_out) / static_cast<double>(census.cubes.size());
  return std::max(1.0, std::ldexp(a_cube, -2 * static_cast<int>(finer)));
}

}  // namespace

Plan make_plan(const Census& census, const SampleOptions& options) {
  Plan plan;
  plan.lattice = census.lattice;
  plan.by_error = options.target == 0;
  plan.memory = options.memory;
  const auto points = static_cast<double>(census.points - census.left_out);
  const double part =
      std::max(1.0, points / (parts_a_sample * static_cast<double>(std::max<std::size_t>(1, options.target))));
  const auto is_fine = [&](unsigned finer) {
    return plan.by_error
               ? std::ldexp(census.lattice.side, -static_cast<int>(finer)) <= options.error * census.diagonal()
               : points_a_cluster(census, finer) <= std::max(1.0, part / clusters_a_part);
  };
  while (plan.finer < most_bits && !is_fine(plan.finer)) ++plan.finer;
  const double each = points_a_cluster(census, plan.finer);
  if (!plan.by_error) plan.least = static_cast<std::uint32_t>(std::clamp(part / each, 1.0, 1e6));

  const auto room = static_cast<double>(options.memory - std::min(options.memory / 5 * 3, program_bytes));
  plan.open_bytes = static_cast<std::size_t>(0.4 * room);
  const double at_once = std::min(most_clusters, 0.3 * room / static_cast<double>(trees_at_a_time) / bytes_a_node);
  const auto cells_with = [&](double clusters) {
    return cells_of(census.cubes, static_cast<std::uint64_t>(std::max(1.0, clusters * each)), most_bits - plan.finer);
  };
  for (double clusters = at_once; clusters >= least_clusters; clusters /= 2) {
    plan.cells = cells_with(clusters);
    const double open = most_open_points(plan.cells) / each;
    if (open * bytes_unfinished <= static_cast<double>(plan.open_bytes)) return plan;
  }
  plan.is_shuffled = true;
  plan.cells = cells_with(at_once);
  return plan;
}

}  // namespace glark::stream
