// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/strip/stripifier.h"

#include <algorithm>
#include <limits>

namespace glark::surfel {
namespace {

constexpr std::uint32_t no_point = 0xFFFFFFFFU;

// Returns 0 or 1 without branches, because they would be mispredicted.
std::size_t is_corner(const Triangle& triangle, std::uint32_t point) {
  return static_cast<std::size_t>(triangle[0] == point) | static_cast<std::size_t>(triangle[1] == point) |
         static_cast<std::size_t>(triangle[2] == point);
}

}  // namespace

void Stripifier::find_runs(std::span<const Triangle> triangles) {
  builder_.build(triangles);
  triangles_.clear();
  runs_.clear();
  flipped_ = 0;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    if (!builder_.is_end(t)) continue;
    builder_.follow(t, run_);
    if (run_.back() < t) continue;  // the run was already found from its other end
    runs_.push_back({triangles_.size(), run_.size()});
    for (const std::uint32_t triangle : run_) triangles_.push_back(triangles[triangle]);
    if (flip_edges_) flipped_ += flipper_.run(std::span(triangles_).last(run_.size()));
  }
}

void Stripifier::add_entries(std::uint32_t number, bool backwards) {
  const Run& run = runs_[number];
  const Triangle& triangle = triangle_at(run, 0, backwards);
  if (run.count == 1) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      entries_.push_back({triangle[k], triangle[(k + 1) % 3], false, false, number});
      entries_.push_back({triangle[k], triangle[(k + 2) % 3], true, false, number});
    }
    return;
  }
  const Triangle& following = triangle_at(run, 1, backwards);
  const std::uint32_t k = opposite_corner(triangle, following);
  const std::uint32_t one = triangle[(k + 1) % 3], other = triangle[(k + 2) % 3];
  const std::uint32_t pivot =
      run.count > 2 ? pivot_point(triangle, following, triangle_at(run, 2, backwards)) : no_point;
  if (pivot != one) entries_.push_back({triangle[k], one, false, backwards, number});
  if (pivot != other) entries_.push_back({triangle[k], other, true, backwards, number});
}

// Returns the number of indices that join the entry's run to the strip. Every second triangle of a strip has the
// opposite orientation.
int Stripifier::connecting_indices(const Entry& entry) const {
  const std::size_t size = strip_.size();
  if (size == 0) return entry.clockwise ? 1 : 0;
  const std::uint32_t last = strip_[size - 1];
  const int least = entry.first == last ? 0 : entry.first == strip_[size - 2] || entry.second == last ? 1 : 2;
  const bool reversed = (size + static_cast<std::size_t>(least)) % 2 == 1;
  return least + (reversed == entry.clockwise ? 0 : 1);
}

void Stripifier::connect(const Entry& entry) {
  const int count = connecting_indices(entry);
  const std::size_t size = strip_.size();
  if (size == 0) {
    strip_.assign(static_cast<std::size_t>(count), entry.first);
    return;
  }
  const std::uint32_t last = strip_[size - 1];
  const bool repeat_last = entry.first != last && (entry.first != strip_[size - 2] || entry.second == last);
  for (int i = 0; i < count; ++i) strip_.push_back(repeat_last && i == 0 ? last : entry.first);
  // If the run's second point is the last point of the strip, the run's first point would make a triangle with the two
  // points before.
  if (repeat_last && entry.second == last && count == 2) strip_.back() = last;
}

void Stripifier::append(const Entry& entry) {
  const Run& run = runs_[entry.run];
  const auto at = [&](std::size_t i) -> const Triangle& { return triangle_at(run, i, entry.backwards); };
  std::size_t size = strip_.size();
  strip_.resize(size + 2 + 2 * run.count);
  strip_[size++] = entry.first;
  strip_[size++] = entry.second;
  const auto [a, b, c] = at(0);
  strip_[size++] = a ^ b ^ c ^ entry.first ^ entry.second;  // the third point
  for (std::size_t i = 1; i < run.count; ++i) {
    // If the next triangles go around the last point but one, a swap repeats this point.
    if (i + 1 < run.count) {
      strip_[size] = strip_[size - 2];
      size += 1 - is_corner(at(i + 1), strip_[size - 1]);
    }
    const Triangle& triangle = at(i);
    // The corner that is not in the previous triangle.
    strip_[size++] = triangle[is_corner(at(i - 1), triangle[0]) * (1 + is_corner(at(i - 1), triangle[1]))];
  }
  strip_.resize(size);
}

std::size_t Stripifier::cheapest_entry() const {
  std::size_t best = 0;
  int least = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < entries_.size() && least > 0; ++i) {
    const int indices = connecting_indices(entries_[i]);
    if (indices >= least) continue;
    least = indices;
    best = i;
  }
  return best;
}

std::span<const std::uint32_t> Stripifier::stripify(std::span<const Triangle> triangles) {
  strip_.clear();
  entries_.clear();
  find_runs(triangles);
  for (std::uint32_t run = 0; run < runs_.size(); ++run) {
    add_entries(run, false);
    if (runs_[run].count > 1) add_entries(run, true);
  }
  while (!entries_.empty()) {
    const Entry entry = entries_[cheapest_entry()];
    connect(entry);
    append(entry);
    const auto of_run = std::equal_range(entries_.begin(), entries_.end(), entry,
                                         [](const Entry& a, const Entry& b) { return a.run < b.run; });
    entries_.erase(of_run.first, of_run.second);
  }
  return strip_;
}

}  // namespace glark::surfel
