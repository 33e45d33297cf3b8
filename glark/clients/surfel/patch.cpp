// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/patch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace glark::surfel {
namespace {

constexpr float opposite = -0.5F;         // the cosine to the leaf's normal below which a point is of another sheet
constexpr std::size_t most_taken = 256;   // points that a leaf takes in, for one that is sparse among dense ones
constexpr std::size_t most_turned = 256;  // edges

// The sum of the cotangents of the angles opposite to edge ab in triangles abp and abd: negative where Delaunay's criterion fails.
float cotangents(Vector a, Vector b, Vector p, Vector d) {
  const auto cotangent = [&](Vector at) {
    const Vector s = a - at, t = b - at;
    return dot(s, t) / std::max(length(cross(s, t)), std::numeric_limits<float>::min());
  };
  return cotangent(p) + cotangent(d);
}

// Whether the angles of abp and abd at p and d are below 60 degrees: then no other diagonal is better, on any plane.
bool surely_delaunay(Vector a, Vector b, Vector p, Vector d) {
  const auto narrow = [&](Vector at) {
    const Vector s = a - at, t = b - at;
    const float cosine = dot(s, t);
    return cosine > 0 && 4 * cosine * cosine > dot(s, s) * dot(t, t);
  };
  return narrow(p) && narrow(d);
}

}  // namespace

void Patcher::neighbours(const StrippingTree& tree, std::uint32_t number, std::vector<std::uint32_t>& found) {
  const Leaf& leaf = tree.leaves[number];
  const Box& box = tree.nodes[leaf.node].box;
  found.clear();
  if (leaf.used == 0) return;
  std::array<std::uint32_t, 128> stack;
  std::vector<std::uint32_t> deeper;  // trees of clouds that are anything but uniform
  std::size_t height = 0;
  const auto push = [&](std::uint32_t node) {
    height < stack.size() ? void(stack[height++] = node) : deeper.push_back(node);
  };
  push(0);
  while (height > 0 || !deeper.empty()) {
    std::uint32_t at = 0;
    if (!deeper.empty()) {
      at = deeper.back();
      deeper.pop_back();
    } else {
      at = stack[--height];
    }
    const TreeNode& node = tree.nodes[at];
    const float band = std::max(leaf.band, node.band);
    if (node.used == 0 || squared_distance(box, node.box) > band * band) continue;
    if (node.leaf == none) {
      push(node.right);
      push(node.left);
    } else if (node.leaf != number) {
      found.push_back(node.leaf);
    }
  }
}

void Patcher::inflate(std::uint32_t number) {
  const Leaf& leaf = tree_.leaves[number];
  const Box& box = tree_.nodes[leaf.node].box;
  members_.clear();
  const auto take = [&](const Surfel& surfel) { members_.push_back({surfel.position, surfel.index, surfel.normal}); };
  for (const Surfel& surfel : tree_.used(leaf)) take(surfel);
  own_ = members_.size();
  neighbours(tree_, number, neighbours_);
  for (const std::uint32_t other : neighbours_) {
    const Leaf& neighbour = tree_.leaves[other];
    const float band = std::max(leaf.band, neighbour.band);
    for (const Surfel& surfel : tree_.used(neighbour)) {
      if (squared_distance(box, surfel.position) > band * band) continue;
      if (!(surfel.normal == Vector{}) && dot(surfel.normal, leaf.normal) < opposite) continue;
      take(surfel);
    }
  }
  if (members_.size() <= own_ + most_taken) return;
  const auto from = members_.begin() + static_cast<std::ptrdiff_t>(own_);
  std::nth_element(from, from + most_taken, members_.end(), [&](const Member& a, const Member& b) {
    return std::pair(squared_distance(box, a.position), a.index) <
           std::pair(squared_distance(box, b.position), b.index);
  });
  members_.resize(own_ + most_taken);
}

// Onto the leaf's plane; what bends away is unrolled, for as far as it bends about the leaf: a wall at a right angle stays a wall, not
// a line. So a crease is covered from either side, and leaves of different planes agree on more edges.
void Patcher::project(const Leaf& leaf) {
  const Vector u = perpendicular(leaf.normal), v = cross(leaf.normal, u);
  plane_.clear();
  float farthest = 0;
  for (const Member& member : members_) {
    const Vector d = member.position - leaf.centre;
    const float height = std::fabs(dot(d, leaf.normal));
    std::array<float, 2> at = {dot(d, u), dot(d, v)};
    const float radius = std::sqrt(at[0] * at[0] + at[1] * at[1]);
    const float cosine = member.normal == Vector{} ? 1.0F : std::clamp(dot(member.normal, leaf.normal), opposite, 1.0F);
    if (radius > 0) {
      const float unrolled = 1 + height / radius * std::sqrt((1 - cosine) / (1 + cosine));
      at = {at[0] * unrolled, at[1] * unrolled};
    }
    farthest = std::max({farthest, std::fabs(at[0]), std::fabs(at[1])});
    plane_.push_back(at);
  }
  const double scale = farthest > 0 ? Delaunay::greatest / double{farthest} : 0;
  points_.clear();
  for (const auto& [x, y] : plane_) {
    points_.push_back(
        {static_cast<std::int32_t>(std::lrint(x * scale)), static_cast<std::int32_t>(std::lrint(y * scale))});
  }
}

