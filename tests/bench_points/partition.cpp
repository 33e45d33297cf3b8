// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Compares trees over samples with octrees and kd-trees: table 3.1 of the thesis.
#include <glark/vstree.h>

#include <algorithm>
#include <array>
#include <nanoflann.hpp>

#include "tests/bench_points/groups.h"
#include "tests/bench_points/measure/measure.h"
#include "tests/bench_points/measure/scan.h"
#include "tests/bench_points/peer.h"

namespace glark::bench {
namespace {

struct Cloud {
  const std::vector<float>& positions;
  std::size_t kdtree_get_point_count() const { return positions.size() / 3; }
  float kdtree_get_pt(std::size_t i, std::size_t k) const { return positions[3 * i + k]; }
  template <typename Box>
  bool kdtree_get_bbox(Box& /*box*/) const {
    return false;
  }
};

// The numbers of leaves and bytes of a tree that a work builds.
struct TreeSize {
  double leaves = 0, bytes = 0;
};

void add_row(const Work& work, const Work& reference, double points, const TreeSize* tree, double octree_leaves,
             Table& table) {
  std::vector<Cell> row = costs_of(work, reference, points);
  if (tree != nullptr) {
    row.emplace_back(Number{tree->leaves, 0});
    row.emplace_back(Number{tree->leaves / octree_leaves, 2});
    row.emplace_back(Number{tree->bytes / points, 1});
  }
  row.resize(table.columns.size());
  table.rows.push_back(std::move(row));
}

Table partition_of(const Scan& scan, int rounds) {
  const vstree::PointSet points{.positions = scan.positions, .normals = scan.normals};
  const std::size_t count = scan.positions.size() / 3;
  std::array<TreeSize, 4> trees;
  const auto build = [&](std::size_t i, bool surface, float delta_d, unsigned threads) {
    const vstree::Tree tree(points, {.surface = surface, .delta_d = delta_d, .threads = threads});
    trees[i] = {static_cast<double>(tree.leaf_count()), static_cast<double>(tree.bytes())};
  };
  using Index =
      nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Cloud>, Cloud, 3, std::uint32_t>;
  const Cloud cloud{scan.positions};
  std::vector<Work> works;
  works.push_back({"volume-surface tree", [&] { build(0, true, 0.25F, 1); }});
  works.push_back({"the same, 2 threads", [&] { build(1, true, 0.25F, 2); }});
  works.push_back({"the same, delta_d 1/6 as in the thesis", [&] { build(2, true, 1.0F / 6, 1); }});
  works.push_back({"octree of ours", [&] { build(3, false, 0.25F, 1); }});
  works.push_back({"kd-tree of nanoflann, 64 a leaf", [&] {
                     Index index(3, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(64));
                     index.buildIndex();
                   }});
  take_turns(works, rounds);
  Table table{"Partition of " + std::to_string(count) + " samples of igea, error L2 1e-4", cost_columns, {}};
  for (const char* column : {"leaves", "of the octree's", "tree's B a point"}) table.columns.emplace_back(column);
  for (std::size_t i = 0; i < works.size(); ++i)
    add_row(works[i], works.back(), static_cast<double>(count), i < trees.size() ? &trees[i] : nullptr,
            trees.back().leaves, table);
  if (const auto cgal = peer("octree", "octree of CGAL, 64 a leaf", scan.positions, rounds)) {
    std::vector<Cell> row = costs_of(cgal->work, works.back(), static_cast<double>(count));
    row.emplace_back(Number{static_cast<double>(cgal->found), 0});
    row.resize(table.columns.size());
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

std::vector<Table> partition_tables(const Settings& settings) {
  const Scan igea = read_scan(settings.data, "igea");
  std::vector<Table> tables;
  for (const std::size_t samples : settings.samples)
    tables.push_back(partition_of(sampled(igea, samples), std::max(2, settings.rounds / 3)));
  if (!tables.empty())
    tables.back().note =
        "Table 3.1 of the thesis, L2 1e-4 too: igea, 134346 samples, octree .33 s, volume-surface tree .34 s and 49 % "
        "fewer leaves; raptor, 1000080: 3.50, 3.11, 39 %; XYZ dragon, 3609601: 11.82, 9.88, 52 %; XYZ statue, 5000000: "
        "17.82, 14.90, 32 %.";
  return tables;
}

}  // namespace glark::bench
