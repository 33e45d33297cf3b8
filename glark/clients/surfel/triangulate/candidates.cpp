// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/triangulate/candidates.h"

#include "glark/clients/surfel/level/slot_array.h"
#include "glark/clients/surfel/triangulate/leaf_triangulator.h"

namespace glark::surfel {

void make_candidates(Level& level, std::span<const std::uint32_t> leaves, const LevelOptions& options,
                     const common::Workers& workers) {
  if (level.candidates.empty()) level.candidates.reserve(usual_capacity(level, leaves));
  fill_slots(
      leaves, workers, level.candidates, [&](std::uint32_t leaf) -> Slot& { return level.patches[leaf].candidates; },
      [&](std::span<const std::uint32_t> some, Batch<Candidate>& batch) {
        LeafTriangulator triangulator(level.tree, options.reach, options.flip_edges);
        for (const std::uint32_t leaf : some) {
          if (!level.tree.leaves[leaf].has_surface) {
            level.patches[leaf].counts = {};
            level.patches[leaf].shared_count = 0;
            level.patches[leaf].points_moved = true;
            batch.counts.push_back(0);
            continue;
          }
          const LeafTriangulator::Result& result = triangulator.triangulate(leaf);
          batch.items.insert(batch.items.end(), result.candidates.begin(), result.candidates.end());
          batch.counts.push_back(static_cast<std::uint32_t>(result.candidates.size()));
          Patch& patch = level.patches[leaf];
          patch.counts.outer = result.outer;
          patch.counts.flipped_in_triangulation = result.flipped;
          patch.shared_count = result.shared_count;
          patch.points_moved = true;
          const std::span<Surfel> surfels = level.tree.unique_surfels(level.tree.leaves[leaf]);
          for (std::size_t i = 0; i < surfels.size(); ++i) surfels[i].spacing = result.spacings[i];
        }
      });
}

}  // namespace glark::surfel
