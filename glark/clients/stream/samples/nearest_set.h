// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace glark::stream {

// A sample that a search has found: its index in the sampling, and the square of its distance.
struct NearSample {
  float square = 0;
  std::uint32_t index = 0;
};

// The nearest of the samples that are added, the nearest one first. Of samples that are equally far, the one with the
// least index is nearer. So the result does not depend on the order in which a tree, or several trees, find them.
// Entry: has the members of NearSample.
template <class Entry>
class NearestSet {
 public:
  // The entries are replaced, and belong to the caller.
  NearestSet(std::vector<Entry>& entries, std::size_t count) : entries_(entries), count_(count) { entries_.clear(); }

  bool full() const { return entries_.size() == count_; }
  // The square of a distance beyond which no sample counts. It is a little too large: trees round their bounds.
  float worst() const { return worst_; }

  void add(const Entry& entry) {
    std::size_t place = entries_.size();
    if (place < count_)
      entries_.push_back(entry);
    else if (is_nearer(entry, entries_[--place]))
      entries_[place] = entry;
    else
      return;
    for (; place > 0 && is_nearer(entry, entries_[place - 1]); --place) entries_[place] = entries_[place - 1];
    entries_[place] = entry;
    if (full()) worst_ = entries_.back().square * wider + std::numeric_limits<float>::min();
  }

 private:
  static constexpr float wider = 1.00001F;  // the sums of some thirty roundings differ by less

  static bool is_nearer(const Entry& a, const Entry& b) {
    return a.square < b.square || (a.square == b.square && a.index < b.index);
  }

  std::vector<Entry>& entries_;
  std::size_t count_;
  float worst_ = std::numeric_limits<float>::infinity();
};

}  // namespace glark::stream
