// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/sample/pass/cell_trees.h"

namespace glark::stream {

void put_trees(std::span<SummedCell> cells, const Plan& plan, bool has_normals, const common::Workers& workers,
               TreeStore& trees) {
  for (std::size_t begin = 0, end = 0; begin < cells.size(); begin = end) {
    for (std::size_t clusters = 0; end < cells.size(); ++end) {
      clusters += cells[end].clusters.size();
      if (end > begin && clusters > plan.tree_clusters) break;
    }
    workers.each(end - begin, 1, [&](std::size_t from, std::size_t to) {
      for (SummedCell& summed : cells.subspan(begin + from, to - from)) {
        trees.put(summed.cell,
                  cluster_tree(summed.clusters, plan.tree_options(summed.cell, has_normals, summed.fewer)));
        summed.clusters = {};
      }
    });
  }
}

}  // namespace glark::stream
