// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Arrays in which every leaf has a slot of its own.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "glark/clients/common/workers.h"
#include "glark/clients/surfel/tree/stripping_tree.h"

namespace glark::surfel {

inline constexpr std::size_t leaves_a_batch = 16;

// The items that a worker makes for several leaves, one leaf after the other.
template <typename Item>
struct Batch {
  std::vector<Item> items;
  std::vector<std::uint32_t> counts;  // the number of items of each leaf
};

// Writes the items to the slot if they fit, and to the end of the array otherwise.
template <typename Item>
void store(Slot& slot, std::span<const Item> items, std::vector<Item>& array) {
  slot.count = static_cast<std::uint32_t>(items.size());
  if (slot.count <= slot.capacity) {
    std::copy(items.begin(), items.end(), array.begin() + slot.first);
    return;
  }
  slot.first = static_cast<std::uint32_t>(array.size());
  slot.capacity = slot.count;
  array.insert(array.end(), items.begin(), items.end());
}

// Calls make_batch(leaves, batch) for all leaves, and stores the items that it appends to the batch in slot_of(leaf). A
// single worker needs the memory of one batch only.
template <typename Item, typename SlotOf, typename MakeBatch>
void fill_slots(std::span<const std::uint32_t> leaves, const common::Workers& workers, std::vector<Item>& array,
                const SlotOf& slot_of, const MakeBatch& make_batch) {
  const std::size_t leaves_at_once = workers.count() == 1 ? leaves_a_batch : leaves.size();
  std::vector<Batch<Item>> batches((leaves_at_once + leaves_a_batch - 1) / leaves_a_batch);
  for (; !leaves.empty(); leaves = leaves.subspan(std::min(leaves_at_once, leaves.size()))) {
    const auto some = leaves.first(std::min(leaves_at_once, leaves.size()));
    workers.in_pieces(some.size(), leaves_a_batch, [&](std::size_t begin, std::size_t end) {
      Batch<Item>& batch = batches[begin / leaves_a_batch];
      batch.items.clear();
      batch.counts.clear();
      make_batch(some.subspan(begin, end - begin), batch);
    });
    for (std::size_t i = 0; i < some.size(); i += leaves_a_batch) {
      std::span<const Item> rest = batches[i / leaves_a_batch].items;
      std::size_t leaf = i;
      for (const std::uint32_t count : batches[i / leaves_a_batch].counts) {
        store(slot_of(some[leaf++]), rest.first(count), array);
        rest = rest.subspan(count);
      }
    }
  }
}

// Closes the gaps between the slots if more than half of the array is unused. for_each_slot(body) calls body(slot) for
// all slots. Returns whether items moved.
template <typename Item, typename ForEachSlot>
bool compact_slots(std::vector<Item>& array, const ForEachSlot& for_each_slot) {
  std::size_t live = 0;
  for_each_slot([&](Slot& slot) { live += slot.count; });
  constexpr std::size_t tolerated_gaps = 4096;
  if (array.size() <= 2 * live + tolerated_gaps) return false;
  std::vector<Item> compacted;
  compacted.reserve(live);
  for_each_slot([&](Slot& slot) {
    const auto from = array.begin() + slot.first;
    slot.first = static_cast<std::uint32_t>(compacted.size());
    slot.capacity = slot.count;
    compacted.insert(compacted.end(), from, from + slot.count);
  });
  array = std::move(compacted);
  return true;
}

}  // namespace glark::surfel
