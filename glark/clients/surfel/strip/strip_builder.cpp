// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/strip/strip_builder.h"

#include <algorithm>
#include <array>

namespace glark::surfel {
namespace {

constexpr int one_run_cost = 3, one_swap_cost = 1;  // the cost in indices; for a run, the average

constexpr std::uint32_t no_link = TriangleAdjacency::no_link;
constexpr std::uint32_t is_used = 1U << 27;  // more than any degree

// The pivot for a set of crossed sides, as bits, and one side. Two crossed sides have a common corner. The pivot is 1
// if this corner comes next after the side, and 2 if it is the one after. It is 0 unless two sides are crossed.
constexpr std::array<std::array<std::int8_t, 3>, 8> pivots = {{
    {0, 0, 0},
    {0, 0, 0},
    {0, 0, 0},
    {2, 1, 0},
    {0, 0, 0},
    {1, 0, 2},
    {0, 2, 1},
    {0, 0, 0},
}};

constexpr std::uint32_t no_side = 3;

// The lowest side of each set of sides.
constexpr std::array<std::uint8_t, 8> lowest = {no_side, 0, 1, 0, 2, 0, 1, 0};

}  // namespace

// Writes the triangle to the stack in any case, but keeps it there only if its degree is low. A branch would be
// mispredicted.
void StripBuilder::note_if_low_degree(std::uint32_t triangle) {
  low_degree_[low_degree_count_] = triangle;
  low_degree_count_ += degrees_[triangle] < 2 ? 1 : 0;
}

void StripBuilder::mark_used(std::uint32_t triangle) {
  degrees_[triangle] += is_used;
  for (std::uint32_t side = 0; side < 3; ++side) {
    const std::uint32_t other = neighbour(triangle, side);
    --degrees_[other];
    note_if_low_degree(other);
  }
}

// Triangles of low degree come first, because later they would be hard to reach.
std::uint32_t StripBuilder::next_start() {
  while (low_degree_count_ > 0) {
    const std::uint32_t last = low_degree_[--low_degree_count_];
    if (degrees_[last] < is_used) return last;
  }
  while (first_unused_ < size() && degrees_[first_unused_] >= is_used) ++first_unused_;
  return first_unused_ < size() ? first_unused_ : no_triangle;
}

// Walks from neighbour to neighbour, always to the one with the lowest degree. Among equal neighbours, it takes the one
// that needs no swap.
void StripBuilder::walk_from(std::uint32_t at) {
  for (std::uint32_t straight = no_side;;) {
    std::uint32_t best = no_triangle;  // degree, whether a swap is needed, and side, as one number
    for (std::uint32_t side = 0; side < 3; ++side) {
      best = std::min(best, degrees_[neighbour(at, side)] << 3 | (side == straight ? 0U : 4U) | side);
    }
    if (best >> 3 >= is_used) return;
    const std::uint32_t side = best & 3, link = adjacency_.links(at)[side];
    join(at, side);
    // Without a swap, the strip goes around the other end of the edge than before.
    const int pivot = pivots[crossed_[at]][side];
    straight = pivot == 0 ? no_side : (side_of(link) + (pivot == 1 ? 2 : 1)) % 3;
    at = triangle_of(link);
    mark_used(at);
  }
}

void StripBuilder::walk() {
  degrees_.resize(size() + 1);
  degrees_[size()] = 2 * is_used;  // stands for the outside
  low_degree_.resize(2 * size() + 1);
  low_degree_count_ = 0;
  first_unused_ = 0;
  for (std::uint32_t t = 0; t < size(); ++t) {
    const auto [a, b, c] = adjacency_.links(t);
    degrees_[t] = (a != no_link ? 1U : 0U) + (b != no_link ? 1U : 0U) + (c != no_link ? 1U : 0U);
    note_if_low_degree(t);
  }
  for (std::uint32_t start = next_start(); start != no_triangle; start = next_start()) {
    mark_used(start);
    walk_from(start);
    walk_from(start);  // in the other direction
  }
}

void StripBuilder::join(std::uint32_t triangle, std::uint32_t side) {
  const std::uint32_t link = adjacency_.links(triangle)[side], other = triangle_of(link);
  crossed_[triangle] |= static_cast<std::uint8_t>(1U << side);
  crossed_[other] |= static_cast<std::uint8_t>(1U << side_of(link));
  run_neighbours_[triangle] ^= other + 1;
  run_neighbours_[other] ^= triangle + 1;
}

void StripBuilder::cut(std::uint32_t triangle, std::uint32_t side) {
  const std::uint32_t link = adjacency_.links(triangle)[side], other = triangle_of(link);
  crossed_[triangle] &= static_cast<std::uint8_t>(~(1U << side));
  crossed_[other] &= static_cast<std::uint8_t>(~(1U << side_of(link)));
  run_neighbours_[triangle] ^= other + 1;
  run_neighbours_[other] ^= triangle + 1;
}

// Returns the cost of a swap between two adjacent triangles, which cross these sides and meet at one side of each. They
// need a swap if both go around the same end of the common edge.
int StripBuilder::swap_cost(std::uint8_t crossed, std::uint32_t side, std::uint8_t crossed_there,
                            std::uint32_t side_there) {
  const int one = pivots[crossed][side], other = pivots[crossed_there][side_there];
  return one != 0 && one + other == 3 ? one_swap_cost : 0;
}

// Returns the cost of a swap between a triangle and its neighbour at a side. The run is assumed to cross the sides
// `crossed` of the triangle.
int StripBuilder::swap_cost_at(std::uint32_t triangle, std::uint32_t side, std::uint8_t crossed) const {
  const std::uint32_t link = adjacency_.links(triangle)[side];
  return swap_cost(crossed, side, crossed_[triangle_of(link)], side_of(link));
}

// Returns the cost of the swaps that vanish if the run no longer crosses a side: at the side, and beyond the neighbour
// there.
int StripBuilder::detached_cost(std::uint32_t triangle, std::uint32_t side) const {
  const std::uint32_t link = adjacency_.links(triangle)[side];
  const std::uint32_t other = triangle_of(link);
  const std::uint8_t rest = crossed_[other] & static_cast<std::uint8_t>(~(1U << side_of(link)));
  return swap_cost_at(triangle, side, crossed_[triangle]) +
         (rest != 0 ? swap_cost_at(other, lowest[rest], crossed_[other]) : 0);
}

// Returns the change of cost if the run that ends at triangle t is extended across a side. At cut_side, the next
// triangle is cut off its own run. With no_side, the next triangle is an end of its run.
int StripBuilder::extension_cost(std::uint32_t t, std::uint32_t side, std::uint32_t cut_side) const {
  const std::uint32_t link = adjacency_.links(t)[side], u = triangle_of(link);
  const std::uint8_t rest = crossed_[t], kept = crossed_[u] & static_cast<std::uint8_t>(~(1U << cut_side));
  const auto crossed = static_cast<std::uint8_t>(rest | 1U << side);
  const auto crossed_there = static_cast<std::uint8_t>(kept | 1U << side_of(link));
  int cost = swap_cost(crossed, side, crossed_there, side_of(link));
  if (rest != 0) cost += swap_cost_at(t, lowest[rest], crossed);
  if (kept != 0) cost += swap_cost_at(u, lowest[kept], crossed_there);
  if (cut_side == no_side) return cost - one_run_cost;
  return cost - detached_cost(u, cut_side) - swap_cost_at(u, lowest[kept], crossed_[u]);
}

// Returns whether the run that goes from triangle `first` to `next` comes back to `first`.
bool StripBuilder::is_loop(std::uint32_t first, std::uint32_t next) const {
  std::uint32_t before = first + 1;
  for (std::uint32_t at = next + 1; at != 0;) {
    if (at == first + 1) return true;
    const std::uint32_t following = run_neighbours_[at - 1] ^ before;
    before = at;
    at = following;
  }
  return false;
}

// Extends runs at their ends, in random order, as long as the cost does not increase. Changes without a gain lead to
// other changes that save indices. Changes that do not start at an end almost never save indices.
void StripBuilder::improve() {
  ends_.clear();
  for (std::uint32_t t = 0; t < size(); ++t) {
    if (is_end(t)) ends_.push_back(t);
  }
  std::uint32_t random = 1;
  for (std::size_t step = 0; step < size() * 3 / 4 && !ends_.empty(); ++step) {
    random = random * 1664525U + 1013904223U;
    const std::size_t at = std::uint64_t{random} * ends_.size() >> 32;
    if (is_end(ends_[at])) {
      extend(ends_[at], random >> 8);
    } else {
      ends_[at] = ends_.back();
      ends_.pop_back();
    }
  }
}

// Extends a run from its end, triangle t, across the side with the least cost.
void StripBuilder::extend(std::uint32_t t, std::uint32_t random) {
  int least = 1;
  std::uint32_t best = no_triangle;
  for (std::uint32_t i = 0, side = random % 3; i < 3; ++i, side = side == 2 ? 0 : side + 1) {
    const std::uint32_t link = adjacency_.links(t)[side];
    if ((crossed_[t] >> side & 1) != 0 || link == no_link) continue;
    const std::uint8_t there = crossed_[triangle_of(link)];
    const bool is_full = (there & (there - 1)) != 0;
    const std::uint32_t one = is_full ? lowest[there] : no_side;
    const std::uint32_t other = is_full ? lowest[there & (there - 1)] : no_side;
    const auto consider = [&](std::uint32_t cut_side) {
      const int cost = extension_cost(t, side, cut_side);
      if (cost >= least) return;
      least = cost;
      best = side << 2 | cut_side;
    };
    consider((random & 4) != 0 ? one : other);
    if (is_full) consider((random & 4) != 0 ? other : one);
  }
  if (best == no_triangle) return;
  const std::uint32_t side = best >> 2, cut_side = best & 3, u = triangle_of(adjacency_.links(t)[side]);
  if (cut_side != no_side) cut(u, cut_side);
  join(t, side);
  if (is_loop(u, t)) {
    cut(t, side);
    if (cut_side != no_side) join(u, cut_side);
  } else if (cut_side != no_side) {
    ends_.push_back(triangle_of(adjacency_.links(u)[cut_side]));
  }
}

void StripBuilder::follow(std::uint32_t end, std::vector<std::uint32_t>& triangles) const {
  triangles.clear();
  std::uint32_t before = 0;
  for (std::uint32_t at = end + 1; at != 0;) {
    triangles.push_back(at - 1);
    const std::uint32_t next = run_neighbours_[at - 1] ^ before;
    before = at;
    at = next;
  }
}

void StripBuilder::build(std::span<const Triangle> triangles) {
  crossed_.assign(triangles.size(), 0);
  adjacency_.build(triangles);
  run_neighbours_.assign(triangles.size(), 0);
  walk();
  improve();
}

}  // namespace glark::surfel