// By the four points' positions alone, so that all leaves choose alike; of diagonals that are equal, the one of the first point.
bool Patcher::prefers_other_diagonal(std::uint32_t number, std::uint32_t side) const {
  const auto& corners = delaunay_.triangles()[number].corners;
  const auto member = [&](std::uint32_t i) { return &members_[i]; };
  const Member* p = member(corners[side]);
  const Member* d = member(delaunay_.across(number, side));
  const Member* a = member(corners[(side + 1) % 3]);
  const Member* b = member(corners[(side + 2) % 3]);
  if (a->index > b->index) std::swap(a, b);
  if (p->index > d->index) std::swap(p, d);
  if (surely_delaunay(a->position, b->position, p->position, d->position)) return false;
  const float now = cotangents(a->position, b->position, p->position, d->position);
  const float other = cotangents(p->position, d->position, a->position, b->position);
  return other > now || (other == now && p->index < a->index);
}

bool Patcher::turn(std::uint32_t number, std::uint32_t side) {
  const Delaunay::Triangle& triangle = delaunay_.triangles()[number];
  const std::uint32_t other = triangle.neighbours[side];
  if (other == Delaunay::none || !delaunay_.finite(delaunay_.triangles()[other])) return false;
  const std::uint32_t nearest = std::min({triangle.corners[0], triangle.corners[1], triangle.corners[2]});
  if (nearest >= own_ && delaunay_.across(number, side) >= own_) return false;
  if (!prefers_other_diagonal(number, side) || !delaunay_.can_flip(number, side)) return false;
  pending_.push_back(number);
  pending_.push_back(other);
  delaunay_.flip(number, side);
  return true;
}

// Delaunay's criterion once more, for the triangles in space: planes of neighbouring leaves differ, the points do not.
void Patcher::relax() {
  pending_.clear();
  const auto count = static_cast<std::uint32_t>(delaunay_.triangles().size());
  for (std::uint32_t number = 0; number < count; ++number) {
    for (std::uint32_t side = 0; side < 3; ++side) {
      const Delaunay::Triangle& triangle = delaunay_.triangles()[number];
      if (triangle.neighbours[side] > number && delaunay_.finite(triangle)) turn(number, side);
    }
  }
  // Around those that were turned; in space edges could turn for ever.
  for (std::size_t next = 0; next < pending_.size() && pending_.size() < most_turned; ++next) {
    for (std::uint32_t side = 0; side < 3; ++side) turn(pending_[next], side);
  }
}

// At sharp creases a triangle can be the wrong way round in the leaf's plane: the points' normals know better.
bool Patcher::faces_away(const Delaunay::Triangle& triangle) const {
  const Member& a = members_[triangle.corners[0]];
  const Member& b = members_[triangle.corners[1]];
  const Member& c = members_[triangle.corners[2]];
  const Vector normal = cross(b.position - a.position, c.position - a.position);
  return dot(normal, a.normal + b.normal + c.normal) < 0;
}

// Of a triangle that reaches beyond all points, the edge that does not, if it is one of the leaf's points.
void Patcher::collect_rim(const Delaunay::Triangle& triangle) {
  std::array<std::uint32_t, 2> ends{};
  std::size_t count = 0;
  for (const std::uint32_t corner : triangle.corners) {
    if (corner < members_.size() && count < 2) ends[count++] = corner;
  }
  if (count < 2 || std::min(ends[0], ends[1]) >= own_) return;
  const auto [low, high] = std::minmax(members_[ends[0]].index, members_[ends[1]].index);
  candidates.push_back({{low, high, high}, false, false, State::rim});
}

void Patcher::collect() {
  candidates.clear();
  outer = 0;
  const auto triangles = delaunay_.triangles();
  for (std::uint32_t number = 0; number < triangles.size(); ++number) {
    const Delaunay::Triangle& triangle = triangles[number];
    if (!delaunay_.finite(triangle)) {
      collect_rim(triangle);
      continue;
    }
    if (*std::min_element(triangle.corners.begin(), triangle.corners.end()) >= own_) {
      ++outer;
      continue;
    }
    Candidate candidate{};
    candidate.away = faces_away(triangle);
    std::array<std::uint32_t, 3> order = {0, 1, 2};
    const auto index = [&](std::uint32_t i) { return members_[triangle.corners[i]].index; };
    const auto sort_two = [&](std::uint32_t i, std::uint32_t j) {
      if (index(order[i]) < index(order[j])) return;
      std::swap(order[i], order[j]);
      candidate.reversed = !candidate.reversed;
    };
    sort_two(0, 1);
    sort_two(1, 2);
    sort_two(0, 1);
    for (std::size_t k = 0; k < 3; ++k) {
      candidate.corners[k] = index(order[k]);
    }
    candidates.push_back(candidate);
  }
  std::sort(candidates.begin(), candidates.end(),
            [](const Candidate& a, const Candidate& b) { return a.corners < b.corners; });
}

// The third shortest edge: of points on scan lines, that to the next line.
void Patcher::measure_spacings() {
  constexpr float far = std::numeric_limits<float>::infinity();
  shortest_.assign(own_, {far, far, far});
  for (const Delaunay::Triangle& triangle : delaunay_.triangles()) {
    if (!delaunay_.finite(triangle)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = triangle.corners[k];
      if (from >= own_) continue;
      const Vector edge = members_[triangle.corners[(k + 1) % 3]].position - members_[from].position;
      float size = dot(edge, edge);
      for (float& kept : shortest_[from]) {
        if (size < kept) std::swap(size, kept);
      }
    }
  }
  spacings.clear();
  for (const std::array<float, 3>& three : shortest_) {
    constexpr float most = 25;  // squared: a gap around two or three points is not their distance
    const float second = three[1] < far ? three[1] : three[0] < far ? three[0] : 0;
    spacings.push_back(std::sqrt(std::min(three[2], most * second)));
  }
}

void Patcher::make(std::uint32_t number) {
  inflate(number);
  project(tree_.leaves[number]);
  delaunay_.triangulate(points_);
  relax();
  collect();
  measure_spacings();
}

}  // namespace glark::surfel
