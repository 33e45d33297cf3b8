// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/layer.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include "glark/clients/surfel/bounds.h"
#include "glark/clients/surfel/comparison.h"
#include "glark/clients/surfel/decimation.h"
#include "glark/clients/surfel/mending.h"

namespace glark::surfel {
namespace {

constexpr std::size_t leaves_a_piece = 16;

// What a worker makes of a run of leaves, one after the other.
template <typename Item>
struct Piece {
  std::vector<Item> items;
  std::vector<std::uint32_t> counts;
};

// Where the items were if they fit there, at the end otherwise.
template <typename Item>
void put(Slot& slot, std::span<const Item> items, std::vector<Item>& array) {
  slot.count = static_cast<std::uint32_t>(items.size());
  if (slot.count <= slot.capacity) {
    std::copy(items.begin(), items.end(), array.begin() + slot.first);
    return;
  }
  slot.first = static_cast<std::uint32_t>(array.size());
  slot.capacity = slot.count;
  array.insert(array.end(), items.begin(), items.end());
}

// Enough for what most clouds have of candidates or indices.
std::size_t room_for(const Layer& layer, std::span<const std::uint32_t> leaves) {
  std::size_t points = 0;
  for (const std::uint32_t leaf : leaves) points += layer.tree.leaves[leaf].used;
  return 3 * points;
}

// Runs make_run(leaves, piece) for all leaves, and puts what it appends to the pieces into the leaves' slots. A worker who is alone has
// the memory of one piece for all.
template <typename Item, typename SlotOf, typename MakeRun>
void fill_slots(std::span<const std::uint32_t> leaves, const Workers& workers, std::vector<Item>& array,
                const SlotOf& slot_of, const MakeRun& make_run) {
  const std::size_t leaves_at_once = workers.count() == 1 ? leaves_a_piece : leaves.size();
  std::vector<Piece<Item>> pieces((leaves_at_once + leaves_a_piece - 1) / leaves_a_piece);
  for (; !leaves.empty(); leaves = leaves.subspan(std::min(leaves_at_once, leaves.size()))) {
    const auto some = leaves.first(std::min(leaves_at_once, leaves.size()));
    workers.in_pieces(some.size(), leaves_a_piece, [&](std::size_t begin, std::size_t end) {
      Piece<Item>& piece = pieces[begin / leaves_a_piece];
      piece.items.clear();
      piece.counts.clear();
      make_run(some.subspan(begin, end - begin), piece);
    });
    for (std::size_t i = 0; i < some.size(); i += leaves_a_piece) {
      std::span<const Item> rest = pieces[i / leaves_a_piece].items;
      std::size_t leaf = i;
      for (const std::uint32_t count : pieces[i / leaves_a_piece].counts) {
        put(slot_of(some[leaf++]), rest.first(count), array);
        rest = rest.subspan(count);
      }
    }
  }
}

// The same for a triangle whichever of its corners is the first.
std::uint64_t fingerprint(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  while (a > b || a > c) std::tie(a, b, c) = std::tuple(b, c, a);
  std::uint64_t mixed = (std::uint64_t{a} << 32 | b) * 0x9E3779B97F4A7C15U + c;
  mixed = (mixed ^ mixed >> 31) * 0xBF58476D1CE4E5B9U;
  return mixed ^ mixed >> 29;
}

std::uint64_t fingerprint(std::span<const StripTriangle> triangles) {
  std::uint64_t sum = triangles.size();
  for (const auto& [a, b, c] : triangles) sum += fingerprint(a, b, c);
  return sum;
}

// Of a few points, the one nearest to their mean, whose number is kept; of many, those of either half.
void keep_middles(std::span<Surfel> surfels, std::vector<Surfel>& kept) {
  constexpr std::size_t few = 5;
  if (surfels.size() > few) {
    Box box;
    for (const Surfel& surfel : surfels) box.add(surfel.position);
    const std::size_t axis = box.widest_axis();
    const std::size_t half = surfels.size() / 2;
    std::nth_element(surfels.begin(), surfels.begin() + static_cast<std::ptrdiff_t>(half), surfels.end(),
                     [axis](const Surfel& a, const Surfel& b) {
                       return std::pair(a.position[axis], a.index) < std::pair(b.position[axis], b.index);
                     });
    keep_middles(surfels.first(half), kept);
    keep_middles(surfels.subspan(half), kept);
    return;
  }
  Vector mean;
  for (const Surfel& surfel : surfels) mean = mean + surfel.position * (1 / static_cast<float>(surfels.size()));
  const auto away = [&](const Surfel& surfel) { return std::pair(length(surfel.position - mean), surfel.index); };
  kept.push_back(*std::min_element(surfels.begin(), surfels.end(),
                                   [&](const Surfel& a, const Surfel& b) { return away(a) < away(b); }));
}

}  // namespace

void make_candidates(Layer& layer, std::span<const std::uint32_t> leaves, const LayerOptions& options,
                     const Workers& workers) {
  if (layer.candidates.empty()) layer.candidates.reserve(room_for(layer, leaves));
  fill_slots(
      leaves, workers, layer.candidates, [&](std::uint32_t leaf) -> Slot& { return layer.patches[leaf].candidates; },
      [&](std::span<const std::uint32_t> run, Piece<Candidate>& piece) {
        Patcher patcher(layer.tree, options.reach, options.turn_edges);
        for (const std::uint32_t leaf : run) {
          patcher.make(leaf);
          piece.items.insert(piece.items.end(), patcher.candidates.begin(), patcher.candidates.end());
          piece.counts.push_back(static_cast<std::uint32_t>(patcher.candidates.size()));
          layer.patches[leaf].outer = patcher.outer;
          layer.patches[leaf].evened = patcher.turned;
          layer.patches[leaf].shared = patcher.shared;
          layer.patches[leaf].moved = true;
          std::span<Surfel> surfels = layer.tree.used(layer.tree.leaves[leaf]);
          for (std::size_t i = 0; i < surfels.size(); ++i) surfels[i].spacing = patcher.spacings[i];
        }
      });
}

void agree_on_candidates(Layer& layer, std::span<const std::uint32_t> leaves, const LayerOptions& options,
                         const Workers& workers) {
  workers.in_pieces(leaves.size(), leaves_a_piece, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) agree(layer, leaves[i], options);
  });
}

