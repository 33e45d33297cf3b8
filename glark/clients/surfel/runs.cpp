// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/runs.h"

#include <algorithm>

namespace glark::surfel {
namespace {

constexpr std::size_t steps = 2;            // of improvement, for each triangle
constexpr int end_cost = 3, turn_cost = 2;  // in half indices: a run costs three on average, a turn one

std::uint32_t hash(std::uint32_t from, std::uint32_t to) {
  const std::uint32_t mixed = from * 0x9E3779B1U ^ to * 0x85EBCA77U;
  return mixed ^ mixed >> 15;
}

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

// Pairs of half-edges that run in opposite directions; those of two triangles on one another are none.
void Runs::find_neighbours(std::span<const StripTriangle> triangles) {
  sides_.assign(triangles.size(), {none, none, none});
  std::size_t size = 64;
  while (size < 4 * triangles.size()) size *= 2;
  table_.assign(size, {none, none, none});
  const auto mask = static_cast<std::uint32_t>(size - 1);
  constexpr std::array<std::uint32_t, 3> next = {1, 2, 0}, before = {2, 0, 1};
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (std::uint32_t side = 0; side < 3; ++side) {
      const std::uint32_t from = triangles[t][next[side]], to = triangles[t][before[side]];
      std::uint32_t at = hash(std::min(from, to), std::max(from, to)) & mask;
      for (; table_[at].link != none; at = (at + 1) & mask) {
        HalfEdge& other = table_[at];
        if (other.from != to || other.to != from) continue;
        if (triangles[triangle_of(other.link)][side_of(other.link)] == triangles[t][side]) continue;
        sides_[triangle_of(other.link)][side_of(other.link)] = t << 2 | side;
        sides_[t][side] = other.link;
        other.from = other.to = none;  // taken
        break;
      }
      if (table_[at].link == none) table_[at] = {from, to, t << 2 | side};
    }
  }
}

void Runs::use(std::uint32_t triangle) {
  used_[triangle] = 1;
  for (const std::uint32_t link : sides_[triangle]) {
    if (link == none) continue;
    const std::uint32_t neighbour = triangle_of(link);
    if (--free_[neighbour] < 2 && used_[neighbour] == 0) lonely_.push_back(neighbour);
  }
}

// Triangles with few neighbours first: they are hard to come by later.
std::uint32_t Runs::next_start() {
  while (!lonely_.empty()) {
    const std::uint32_t last = lonely_.back();
    lonely_.pop_back();
    if (used_[last] == 0) return last;
  }
  while (first_unused_ < used_.size() && used_[first_unused_] != 0) ++first_unused_;
  return first_unused_ < used_.size() ? first_unused_ : none;
}

// To the neighbour with the fewest neighbours that are left; straight on where there is a choice.
void Runs::walk_from(std::uint32_t at) {
  for (std::uint32_t straight = 3;;) {
    std::uint32_t best = none;
    std::uint32_t best_side = 0;
    int best_rank = 0;
    for (std::uint32_t side = 0; side < 3; ++side) {
      const std::uint32_t link = sides_[at][side];
      if (link == none || used_[triangle_of(link)] != 0) continue;
      const int rank = 2 * free_[triangle_of(link)] + (side == straight ? 0 : 1);
      if (best != none && rank >= best_rank) continue;
      best = link;
      best_side = side;
      best_rank = rank;
    }
    if (best == none) return;
    join(at, best_side);
    // Straight on is around the other point of the edge than before.
    const int pivot = pivots[crossed_[at]][best_side];
    straight = pivot == 0 ? 3 : (side_of(best) + (pivot == 1 ? 2 : 1)) % 3;
    at = triangle_of(best);
    use(at);
  }
}

void Runs::walk() {
  used_.assign(size(), 0);
  free_.resize(size());
  lonely_.clear();
  first_unused_ = 0;
  for (std::size_t t = 0; t < size(); ++t) {
    free_[t] = static_cast<std::uint8_t>(
        std::count_if(sides_[t].begin(), sides_[t].end(), [](std::uint32_t link) { return link != none; }));
    if (free_[t] < 2) lonely_.push_back(static_cast<std::uint32_t>(t));
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

// Whether the triangles at a side that is crossed go around the same corner.
int Runs::turns(std::uint32_t triangle, std::uint32_t side) const {
  const std::uint32_t link = sides_[triangle][side];
  const int one = pivots[crossed_[triangle]][side], other = pivots[crossed_[triangle_of(link)]][side_of(link)];
  return one != 0 && one + other == 3 ? turn_cost : 0;
}

// What turns cost, at a side and beyond the triangle there, that go if it is not crossed any more.
int Runs::loosened(std::uint32_t triangle, std::uint32_t side) const {
  const std::uint32_t link = sides_[triangle][side];
  const std::uint32_t beyond = triangle_of(link);
  const std::uint8_t rest = crossed_[beyond] & static_cast<std::uint8_t>(~(1U << side_of(link)));
  return turns(triangle, side) + (rest != 0 ? turns(beyond, lowest[rest]) : 0);
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
  for (std::size_t step = 0; step < steps * size() && !ends_.empty(); ++step) {
    random = random * 1664525U + 1013904223U;
    const std::size_t at = std::uint64_t{random} * ends_.size() >> 32;
    const std::uint32_t t = ends_[at];
    if (!is_end(t)) {
      ends_[at] = ends_.back();
      ends_.pop_back();
      continue;
    }
    const std::uint32_t side = (random >> 12) % 3;
    if ((crossed_[t] >> side & 1) == 0 && sides_[t][side] != none) cross(t, side, (random >> 8 & 1) != 0);
  }
}

void Runs::cross(std::uint32_t t, std::uint32_t side, bool lower) {
  const std::uint32_t u = triangle_of(sides_[t][side]);
  const std::uint8_t mask = crossed_[u], rest = crossed_[t];
  const auto turns_at = [&](std::uint32_t triangle, std::uint8_t at) {
    return at != 0 ? turns(triangle, lowest[at]) : 0;
  };
  int cost = -turns_at(t, rest);
  std::uint32_t left = 3;
  if (is_end(u)) {
    cost -= 2 * end_cost + turns_at(u, mask);
  } else {
    left = lower ? lowest[mask] : lowest[mask & (mask - 1)];
    cost -= loosened(u, left) + turns_at(u, mask & static_cast<std::uint8_t>(~(1U << left)));
    part(u, left);
  }
  const std::uint8_t u_rest = crossed_[u];
  join(t, side);
  cost += turns(t, side) + turns_at(t, rest) + turns_at(u, u_rest);
  if (cost > 0 || is_loop(u, t)) {
    part(t, side);
    if (left < 3) join(u, left);
  } else if (left < 3) {
    ends_.push_back(triangle_of(sides_[u][left]));
  }
}

void Runs::follow(std::uint32_t end, std::vector<std::uint32_t>& triangles) const {
  triangles.assign(1, end);
  std::uint8_t out = crossed_[end];
  while (out != 0) {
    const std::uint32_t link = sides_[triangles.back()][lowest[out]];
    triangles.push_back(triangle_of(link));
    out = crossed_[triangles.back()] & static_cast<std::uint8_t>(~(1U << side_of(link)));
  }
}

void Runs::make(std::span<const StripTriangle> triangles) {
  find_neighbours(triangles);
  crossed_.assign(triangles.size(), 0);
  beside_.assign(triangles.size(), 0);
  walk();
  improve();
}

}  // namespace glark::surfel
