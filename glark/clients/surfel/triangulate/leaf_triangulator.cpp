// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/triangulate/leaf_triangulator.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace glark::surfel {

// The spacing of a point is the length of its third shortest edge. For points on scan lines, this is the distance to
// the next line.
void LeafTriangulator::measure_spacings() {
  constexpr float far = std::numeric_limits<float>::infinity();
  const std::size_t own = triangulation_.own_count();
  shortest_.assign(own + 1, {far, far, far});  // the last element is for all points of other leaves
  const std::span<const Delaunay::Triangle> triangles = triangulation_.triangles();
  for (std::uint32_t number = 0; number < triangles.size(); ++number) {
    const Delaunay::Triangle& triangle = triangles[number];
    if (!triangulation_.is_inner(triangle) || !triangulation_.delaunay().finite(triangle)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      auto& [first, second, third] = shortest_[std::min<std::size_t>(triangle.corners[k], own)];
      const float squared_length = triangulation_.facet(number).squared_lengths[(k + 2) % 3];
      third = std::min(third, std::max(squared_length, second));
      second = std::min(second, std::max(squared_length, first));
      first = std::min(first, squared_length);
    }
  }
  result_.spacings.clear();
  for (const auto& [first, second, third] : std::span(shortest_).first(own)) {
    constexpr float most_ratio = 25;  // squared; the gap around a group of two or three points is not their spacing
    const float nearby = second < far ? second : first < far ? first : 0;
    result_.spacings.push_back(std::sqrt(std::min(third, most_ratio * nearby)));
  }
}

Candidate LeafTriangulator::candidate_of(std::uint32_t number) const {
  const auto [i, j, k] = triangulation_.triangles()[number].corners;
  const std::uint32_t a = triangulation_.member(i).index, b = triangulation_.member(j).index,
                      c = triangulation_.member(k).index;
  const std::uint32_t low = std::min({a, b, c}), high = std::max({a, b, c});
  const bool reversed = ((a > b) != (b > c)) != (a > c);  // an odd number of exchanges sorts the corners
  return {{low, a ^ b ^ c ^ low ^ high, high},
          reversed,
          triangulation_.is_back_facing(number),
          CandidateState::conflicting};
}

// A triangle with a far point has a boundary edge opposite to it. The edge is kept if it has one of the leaf's own
// points.
void LeafTriangulator::add_boundary_edge(const Delaunay::Triangle& triangle) {
  std::array<std::uint32_t, 2> ends{};
  std::size_t count = 0;
  for (const std::uint32_t corner : triangle.corners) {
    if (corner < triangulation_.member_count() && count < 2) ends[count++] = corner;
  }
  if (count < 2 || std::min(ends[0], ends[1]) >= triangulation_.own_count()) return;
  const auto [low, high] = std::minmax(triangulation_.member(ends[0]).index, triangulation_.member(ends[1]).index);
  result_.candidates.push_back({{low, high, high}, false, false, CandidateState::boundary});
}

void LeafTriangulator::collect_candidates(const InteriorClassifier& classifier) {
  std::vector<Candidate>& candidates = result_.candidates;
  candidates.clear();
  interior_.clear();
  result_.outer = 0;
  const std::span<const Delaunay::Triangle> triangles = triangulation_.triangles();
  for (std::uint32_t number = 0; number < triangles.size(); ++number) {
    const Delaunay::Triangle& triangle = triangles[number];
    if (!triangulation_.delaunay().finite(triangle)) {
      add_boundary_edge(triangle);
    } else if (!triangulation_.is_inner(triangle)) {
      ++result_.outer;
    } else if (!triangulation_.is_interior(triangle)) {
      candidates.push_back(candidate_of(number));
    } else {
      Candidate& candidate = interior_.emplace_back(candidate_of(number));
      candidate.state = classifier.state_of(number, candidate.back_facing);
    }
  }
  result_.shared_count = static_cast<std::uint32_t>(candidates.size());
  std::sort(candidates.begin(), candidates.end(),
            [](const Candidate& a, const Candidate& b) { return is_before(a.corners, b.corners); });
  candidates.insert(candidates.end(), interior_.begin(), interior_.end());
}

const LeafTriangulator::Result& LeafTriangulator::triangulate(std::uint32_t leaf) {
  triangulation_.triangulate(leaf);
  measure_spacings();
  const InteriorClassifier classifier(triangulation_, result_.spacings, reach_);
  result_.flipped = flip_edges_ ? flipper_.flip_for_valence(classifier) : 0;
  collect_candidates(classifier);
  return result_;
}

}  // namespace glark::surfel
