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
// A cotangent of edges that stay, whatever is across: a triangle without area may have angles below any number.
constexpr float none_better = std::numeric_limits<float>::infinity();

// The sum of the cotangents of the angles opposite to edge ab in triangles abp and abd: negative where Delaunay's criterion fails.
float cotangents(Vector a, Vector b, Vector p, Vector d) {
  const auto cotangent = [&](Vector at) {
    const Vector s = a - at, t = b - at;
    return dot(s, t) / std::max(length(cross(s, t)), std::numeric_limits<float>::min());
  };
  return cotangent(p) + cotangent(d);
}

}  // namespace

float spacing_of(float a, float b, float c) {
  const float middle = std::max(std::min(a, b), std::min(std::max(a, b), c));
  constexpr float sparser = 3;  // two isolated points have no triangle with one that is none
  return std::min(middle, sparser * std::min({a, b, c}));
}

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

// The coordinates in the leaf's frame of which own points have the bounds: those of the plane, at 45 degrees to these, and the height.
std::array<float, 5> Patcher::slabs_of(Vector position) const {
  const Vector d = position - centre_;
  const float x = dot(d, u_), y = dot(d, v_);
  constexpr float diagonal = 0.70710678F;
  return {x, y, (x + y) * diagonal, (x - y) * diagonal, dot(d, normal_)};
}

