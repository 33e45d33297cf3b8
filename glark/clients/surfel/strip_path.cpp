// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/strip_path.h"

#include <algorithm>
#include <limits>

namespace glark::surfel {
namespace {

// Without branches: nobody can predict how a run turns.
std::size_t is_corner(const StripTriangle& triangle, std::uint32_t point) {
  return static_cast<std::size_t>(triangle[0] == point) | static_cast<std::size_t>(triangle[1] == point) |
         static_cast<std::size_t>(triangle[2] == point);
}

}  // namespace

void Stripper::find_runs(std::span<const StripTriangle> triangles) {
  runs_.make(triangles);
  ordered_.clear();
  pieces_.clear();
  turned = 0;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    if (!runs_.is_end(t)) continue;
    runs_.follow(t, path_);
    if (path_.back() < t) continue;  // met from there
    pieces_.push_back({ordered_.size(), path_.size()});
    for (const std::uint32_t triangle : path_) ordered_.push_back(triangles[triangle]);
    if (turn_edges_) turned += turning_.run(std::span(ordered_).last(path_.size()));
  }
}

void Stripper::add_heads(std::uint32_t number, bool backwards) {
  const Run& run = pieces_[number];
  const auto at = [&](std::size_t i) -> const StripTriangle& {
    return ordered_[run.first + (backwards ? run.count - 1 - i : i)];
  };
  const StripTriangle& triangle = at(0);
  if (run.count == 1) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      heads_.push_back({triangle[k], triangle[(k + 1) % 3], false, false, number});
      heads_.push_back({triangle[k], triangle[(k + 2) % 3], true, false, number});
    }
    return;
  }
  const std::uint32_t k = corner_off(triangle, at(1));
  const std::uint32_t one = triangle[(k + 1) % 3], other = triangle[(k + 2) % 3];
  const std::uint32_t pivot = run.count > 2 ? common_point(triangle, at(1), at(2)) : Runs::none;
  if (pivot != one) heads_.push_back({triangle[k], one, false, backwards, number});
  if (pivot != other) heads_.push_back({triangle[k], other, true, backwards, number});
}

// Beyond those of the run itself. Every other triangle of a strip is the other way round.
int Stripper::indices_between(const Head& head) const {
  const std::size_t size = strip_.size();
  if (size == 0) return head.clockwise ? 1 : 0;
  const std::uint32_t last = strip_[size - 1];
  const int least = head.first == last ? 0 : head.first == strip_[size - 2] || head.second == last ? 1 : 2;
  const bool reversed = (size + static_cast<std::size_t>(least)) % 2 == 1;
  return least + (reversed == head.clockwise ? 0 : 1);
}

void Stripper::bridge(const Head& head) {
  const int count = indices_between(head);
  const std::size_t size = strip_.size();
  if (size == 0) {
    strip_.assign(static_cast<std::size_t>(count), head.first);
    return;
  }
  const std::uint32_t last = strip_[size - 1];
  const bool from_last = head.first != last && (head.first != strip_[size - 2] || head.second == last);
  for (int i = 0; i < count; ++i) strip_.push_back(from_last && i == 0 ? last : head.first);
  // Where the second is the last: that again, not the first, which would be a triangle with the two before.
  if (from_last && head.second == last && count == 2) strip_.back() = last;
}

void Stripper::append(const Head& head) {
  const Run& run = pieces_[head.run];
  const auto at = [&](std::size_t i) -> const StripTriangle& {
    return ordered_[head.backwards ? run.first + run.count - 1 - i : run.first + i];
  };
  std::size_t size = strip_.size();
  strip_.resize(size + 2 + 2 * run.count);
  strip_[size++] = head.first;
  strip_[size++] = head.second;
  const auto [a, b, c] = at(0);
  strip_[size++] = a ^ b ^ c ^ head.first ^ head.second;  // the third
  for (std::size_t i = 1; i < run.count; ++i) {
    // Around the last point but one: that again.
    if (i + 1 < run.count) {
      strip_[size] = strip_[size - 2];
      size += 1 - is_corner(at(i + 1), strip_[size - 1]);
    }
    const StripTriangle& triangle = at(i);
    // The corner off the one before.
    strip_[size++] = triangle[is_corner(at(i - 1), triangle[0]) * (1 + is_corner(at(i - 1), triangle[1]))];
  }
  strip_.resize(size);
}

std::span<const std::uint32_t> Stripper::strip(std::span<const StripTriangle> triangles) {
  strip_.clear();
  heads_.clear();
  find_runs(triangles);
  for (std::uint32_t run = 0; run < pieces_.size(); ++run) {
    add_heads(run, false);
    if (pieces_[run].count > 1) add_heads(run, true);
  }
  while (!heads_.empty()) {
    std::size_t best = 0;
    int least = std::numeric_limits<int>::max();
    for (std::size_t i = 0; i < heads_.size() && least > 0; ++i) {
      const int between = indices_between(heads_[i]);
      if (between >= least) continue;
      least = between;
      best = i;
    }
    const Head head = heads_[best];
    bridge(head);
    append(head);
    const auto others = std::equal_range(heads_.begin(), heads_.end(), head, [](const Head& a, const Head& b) {
      return a.run < b.run;  // they were added run by run
    });
    heads_.erase(others.first, others.second);
  }
  return strip_;
}

}  // namespace glark::surfel
