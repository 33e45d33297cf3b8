// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Based on: A. Gueziec et al., Cutting and Stitching: Converting Sets of Polygons to Manifold Surfaces, 2001. The
// corners of all triangles start separate. Then edges of two triangles join them; edges of more triangles join them in
// pairs.
#include "glark/clients/common/mesh/cut_sheets.h"

#include <algorithm>
#include <compare>
#include <numeric>
#include <utility>

#include "glark/clients/common/disjoint_sets.h"
#include "glark/clients/common/mesh/half_edges.h"

namespace glark::common {
namespace {

// A half-edge. The sort key is the two ends of its edge.
struct HalfEdge {
  std::uint64_t edge;  // the upper half is the lesser end
  std::uint32_t corner;
  auto operator<=>(const HalfEdge&) const = default;
};

class Cut {
 public:
  Cut(std::vector<std::uint32_t>& triangles, std::span<const Float4> points, std::span<const std::uint8_t> irregular)
      : triangles_(triangles), points_(points), irregular_(irregular), corners_(triangles.size()) {}

  std::vector<std::uint32_t> run() {
    const std::vector<HalfEdge> half_edges = at_irregular_vertices();
    for (std::size_t begin = 0; begin < half_edges.size();) {
      std::size_t end = begin + 1;
      while (end < half_edges.size() && half_edges[end].edge == half_edges[begin].edge) ++end;
      if (end - begin == 2) {
        join(half_edges[begin].corner, half_edges[begin + 1].corner);
      } else if (end - begin > 2) {
        std::vector<std::uint32_t>& edge = shared_.emplace_back();
        for (std::size_t i = begin; i < end; ++i) edge.push_back(half_edges[i].corner);
      }
      begin = end;
    }
    for (const std::vector<std::uint32_t>& edge : shared_) stitch(edge);
    return number();
  }

  // Returns whether some edge still has more than two triangles. It was stitched before the edges beside it, which tell
  // which of its triangles belong to one sheet.
  bool is_incomplete() const {
    return std::ranges::any_of(shared_, [&](const std::vector<std::uint32_t>& edge) {
      std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
      for (const std::uint32_t corner : edge)
        ends.emplace_back(std::minmax(triangles_[corner], triangles_[next_corner(corner)]));
      std::ranges::sort(ends);
      for (std::size_t i = 2; i < ends.size(); ++i) {
        if (ends[i] == ends[i - 2]) return true;
      }
      return false;
    });
  }

 private:
  // The half-edges at irregular vertices, sorted by edge.
  std::vector<HalfEdge> at_irregular_vertices() const {
    std::vector<HalfEdge> result;
    const auto add = [&](std::uint32_t corner, std::uint32_t a, std::uint32_t b) {
      if ((irregular_[a] | irregular_[b]) != 0)
        result.push_back({std::uint64_t{std::min(a, b)} << 32 | std::max(a, b), corner});
    };
    for (std::uint32_t t = 0; t < triangles_.size(); t += 3) {
      const std::uint32_t a = triangles_[t], b = triangles_[t + 1], c = triangles_[t + 2];
      if ((irregular_[a] | irregular_[b] | irregular_[c]) == 0) continue;
      add(t, a, b);
      add(t + 1, b, c);
      add(t + 2, c, a);
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  bool runs_up(std::uint32_t corner) const { return triangles_[corner] < triangles_[next_corner(corner)]; }

  Float4 normal_of(std::uint32_t corner) const {
    const std::uint32_t t = corner / 3 * 3;
    const Float4 a = points_[triangles_[t]];
    return unit(cross(points_[triangles_[t + 1]] - a, points_[triangles_[t + 2]] - a));
  }

  // Joins the two triangles at the half-edges.
  void join(std::uint32_t a, std::uint32_t b) {
    const bool reversed = triangles_[a] != triangles_[b];
    corners_.join(a, reversed ? next_corner(b) : b);
    corners_.join(next_corner(a), reversed ? b : next_corner(b));
  }

  // Returns at how many ends of their common edge the two triangles already belong to one sheet.
  int ends_together(std::uint32_t a, std::uint32_t b) {
    const bool reversed = triangles_[a] != triangles_[b];
    return (corners_.find(a) == corners_.find(reversed ? next_corner(b) : b) ? 1 : 0) +
           (corners_.find(next_corner(a)) == corners_.find(reversed ? b : next_corner(b)) ? 1 : 0);
  }

  // Joins the half-edges of an edge that has more than two triangles, in pairs of opposite directions. Pairs within one
  // sheet come first: another pairing would connect the sheet to a second one. The other pairs follow, the least bent
  // first.
  void stitch(std::span<const std::uint32_t> edge) {
    struct Pair {
      float bend;
      std::uint32_t a, b;
    };
    std::vector<Pair> pairs;
    for (const std::uint32_t a : edge) {
      for (const std::uint32_t b : edge) {
        if (!runs_up(a) || runs_up(b)) continue;
        pairs.push_back({1 - dot(normal_of(a), normal_of(b)) - 4 * static_cast<float>(ends_together(a, b)), a, b});
      }
    }
    std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& p, const Pair& q) { return p.bend < q.bend; });
    std::vector<std::uint32_t> taken;
    for (const Pair& pair : pairs) {
      if (std::find(taken.begin(), taken.end(), pair.a) != taken.end()) continue;
      if (std::find(taken.begin(), taken.end(), pair.b) != taken.end()) continue;
      join(pair.a, pair.b);
      taken.insert(taken.end(), {pair.a, pair.b});
    }
  }

