// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/strip/leaf_strips.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "glark/clients/surfel/cull/bounds.h"
#include "glark/clients/surfel/level/slot_array.h"
#include "glark/clients/surfel/strip/drawn_triangles.h"
#include "glark/clients/surfel/strip/stripifier.h"

namespace glark::surfel {
namespace {

// The hash does not depend on which corner is the first.
std::uint64_t hash(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  while (a > b || a > c) std::tie(a, b, c) = std::tuple(b, c, a);
  std::uint64_t mixed = (std::uint64_t{a} << 32 | b) * 0x9E3779B97F4A7C15U + c;
  mixed = (mixed ^ mixed >> 31) * 0xBF58476D1CE4E5B9U;
  return mixed ^ mixed >> 29;
}

// The hash does not depend on the order of the triangles.
std::uint64_t hash(std::span<const Triangle> triangles) {
  std::uint64_t sum = triangles.size();
  for (const auto& [a, b, c] : triangles) sum += hash(a, b, c);
  return sum;
}

// Makes the strips of leaves one by one, and reuses its memory.
class LeafStripper {
 public:
  LeafStripper(Level& level, const std::vector<std::uint32_t>& indices, const LevelOptions& options)
      : level_(level), indices_(indices), stripifier_(level.positions, options.flip_edges) {}

  // Appends the leaf's strip to `strip`. A leaf with the same triangles as before keeps its strip. Returns whether the
  // leaf keeps its strip.
  bool append_strip(std::uint32_t leaf, std::vector<std::uint32_t>& strip) {
    Patch& patch = level_.patches[leaf];
    collect_drawn_triangles(level_, leaf, patch, triangles_);
    const auto old = std::span(indices_).subspan(patch.strip.first, patch.strip.count);
    const std::uint64_t drawn_hash = hash(triangles_);
    // If points moved, flipped edges may no longer be flat.
    const bool is_same = drawn_hash == patch.drawn_hash && (!patch.points_moved || patch.counts.flipped_in_strip == 0);
    patch.drawn_hash = drawn_hash;
    const std::size_t begin = strip.size();
    if (is_same) {
      if (patch.points_moved) patch.bounds = compute_bounds(level_, triangles_);
      strip.insert(strip.end(), old.begin(), old.end());
    } else {
      for (const std::uint32_t point : stripifier_.stripify(triangles_)) strip.push_back(level_.cloud_index(point));
      patch.counts.flipped_in_strip = stripifier_.flipped_edges();
      patch.bounds = compute_bounds(level_, stripifier_.triangles());
    }
    patch.points_moved = false;
    return is_same || std::ranges::equal(std::span(std::as_const(strip)).subspan(begin), old);
  }

 private:
  Level& level_;
  const std::vector<std::uint32_t>& indices_;  // all old strips
  Stripifier stripifier_;
  std::vector<Triangle> triangles_;
};

}  // namespace

void make_strips(Level& level, std::span<const std::uint32_t> leaves, const LevelOptions& options,
                 const common::Workers& workers, std::vector<std::uint32_t>& indices, std::vector<Range>& changed) {
  std::vector<std::uint8_t> is_same(leaves.size(), 0);
  if (indices.empty()) indices.reserve(usual_capacity(level, leaves));
  fill_slots(
      leaves, workers, indices, [&](std::uint32_t leaf) -> Slot& { return level.patches[leaf].strip; },
      [&](std::span<const std::uint32_t> some, Batch<std::uint32_t>& batch) {
        LeafStripper stripper(level, indices, options);
        for (const std::uint32_t& leaf : some) {
          const std::size_t before = batch.items.size();
          const bool same = stripper.append_strip(leaf, batch.items);
          is_same[static_cast<std::size_t>(&leaf - leaves.data())] = same ? 1 : 0;
          batch.counts.push_back(static_cast<std::uint32_t>(batch.items.size() - before));
        }
      });
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    const Slot& slot = level.patches[leaves[i]].strip;
    if (slot.count > 0 && is_same[i] == 0) changed.push_back({slot.first, slot.count});
  }
}

}  // namespace glark::surfel
