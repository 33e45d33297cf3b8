// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/strip_path.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace glark::surfel {
namespace {

constexpr std::uint32_t no_triangle = 0xFFFFFFFFU;
constexpr std::size_t most_starts = 2;

std::uint32_t hash(std::uint32_t from, std::uint32_t to) {
  const std::uint32_t mixed = from * 0x9E3779B1U ^ to * 0x85EBCA77U;
  return mixed ^ mixed >> 15;
}

std::uint32_t corner_of(const StripTriangle& triangle, std::uint32_t point) {
  return triangle[0] == point ? 0 : triangle[1] == point ? 1 : 2;
}

}  // namespace

// Pairs of half-edges that run in opposite directions.
void Stripper::find_neighbours() {
  neighbours_.assign(triangles_.size(), {no_triangle, no_triangle, no_triangle});
  std::size_t size = 64;
  while (size < 4 * triangles_.size()) size *= 2;
  table_.assign(size, no_triangle);
  const auto mask = static_cast<std::uint32_t>(size - 1);
  const auto count = static_cast<std::uint32_t>(triangles_.size());
  for (std::uint32_t t = 0; t < count; ++t) {
    for (std::uint32_t side = 0; side < 3; ++side) {
      const std::uint32_t from = triangles_[t][(side + 1) % 3], to = triangles_[t][(side + 2) % 3];
      std::uint32_t at = hash(std::min(from, to), std::max(from, to)) & mask;
      for (; table_[at] != no_triangle; at = (at + 1) & mask) {
        const std::uint32_t other = table_[at] / 4, other_side = table_[at] % 4;
        const StripTriangle& corners = triangles_[other];
        if (corners[(other_side + 1) % 3] != to || corners[(other_side + 2) % 3] != from) continue;
        if (neighbours_[other][other_side] != no_triangle) continue;
        neighbours_[other][other_side] = t;
        neighbours_[t][side] = other;
        break;
      }
      if (table_[at] == no_triangle) table_[at] = 4 * t + side;
    }
  }
}

// At triangles with few neighbours: they are hard to come by later.
void Stripper::find_starts() {
  starts_.clear();
  forget_uses();
  for (int degree = 0; degree <= 3 && starts_.size() < most_starts; ++degree) {
    const std::size_t stride = 1 + triangles_.size() / 16;
    for (std::size_t i = 0; i < triangles_.size() && starts_.size() < most_starts; ++i) {
      const auto t = static_cast<std::uint32_t>(i * stride % triangles_.size());
      if (free_[t] != degree) continue;
      std::uint32_t first = 0;
      while (first < 2 && neighbours_[t][first] == no_triangle) ++first;
      starts_.push_back({t, first, 0});
      starts_.push_back({t, first, 1});
    }
  }
}

void Stripper::forget_uses() {
  used_.assign(triangles_.size(), 0);
  free_.resize(triangles_.size());
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    free_[t] = static_cast<std::uint8_t>(std::count_if(neighbours_[t].begin(), neighbours_[t].end(),
                                                       [](std::uint32_t other) { return other != no_triangle; }));
  }
}

void Stripper::enter(std::uint32_t triangle) {
  used_[triangle] = 1;
  for (const std::uint32_t neighbour : neighbours_[triangle]) {
    if (neighbour != no_triangle) --free_[neighbour];
  }
  at_ = triangle;
  --left_;
}

// The triangle that is not used yet across the edge of the last one opposite to a corner.
std::uint32_t Stripper::beyond(std::uint32_t corner_point) const {
  const std::uint32_t next = neighbours_[at_][corner_of(triangles_[at_], corner_point)];
  return next != no_triangle && used_[next] == 0 ? next : no_triangle;
}

// The last three indices are the last triangle; the strip goes on over its last two, or, with the first of them twice, over first and last.
bool Stripper::step(int patience) {
  const std::size_t size = strip_.size();
  const std::uint32_t w = strip_[size - 3], x = strip_[size - 2], y = strip_[size - 1];
  const std::uint32_t ahead = beyond(w), turn = beyond(x);
  if (ahead == no_triangle && turn == no_triangle) return false;
  const bool straight = turn == no_triangle || (ahead != no_triangle && free_[ahead] <= free_[turn] + patience);
  if (!straight) {
    strip_[size - 1] = w;
    strip_.push_back(y);
  }
  const std::uint32_t next = straight ? ahead : turn, other = straight ? x : w;
  for (const std::uint32_t point : triangles_[next]) {
    if (point == y || point == other) continue;
    strip_.push_back(point);
    break;
  }
  enter(next);
  return true;
}

// Next to the strip's last point if anything is left there: that saves two indices.
void Stripper::begin_run() {
  const std::uint32_t last = strip_.back();
  std::uint32_t best = no_triangle;
  int best_rank = std::numeric_limits<int>::max();
  std::erase_if(unused_, [&](std::uint32_t t) { return used_[t] != 0; });
  for (const std::uint32_t t : unused_) {
    const bool touches = triangles_[t][0] == last || triangles_[t][1] == last || triangles_[t][2] == last;
    const int rank = free_[t] + (touches ? 0 : 4);
    if (rank >= best_rank) continue;
    best_rank = rank;
    best = t;
    if (rank == 0) break;
  }
  const StripTriangle& triangle = triangles_[best];
  std::uint32_t first = corner_of(triangle, last);
  strip_.push_back(last);
  if (triangle[first] != last) {
    first = 0;
    while (first < 2 && (neighbours_[best][first] == no_triangle || used_[neighbours_[best][first]] != 0)) ++first;
    strip_.push_back(triangle[first]);
    strip_.push_back(triangle[first]);
  }
  std::uint32_t second = triangle[(first + 1) % 3], third = triangle[(first + 2) % 3];
  if ((strip_.size() - 1) % 2 == 1) std::swap(second, third);  // every other triangle of a strip is the other way round
  strip_.push_back(second);
  strip_.push_back(third);
  enter(best);
}

void Stripper::cover(const Start& start) {
  forget_uses();
  left_ = triangles_.size();
  unused_.resize(left_);
  std::iota(unused_.begin(), unused_.end(), 0U);
  const StripTriangle& triangle = triangles_[start.triangle];
  strip_.clear();
  for (std::uint32_t k = 0; k < 3; ++k) strip_.push_back(triangle[(start.first + k) % 3]);
  enter(start.triangle);
  while (left_ > 0 && (best_.empty() || strip_.size() + left_ < best_.size())) {
    if (!step(start.patience)) begin_run();
  }
  if (left_ == 0 && (best_.empty() || strip_.size() < best_.size())) std::swap(best_, strip_);
}

std::span<const std::uint32_t> Stripper::strip(std::span<const StripTriangle> triangles) {
  triangles_ = triangles;
  best_.clear();
  if (triangles.empty()) return best_;
  find_neighbours();
  find_starts();
  for (const Start& start : starts_) cover(start);
  return best_;
}

}  // namespace glark::surfel