void Patcher::inflate(std::uint32_t number) {
  const Leaf& leaf = tree_.leaves[number];
  const Box& box = tree_.nodes[leaf.node].box;
  members_.clear();
  const auto take = [&](const Surfel& surfel) { members_.push_back({surfel.position, surfel.index, surfel.normal}); };
  centre_ = leaf.centre;
  normal_ = leaf.normal;
  u_ = perpendicular(leaf.normal);
  v_ = cross(leaf.normal, u_);
  std::array<float, 5> low, high;
  low.fill(Box::far);
  high.fill(-Box::far);
  for (const Surfel& surfel : tree_.used(leaf)) {
    take(surfel);
    const std::array<float, 5> at = slabs_of(surfel.position);
    for (std::size_t k = 0; k < at.size(); ++k) {
      low[k] = std::min(low[k], at[k]);
      high[k] = std::max(high[k], at[k]);
    }
  }
  own_ = members_.size();
  neighbours(tree_, number, neighbours_);
  for (const std::uint32_t other : neighbours_) {
    const Leaf& neighbour = tree_.leaves[other];
    const float band = std::max(leaf.band, neighbour.band);
    const std::span<const Surfel> used = tree_.used(neighbour);  // ascending by x
    auto surfel = std::partition_point(used.begin(), used.end(),
                                       [&](const Surfel& s) { return s.position.x < box.low.x - band; });
    for (; surfel != used.end() && surfel->position.x <= box.high.x + band; ++surfel) {
      if (squared_distance(box, surfel->position) > band * band) continue;
      const std::array<float, 5> at = slabs_of(surfel->position);
      bool near = true;
      for (std::size_t k = 0; k < at.size(); ++k) near = near && at[k] >= low[k] - band && at[k] <= high[k] + band;
      if (!near || (!(surfel->normal == Vector{}) && dot(surfel->normal, leaf.normal) < opposite)) continue;
      take(*surfel);
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
  const float now = cotangents(a->position, b->position, p->position, d->position);
  const float other = cotangents(p->position, d->position, a->position, b->position);
  return other > now || (other == now && p->index < a->index);
}

void Patcher::measure_angles(std::uint32_t number) {
  const auto [a, b, c] = delaunay_.triangles()[number].corners;
  angles_[number].fill(none_better);
  if (std::max({a, b, c}) >= members_.size()) return;
  const Vector p = members_[a].position, q = members_[b].position, r = members_[c].position;
  const Vector pq = q - p, qr = r - q, rp = p - r;
  const float scale = -1 / std::max(length(cross(pq, rp)), std::numeric_limits<float>::min());
  angles_[number] = {dot(pq, rp) * scale, dot(qr, pq) * scale, dot(rp, qr) * scale};
}

void Patcher::turn(std::uint32_t number, std::uint32_t side) {
  const Delaunay::Triangle& triangle = delaunay_.triangles()[number];
  const std::uint32_t other = Delaunay::triangle_of(triangle.links[side]);
  const std::uint32_t nearest = std::min({triangle.corners[0], triangle.corners[1], triangle.corners[2]});
  if (nearest >= own_ && delaunay_.across(number, side) >= own_) return;
  if (!prefers_other_diagonal(number, side) || !delaunay_.can_flip(number, side)) return;
  pending_.push_back(number);
  pending_.push_back(other);
  delaunay_.flip(number, side);
  measure_angles(number);
  measure_angles(other);
}

bool Patcher::is_inner(const Delaunay::Triangle& triangle) const {
  return std::min({triangle.corners[0], triangle.corners[1], triangle.corners[2]}) < own_;
}

// Whether Delaunay's criterion does not hold by far; if it does, there is no better diagonal.
bool Patcher::may_turn(std::uint32_t number, std::uint32_t link, std::uint32_t side) const {
  constexpr float by_far = 0.7F;  // the sum of the cotangents of two angles of 70 degrees
  return link != Delaunay::none &&
         angles_[number][side] + angles_[Delaunay::triangle_of(link)][Delaunay::side_of(link)] < by_far;
}

// Delaunay's criterion once more, for the triangles in space: planes of neighbouring leaves differ, the points do not.
void Patcher::relax() {
  pending_.clear();
  const auto count = static_cast<std::uint32_t>(delaunay_.triangles().size());
  angles_.resize(count);
  // What is two triangles away from the leaf's points is of no use to it.
  inner_.resize(count);
  for (std::uint32_t number = 0; number < count; ++number)
    inner_[number] = is_inner(delaunay_.triangles()[number]) ? 1 : 0;
  const auto is_near = [&](std::uint32_t link) {
    return link != Delaunay::none && inner_[Delaunay::triangle_of(link)] != 0;
  };
  for (std::uint32_t number = 0; number < count; ++number) {
    const auto& links = delaunay_.triangles()[number].links;
    if (inner_[number] != 0 || std::any_of(links.begin(), links.end(), is_near)) {
      measure_angles(number);
    } else {
      angles_[number].fill(none_better);
    }
  }
  for (std::uint32_t number = 0; number < count; ++number) {
    for (std::uint32_t side = 0; side < 3; ++side) {
      const std::uint32_t link = delaunay_.triangles()[number].links[side];
      if (Delaunay::triangle_of(link) > number && may_turn(number, link, side)) turn(number, side);
    }
  }
  // Around those that were turned; in space edges could turn for ever.
  for (std::size_t next = 0; next < pending_.size() && pending_.size() < most_turned; ++next) {
    for (std::uint32_t side = 0; side < 3; ++side) {
      const std::uint32_t number = pending_[next];
      if (may_turn(number, delaunay_.triangles()[number].links[side], side)) turn(number, side);
    }
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

// Of a triangle that no other leaf can have, all is known.
State Patcher::state_of_interior(const Delaunay::Triangle& triangle, bool away) const {
  const auto [a, b, c] = triangle.corners;
  const Vector p = members_[a].position, q = members_[b].position, r = members_[c].position;
  const float most = reach_ * spacing_of(spacings[a], spacings[b], spacings[c]);
  if (std::max({dot(p - q, p - q), dot(q - r, q - r), dot(r - p, r - p)}) > most * most) return State::out_of_reach;
  return away ? State::rejected : State::agreed;
}

void Patcher::collect() {
  candidates.clear();
  interior_.clear();
  outer = 0;
  for (const Delaunay::Triangle& triangle : delaunay_.triangles()) {
    const auto [a, b, c] = triangle.corners;
    if (!delaunay_.finite(triangle)) {
      collect_rim(triangle);
      continue;
    }
    if (std::min({a, b, c}) >= own_) {
      ++outer;
      continue;
    }
    Candidate candidate{
        {members_[a].index, members_[b].index, members_[c].index}, false, faces_away(triangle), State::contested};
    auto& [low, middle, high] = candidate.corners;
    const auto sort_two = [&](std::uint32_t& first, std::uint32_t& second) {
      if (first < second) return;
      std::swap(first, second);
      candidate.reversed = !candidate.reversed;
    };
    sort_two(low, middle);
    sort_two(middle, high);
    sort_two(low, middle);
    if (std::max({a, b, c}) < own_) {
      candidate.state = state_of_interior(triangle, candidate.away);
      interior_.push_back(candidate);
    } else {
      candidates.push_back(candidate);
    }
  }
  shared = static_cast<std::uint32_t>(candidates.size());
  std::sort(candidates.begin(), candidates.end(),
            [](const Candidate& a, const Candidate& b) { return a.corners < b.corners; });
  candidates.insert(candidates.end(), interior_.begin(), interior_.end());
}

// The third shortest edge: of points on scan lines, that to the next line.
void Patcher::measure_spacings() {
  constexpr float far = std::numeric_limits<float>::infinity();
  shortest_.assign(own_, {far, far, far});
  for (const Delaunay::Triangle& triangle : delaunay_.triangles()) {
    if (!is_inner(triangle) || !delaunay_.finite(triangle)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = triangle.corners[k];
      if (from >= own_) continue;
      const Vector edge = members_[triangle.corners[(k + 1) % 3]].position - members_[from].position;
      const float size = dot(edge, edge);
      auto& [first, second, third] = shortest_[from];
      if (!(size < third)) continue;
      third = std::max(size, second);
      second = std::max(first, std::min(size, second));
      first = std::min(first, size);
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
  delaunay_.triangulate(points_, own_);
  relax();
  measure_spacings();
  collect();
}

}  // namespace glark::surfel
