// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/strip/edge_flipper.h"

#include "glark/clients/surfel/level/flip_criterion.h"

namespace glark::surfel {
namespace {

constexpr std::size_t most_flips = 8;  // the most flips that save one or two indices

}  // namespace

bool has_corner(const Triangle& triangle, std::uint32_t point) {
  return triangle[0] == point || triangle[1] == point || triangle[2] == point;
}

std::uint32_t opposite_corner(const Triangle& triangle, const Triangle& other) {
  return !has_corner(other, triangle[0]) ? 0 : !has_corner(other, triangle[1]) ? 1 : 2;
}

std::uint32_t pivot_point(const Triangle& a, const Triangle& b, const Triangle& c) {
  for (const std::uint32_t point : b) {
    if (has_corner(a, point) && has_corner(c, point)) return point;
  }
  return b[0];
}

// Returns whether the edge between the triangles may be flipped.
bool EdgeFlipper::may_flip(const Triangle& one, const Triangle& other) const {
  const std::uint32_t k = opposite_corner(one, other);
  return may_flip_edge(positions_[one[k]], positions_[one[(k + 1) % 3]], positions_[other[opposite_corner(other, one)]],
                       positions_[one[(k + 2) % 3]]);
}

// Returns the same for every second edge. The first is the edge after triangle `first`, the last the edge after
// triangle `last`.
bool EdgeFlipper::may_flip_range(std::span<const Triangle> triangles, std::size_t first, std::size_t last) const {
  if ((last - first) / 2 + 1 > most_flips) return false;
  for (std::size_t at = first; at <= last; at += 2) {
    if (!may_flip(triangles[at], triangles[at + 1])) return false;
  }
  return true;
}

// Flips the edge between a triangle and the next one. Does not flip if a triangle beside them has the other diagonal
// already, as on folds of noisy surfaces. The first of the new triangles has the edge to the triangle before.
bool EdgeFlipper::flip(std::span<Triangle> triangles, std::size_t at) const {
  const Triangle one = triangles[at], other = triangles[at + 1];
  const std::uint32_t k = opposite_corner(one, other);
  const std::uint32_t p = one[k], a = one[(k + 1) % 3], b = one[(k + 2) % 3];
  const std::uint32_t d = other[opposite_corner(other, one)];
  const auto has_diagonal = [&](const Triangle& beside) { return has_corner(beside, p) && has_corner(beside, d); };
  if ((at > 0 && has_diagonal(triangles[at - 1])) || (at + 2 < triangles.size() && has_diagonal(triangles[at + 2])))
    return false;
  const bool a_first = at > 0 ? has_corner(triangles[at - 1], a) && has_corner(triangles[at - 1], p)
                              : !(has_corner(triangles[at + 2], a) && has_corner(triangles[at + 2], d));
  triangles[at] = a_first ? Triangle{p, a, d} : Triangle{p, d, b};
  triangles[at + 1] = a_first ? Triangle{p, d, b} : Triangle{p, a, d};
  return true;
}

// Flips every second edge if all of them may be flipped.
bool EdgeFlipper::flip_range(std::span<Triangle> triangles, std::size_t first, std::size_t last) {
  if (!may_flip_range(triangles, first, last)) return false;
  for (std::size_t at = first; at <= last; at += 2) flipped_ += flip(triangles, at) ? 1 : 0;
  return true;
}

void EdgeFlipper::find_swaps(std::span<const Triangle> triangles) {
  sides_.assign(triangles.size(), 0);
  swaps_.clear();
  for (std::size_t i = 1; i + 1 < triangles.size(); ++i) {
    const std::uint32_t pivot = pivot_point(triangles[i - 1], triangles[i], triangles[i + 1]);
    const std::uint32_t tip = opposite_corner(triangles[i], triangles[i - 1]);
    sides_[i] = triangles[i][(tip + 1) % 3] == pivot ? 1 : 0;
    if (i > 1 && sides_[i] == sides_[i - 1]) swaps_.push_back(i - 1);
  }
}

std::size_t EdgeFlipper::run(std::span<Triangle> triangles) {
  flipped_ = 0;
  const std::size_t count = triangles.size();
  if (count < 4) return 0;
  find_swaps(triangles);
  if (swaps_.empty()) return 0;
  const std::size_t first = swaps_.front();
  std::size_t next = flip_range(triangles, (first - 1) % 2, first - 1) ? 1 : 0;  // from the run's begin
  for (; next + 1 < swaps_.size(); ++next) {
    const std::size_t one = swaps_[next], other = swaps_[next + 1];
    if (sides_[one] != sides_[other] && flip_range(triangles, one + 1, other - 1)) ++next;
  }
  if (next < swaps_.size()) {
    const std::size_t last = swaps_.back() + 1;
    flip_range(triangles, last, last + (count - 2 - last) / 2 * 2);  // to the run's end
  }
  return flipped_;
}

}  // namespace glark::surfel
