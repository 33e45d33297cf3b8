// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Based on: A. Gueziec et al., Cutting and Stitching: Converting Sets of Polygons to Manifold Surfaces, 2001: vertices are cut apart
// and put together again only across edges of which two triangles are known to be neighbours.
#include <algorithm>
#include <array>
#include <numeric>

#include "glark/clients/vstree/disjoint_sets.h"
#include "glark/clients/vstree/reindex.h"

namespace glark::vstree {
namespace {

// Corner i of the triangles starts the half-edge to the next corner of its triangle.
std::uint32_t next_corner(std::uint32_t i) { return i % 3 == 2 ? i - 2 : i + 1; }

// Half-edges in lists by their lesser end, which are short.
class HalfEdges {
 public:
  HalfEdges(std::span<const std::uint32_t> triangles, std::size_t vertices)
      : triangles_(triangles), begins_(vertices + 2), all_(triangles.size()) {
    const auto for_each = [&](const auto& work) {
      for (std::uint32_t t = 0; t < triangles.size(); t += 3) {
        const std::uint32_t a = triangles[t], b = triangles[t + 1], c = triangles[t + 2];
        work(t, std::min(a, b), std::max(a, b));
        work(t + 1, std::min(b, c), std::max(b, c));
        work(t + 2, std::min(c, a), std::max(c, a));
      }
    };
    for_each([&](std::uint32_t, std::uint32_t lesser, std::uint32_t) { ++begins_[lesser + 2]; });
    std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
    for_each([&](std::uint32_t corner, std::uint32_t lesser, std::uint32_t greater) {
      all_[begins_[lesser + 1]++] = std::uint64_t{greater} << 32 | corner;
    });
  }

  // Those of one edge one after the other, by its greater end in the upper half; the corner that starts it is the lower half.
  std::span<const std::uint64_t> with_lesser_end(std::uint32_t vertex) {
    const std::span<std::uint64_t> list =
        std::span(all_).subspan(begins_[vertex], begins_[vertex + 1] - begins_[vertex]);
    std::sort(list.begin(), list.end());
    return list;
  }
  bool runs_up(std::uint32_t corner) const { return triangles_[corner] < triangles_[next_corner(corner)]; }

 private:
  std::span<const std::uint32_t> triangles_;
  std::vector<std::uint32_t> begins_;
  std::vector<std::uint64_t> all_;
};

class Cut {
 public:
  Cut(std::vector<std::uint32_t>& triangles, std::span<const Float4> points)
      : triangles_(triangles), points_(points), corners_(triangles.size()) {}

  std::vector<std::uint32_t> run() {
    HalfEdges half_edges(triangles_, points_.size());
    std::vector<std::vector<std::uint32_t>> shared;  // edges of more than two triangles
    for (std::uint32_t vertex = 0; vertex < points_.size(); ++vertex) {
      const std::span<const std::uint64_t> list = half_edges.with_lesser_end(vertex);
      for (std::size_t begin = 0; begin < list.size();) {
        std::size_t end = begin + 1;
        while (end < list.size() && list[end] >> 32 == list[begin] >> 32) ++end;
        if (end - begin == 2) {
          join(static_cast<std::uint32_t>(list[begin]), static_cast<std::uint32_t>(list[begin + 1]));
        } else if (end - begin > 2) {
          std::vector<std::uint32_t>& edge = shared.emplace_back();
          for (; begin < end; ++begin) edge.push_back(static_cast<std::uint32_t>(list[begin]));
        }
        begin = end;
      }
    }
    for (const std::vector<std::uint32_t>& edge : shared) stitch(edge, half_edges);
    return number();
  }

 private:
  Float4 normal_of(std::uint32_t corner) const {
    const std::uint32_t t = corner / 3 * 3;
    const Float4 a = points_[triangles_[t]];
    return unit(cross(points_[triangles_[t + 1]] - a, points_[triangles_[t + 2]] - a));
  }

  // The triangles at the half-edges become neighbours.
  void join(std::uint32_t a, std::uint32_t b) {
    const bool reversed = triangles_[a] != triangles_[b];
    corners_.join(a, reversed ? next_corner(b) : b);
    corners_.join(next_corner(a), reversed ? b : next_corner(b));
  }

  // At how many ends of their edge two triangles belong to one sheet already.
  int ends_together(std::uint32_t a, std::uint32_t b) {
    const bool reversed = triangles_[a] != triangles_[b];
    return (corners_.find(a) == corners_.find(reversed ? next_corner(b) : b) ? 1 : 0) +
           (corners_.find(next_corner(a)) == corners_.find(reversed ? b : next_corner(b)) ? 1 : 0);
  }

  // More than two half-edges of one edge, in pairs that run against each other: first those of one sheet, which another pairing would
  // connect with another sheet, then those whose triangles bend least.
  void stitch(std::span<const std::uint32_t> edge, const HalfEdges& half_edges) {
    struct Pair {
      float bend;
      std::uint32_t a, b;
    };
    std::vector<Pair> pairs;
    for (const std::uint32_t a : edge) {
      for (const std::uint32_t b : edge) {
        if (!half_edges.runs_up(a) || half_edges.runs_up(b)) continue;
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

  // The first set of corners at a vertex keeps it, the others get a copy.
  std::vector<std::uint32_t> number() {
    std::vector<std::uint32_t> copies(points_.size());
    std::iota(copies.begin(), copies.end(), 0U);
    constexpr std::uint32_t open = 0xFFFFFFFF;
    std::vector<std::uint32_t> keeper(points_.size(), open), result(triangles_.size());
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
      const std::uint32_t root = corners_.find(i);
      if (root != i) {
        result[i] = result[root];
      } else if (keeper[triangles_[i]] == open) {
        keeper[triangles_[i]] = i;
        result[i] = triangles_[i];
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
  DisjointSets corners_;
};

}  // namespace

std::vector<std::uint32_t> cut(std::vector<std::uint32_t>& triangles, std::span<const Float4> points) {
  return Cut(triangles, points).run();
}

}  // namespace glark::vstree