  // Numbers the vertices. At an irregular vertex, the first set of corners keeps the vertex. Each other set gets a
  // copy.
  std::vector<std::uint32_t> number() {
    std::vector<std::uint32_t> copies(points_.size());
    std::iota(copies.begin(), copies.end(), 0U);
    constexpr std::uint32_t open = 0xFFFFFFFF;
    std::vector<std::uint32_t> keeper(points_.size(), open), result = triangles_;
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
      if (irregular_[triangles_[i]] == 0) continue;
      const std::uint32_t root = corners_.find(i);
      if (root != i) {
        result[i] = result[root];
      } else if (keeper[triangles_[i]] == open) {
        keeper[triangles_[i]] = i;
      } else {
        result[i] = static_cast<std::uint32_t>(copies.size());
        copies.push_back(triangles_[i]);
      }
    }
    triangles_ = std::move(result);
    return copies;
  }

  std::vector<std::uint32_t>& triangles_;
  std::span<const Float4> points_;
  std::span<const std::uint8_t> irregular_;
  DisjointSets corners_;
  std::vector<std::vector<std::uint32_t>> shared_;  // the half-edges of each edge of more than two triangles
};

}  // namespace

std::vector<std::uint32_t> cut_sheets(std::vector<std::uint32_t>& triangles, std::span<const Float4> points,
                                      std::span<const std::uint8_t> irregular) {
  constexpr int most_rounds = 4;
  Cut cut(triangles, points, irregular);
  std::vector<std::uint32_t> originals = cut.run();
  bool again = cut.is_incomplete();
  for (int round = 1; again && round < most_rounds; ++round) {
    std::vector<Float4> all;
    std::vector<std::uint8_t> flags;
    for (const std::uint32_t original : originals) {
      all.push_back(points[original]);
      flags.push_back(irregular[original]);
    }
    Cut next(triangles, all, flags);
    std::vector<std::uint32_t> copied = next.run();
    again = next.is_incomplete() && copied.size() > originals.size();
    for (std::uint32_t& vertex : copied) vertex = originals[vertex];
    originals = std::move(copied);
  }
  return originals;
}

void move_apart(std::span<Float4> points, std::span<const std::uint32_t> triangles,
                std::span<const std::uint32_t> originals, float share) {
  std::vector<bool> is_shared(points.size());
  bool any = false;
  for (std::size_t i = 0; i < originals.size(); ++i) {
    if (originals[i] == i) continue;
    is_shared[i] = is_shared[originals[i]] = any = true;
  }
  if (!any) return;
  std::vector<Float4> sums(points.size());
  for (std::size_t t = 0; t < triangles.size(); t += 3) {
    const std::uint32_t* const v = &triangles[t];
    if (!is_shared[v[0]] && !is_shared[v[1]] && !is_shared[v[2]]) continue;
    Float4 middle = without_fourth(points[v[0]] + points[v[1]] + points[v[2]]) / 3;
    middle[3] = 1;
    for (int i = 0; i < 3; ++i) sums[v[i]] += middle;
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (is_shared[i] && sums[i][3] > 0) points[i] += (without_fourth(sums[i] / sums[i][3]) - points[i]) * share;
  }
}

}  // namespace glark::common