void make_strips(Layer& layer, std::span<const std::uint32_t> leaves, const LayerOptions& options,
                 const Workers& workers, std::vector<std::uint32_t>& indices, std::vector<Range>& changed) {
  std::vector<std::uint8_t> kept(leaves.size(), 0);
  if (indices.empty()) indices.reserve(room_for(layer, leaves));
  fill_slots(
      leaves, workers, indices, [&](std::uint32_t leaf) -> Slot& { return layer.patches[leaf].strip; },
      [&](std::span<const std::uint32_t> run, Piece<std::uint32_t>& piece) {
        std::vector<StripTriangle> triangles;
        Stripper stripper(layer.positions, options.turn_edges);
        for (const std::uint32_t& leaf : run) {
          Patch& patch = layer.patches[leaf];
          decimate(layer, leaf, patch, triangles);
          const std::span<const std::uint32_t> old = std::span(indices).subspan(patch.strip.first, patch.strip.count);
          const std::uint64_t drawn = fingerprint(triangles);
          const bool same = drawn == patch.drawn && (!patch.moved || patch.turned == 0);
          patch.drawn = drawn;
          const std::size_t begin = piece.items.size();
          if (same) {
            if (patch.moved) bound(layer, triangles, patch);
            piece.items.insert(piece.items.end(), old.begin(), old.end());
          } else {
            for (const std::uint32_t point : stripper.strip(triangles)) piece.items.push_back(layer.name(point));
            patch.turned = stripper.turned;
            bound(layer, stripper.drawn(), patch);
          }
          patch.moved = false;
          const auto made = std::span(std::as_const(piece.items)).subspan(begin);
          kept[static_cast<std::size_t>(&leaf - leaves.data())] = same || std::ranges::equal(made, old) ? 1 : 0;
          piece.counts.push_back(static_cast<std::uint32_t>(made.size()));
        }
      });
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    const Slot& slot = layer.patches[leaves[i]].strip;
    if (slot.count > 0 && kept[i] == 0) changed.push_back({slot.first, slot.count});
  }
}

Layer build_layer(std::vector<Surfel> surfels, std::vector<std::uint32_t> names, const LayerOptions& options,
                  const Workers& workers, std::vector<std::uint32_t>& indices) {
  Layer layer;
  layer.names = std::move(names);
  const std::size_t count = surfels.size();
  layer.tree = build_tree(std::move(surfels), options.tree, workers);
  layer.owner.resize(count);
  layer.place.resize(count);
  layer.positions.resize(count);
  layer.rift_of.resize(count, none);
  layer.patches.resize(layer.tree.leaves.size());
  layer.planted = layer.tree.leaves.size();
  std::vector<std::uint32_t> leaves(layer.tree.leaves.size());
  std::iota(leaves.begin(), leaves.end(), 0U);
  workers.in_pieces(leaves.size(), 4 * leaves_a_piece, [&](std::size_t begin, std::size_t end) {
    for (std::size_t leaf = begin; leaf < end; ++leaf) layer.find_owners(static_cast<std::uint32_t>(leaf));
  });
  make_candidates(layer, leaves, options, workers);
  agree_on_candidates(layer, leaves, options, workers);
  mend(layer, leaves, options, workers);
  std::vector<Range> changed;
  make_strips(layer, leaves, options, workers, indices, changed);
  layer.nodes.resize(layer.tree.nodes.size());
  for (auto node = static_cast<std::uint32_t>(layer.nodes.size()); node-- > 0;) describe(layer, node, options);
  return layer;
}

std::vector<Surfel> coarser(const Layer& layer, std::vector<std::uint32_t>& names) {
  std::vector<Surfel> kept;
  std::vector<Surfel> own;
  for (const Leaf& leaf : layer.tree.leaves) {
    const auto used = layer.tree.used(leaf);
    if (used.empty()) continue;
    own.assign(used.begin(), used.end());
    keep_middles(own, kept);
  }
  std::sort(kept.begin(), kept.end(), [](const Surfel& a, const Surfel& b) { return a.index < b.index; });
  names.clear();
  for (Surfel& surfel : kept) {
    names.push_back(layer.name(surfel.index));
    surfel.index = static_cast<std::uint32_t>(names.size() - 1);
  }
  return kept;
}

}  // namespace glark::surfel
