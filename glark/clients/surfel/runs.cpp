// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/runs.h"

#include <algorithm>

namespace glark::surfel {
namespace {

constexpr int end_cost = 3, turn_cost = 2;  // in half indices: a run costs three on average, a turn one

constexpr std::uint64_t no_edge = ~std::uint64_t{0};
constexpr std::uint32_t is_used = 1U << 27;  // beyond any number of neighbours

constexpr std::uint64_t edge(std::uint32_t from, std::uint32_t to) { return std::uint64_t{from} << 32 | to; }

// Of two sides that are crossed, whether the corner that they share is the next after a side (1) or the one after that (2);
// 0 where there are no two.
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

constexpr std::array<std::uint8_t, 8> lowest = {3, 0, 1, 0, 2, 0, 1, 0};

}  // namespace

bool Runs::is_end(std::uint32_t triangle) const { return (crossed_[triangle] & (crossed_[triangle] - 1)) == 0; }

// Pairs of half-edges that run in opposite directions; those of two triangles on one another are none. Whether a half-edge is the
// first of its pair, nobody can predict: there is no branch on that.
void Runs::find_neighbours(std::span<const StripTriangle> triangles) {
  const auto count = static_cast<std::uint32_t>(triangles.size());
  const std::uint32_t nothing = count << 2;  // a link to one triangle more, which takes what is written there
  sides_.resize(count + 1);
  edges_.resize(nothing + 1);
  int bits = 6;
  while (std::size_t{1} << bits < 8 * triangles.size()) ++bits;
  table_.assign(std::size_t{1} << bits, nothing);
  const std::size_t mask = table_.size() - 1;
  const auto pair = [&](std::uint32_t t, std::uint32_t side, std::uint32_t tip, std::uint32_t from, std::uint32_t to) {
    const std::uint64_t opposite = edge(to, from);
    edges_[nothing] = opposite;  // where the search ends at the latest
    std::size_t at = edge(std::min(from, to), std::max(from, to)) * 0x9E3779B97F4A7C15U >> (64 - bits);
    std::uint32_t other = table_[at];
    while (edges_[other] != opposite ||
           (triangles[std::min(triangle_of(other), count - 1)][side_of(other)] == tip && other != nothing)) {
      at = (at + 1) & mask;
      other = table_[at];
    }
    const std::uint32_t is_first = other == nothing ? 1 : 0;
    const std::uint32_t link = t << 2 | side;
    table_[at] = link;
    edges_[link] = edge(from, to) | (std::uint64_t{is_first} - 1);  // none where it is taken
    edges_[other] = no_edge;
    sides_[t][side] = other | (0 - is_first);
    sides_[triangle_of(other)][side_of(other)] = link;
  };
  for (std::uint32_t t = 0; t < count; ++t) {
    const auto [a, b, c] = triangles[t];
    pair(t, 0, a, b, c);
    pair(t, 1, b, c, a);
    pair(t, 2, c, a, b);
  }
}

// A triangle with few neighbours left is written down in any case, and kept if it is one: nobody can predict that either.
void Runs::note_if_lonely(std::uint32_t triangle) {
  lonely_[lonely_count_] = triangle;
  lonely_count_ += free_[triangle] < 2 ? 1 : 0;
}

void Runs::use(std::uint32_t triangle) {
  free_[triangle] += is_used;
  for (std::size_t side = 0; side < 3; ++side) {
    const std::uint32_t neighbour = beyond(triangle, side);
    --free_[neighbour];
    note_if_lonely(neighbour);
  }
}

// Triangles with few neighbours first: they are hard to come by later.
std::uint32_t Runs::next_start() {
  while (lonely_count_ > 0) {
    const std::uint32_t last = lonely_[--lonely_count_];
    if (free_[last] < is_used) return last;
  }
  while (first_unused_ < size() && free_[first_unused_] >= is_used) ++first_unused_;
  return first_unused_ < size() ? first_unused_ : none;
}

// To the neighbour with the fewest neighbours that are left; straight on where there is a choice.
void Runs::walk_from(std::uint32_t at) {
  for (std::uint32_t straight = 3;;) {
    std::uint32_t best = none;  // how many are left, whether it is not straight on, and the side
    for (std::uint32_t side = 0; side < 3; ++side) {
      best = std::min(best, free_[beyond(at, side)] << 3 | (side == straight ? 0U : 4U) | side);
    }
    if (best >> 3 >= is_used) return;
    const std::uint32_t side = best & 3, link = sides_[at][side];
    join(at, side);
    // Straight on is around the other point of the edge than before.
    const int pivot = pivots[crossed_[at]][side];
    straight = pivot == 0 ? 3 : (side_of(link) + (pivot == 1 ? 2 : 1)) % 3;
    at = triangle_of(link);
    use(at);
  }
}

void Runs::walk() {
  free_.resize(size() + 1);
  free_[size()] = 2 * is_used;  // on the outside
  lonely_.resize(2 * size() + 1);
  lonely_count_ = 0;
  first_unused_ = 0;
  for (std::uint32_t t = 0; t < size(); ++t) {
    const auto [a, b, c] = sides_[t];
    free_[t] = (a != none ? 1U : 0U) + (b != none ? 1U : 0U) + (c != none ? 1U : 0U);
    note_if_lonely(t);
  }
  for (std::uint32_t start = next_start(); start != none; start = next_start()) {
    use(start);
    walk_from(start);
    walk_from(start);  // the other way
  }
}

void Runs::join(std::uint32_t triangle, std::uint32_t side) {
  const std::uint32_t link = sides_[triangle][side], other = triangle_of(link);
  crossed_[triangle] |= static_cast<std::uint8_t>(1U << side);
  crossed_[other] |= static_cast<std::uint8_t>(1U << side_of(link));
  beside_[triangle] ^= other + 1;
  beside_[other] ^= triangle + 1;
}

void Runs::part(std::uint32_t triangle, std::uint32_t side) {
  const std::uint32_t link = sides_[triangle][side], other = triangle_of(link);
  crossed_[triangle] &= static_cast<std::uint8_t>(~(1U << side));
  crossed_[other] &= static_cast<std::uint8_t>(~(1U << side_of(link)));
  beside_[triangle] ^= other + 1;
  beside_[other] ^= triangle + 1;
}

// Whether triangles that cross these sides go around the same corner, at the one side of either where they meet.
int Runs::turn_at(std::uint8_t crossed, std::uint32_t side, std::uint8_t crossed_there, std::uint32_t side_there) {
  const int one = pivots[crossed][side], other = pivots[crossed_there][side_there];
  return one != 0 && one + other == 3 ? turn_cost : 0;
}

// The same at a side of a triangle that would cross these.
int Runs::turn_with(std::uint32_t triangle, std::uint32_t side, std::uint8_t crossed) const {
  const std::uint32_t link = sides_[triangle][side];
  return turn_at(crossed, side, crossed_[triangle_of(link)], side_of(link));
}

// What turns cost, at a side and beyond the triangle there, that go if it is not crossed any more.
int Runs::loosened(std::uint32_t triangle, std::uint32_t side) const {
  const std::uint32_t link = sides_[triangle][side];
  const std::uint32_t beyond = triangle_of(link);
  const std::uint8_t rest = crossed_[beyond] & static_cast<std::uint8_t>(~(1U << side_of(link)));
  return turn_with(triangle, side, crossed_[triangle]) +
         (rest != 0 ? turn_with(beyond, lowest[rest], crossed_[beyond]) : 0);
}

// Of a run that goes on over a side of the triangle in which it ends, where the next triangle gives up the side `left` (3: none).
int Runs::cost_of(std::uint32_t t, std::uint32_t side, std::uint32_t left) const {
  const std::uint32_t link = sides_[t][side], u = triangle_of(link);
  const std::uint8_t rest = crossed_[t], kept = crossed_[u] & static_cast<std::uint8_t>(~(1U << left));
  const auto crossed = static_cast<std::uint8_t>(rest | 1U << side);
  const auto crossed_there = static_cast<std::uint8_t>(kept | 1U << side_of(link));
  int cost = turn_at(crossed, side, crossed_there, side_of(link));
  if (rest != 0) cost += turn_with(t, lowest[rest], crossed);
  if (kept != 0) cost += turn_with(u, lowest[kept], crossed_there);
  if (left == 3) return cost - 2 * end_cost;
  return cost - loosened(u, left) - turn_with(u, lowest[kept], crossed_[u]);
}

// From a triangle to the next, and on from there.
bool Runs::is_loop(std::uint32_t first, std::uint32_t next) const {
  std::uint32_t before = first + 1;
  for (std::uint32_t at = next + 1; at != 0;) {
    if (at == first + 1) return true;
    const std::uint32_t beyond = beside_[at - 1] ^ before;
    before = at;
    at = beyond;
  }
  return false;
}

// From the end of a run over an edge to another, which gives up one of its own there if it has two, if that costs no more: changes that
// cost nothing lead to some that save. A change that begins at no end saves next to never.
void Runs::improve() {
  ends_.clear();
  for (std::uint32_t t = 0; t < size(); ++t) {
    if (is_end(t)) ends_.push_back(t);
  }
  std::uint32_t random = 1;
  for (std::size_t step = 0; step < size() * 3 / 4 && !ends_.empty(); ++step) {
    random = random * 1664525U + 1013904223U;
    const std::size_t at = std::uint64_t{random} * ends_.size() >> 32;
    if (is_end(ends_[at])) {
      go_on(ends_[at], random >> 8);
    } else {
      ends_[at] = ends_.back();
      ends_.pop_back();
    }
  }
}

void Runs::go_on(std::uint32_t t, std::uint32_t random) {
  int least = 1;
  std::uint32_t best = none;
  for (std::uint32_t i = 0, side = random % 3; i < 3; ++i, side = side == 2 ? 0 : side + 1) {
    const std::uint32_t link = sides_[t][side];
    if ((crossed_[t] >> side & 1) != 0 || link == none) continue;
    const std::uint8_t there = crossed_[triangle_of(link)];
    const bool is_full = (there & (there - 1)) != 0;
    const std::uint32_t one = is_full ? lowest[there] : 3, other = is_full ? lowest[there & (there - 1)] : 3;
    const auto weigh = [&](std::uint32_t left) {
      const int cost = cost_of(t, side, left);
      if (cost >= least) return;
      least = cost;
      best = side << 2 | left;
    };
    weigh((random & 4) != 0 ? one : other);
    if (is_full) weigh((random & 4) != 0 ? other : one);
  }
  if (best == none) return;
  const std::uint32_t side = best >> 2, left = best & 3, u = triangle_of(sides_[t][side]);
  if (left < 3) part(u, left);
  join(t, side);
  if (is_loop(u, t)) {
    part(t, side);
    if (left < 3) join(u, left);
  } else if (left < 3) {
    ends_.push_back(triangle_of(sides_[u][left]));
  }
}

void Runs::follow(std::uint32_t end, std::vector<std::uint32_t>& triangles) const {
  triangles.clear();
  std::uint32_t before = 0;
  for (std::uint32_t at = end + 1; at != 0;) {
    triangles.push_back(at - 1);
    const std::uint32_t next = beside_[at - 1] ^ before;
    before = at;
    at = next;
  }
}

void Runs::make(std::span<const StripTriangle> triangles) {
  crossed_.assign(triangles.size(), 0);
  find_neighbours(triangles);
  beside_.assign(triangles.size(), 0);
  walk();
  improve();
}

}  // namespace glark::surfel
