// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/vstree/normals/orientation.h"

#include <algorithm>
#include <bit>

#include "glark/clients/common/disjoint_sets.h"

namespace glark::vstree {
namespace {

// Sets of connected samples. Each sample is reversed or not, relative to the first sample of its set. Number i stands
// for sample i as it is, and number count + i for the reversed sample. So each set has a mirror image.
class Parts {
 public:
  explicit Parts(std::size_t count) : count_(static_cast<std::uint32_t>(count)), sets_(2 * count) {}

  struct Place {
    std::uint32_t root;  // the first sample of the set
    bool reversed;
  };
  Place find(std::uint32_t i) {
    const std::uint32_t as_it_is = sets_.find(i), reversed = sets_.find(i + count_);
    return as_it_is < reversed ? Place{as_it_is, false} : Place{reversed, true};
  }

  // Connects two samples. `reversed`: one is reversed relative to the other. Returns false and changes nothing if they
  // are connected already.
  bool connect(std::uint32_t a, std::uint32_t b, bool reversed) {
    const std::uint32_t root = sets_.find(a);
    if (root == sets_.find(b) || root == sets_.find(b + count_)) return false;
    sets_.join(a, reversed ? b + count_ : b);
    sets_.join(a + count_, reversed ? b : b + count_);
    return true;
  }

 private:
  std::uint32_t count_;
  common::DisjointSets sets_;
};

struct Edge {
  float weight;
  std::uint32_t from, to;
};

// A stable sort by weight. Weights are not negative.
void sort_by_weight(std::vector<Edge>& edges) {
  std::vector<std::uint64_t> keys(edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i)
    keys[i] = std::uint64_t{std::bit_cast<std::uint32_t>(edges[i].weight)} << 32 | i;
  std::sort(keys.begin(), keys.end());
  std::vector<Edge> sorted(edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) sorted[i] = edges[keys[i] & 0xFFFFFFFFU];
  edges = std::move(sorted);
}

// Adds the edges that may be in the minimum spanning tree: the spanning trees within a run of samples, and all edges
// that leave the run. Near samples have near indices. So a run stays in the cache, and few edges leave it.
void add_edges(std::span<const Float4> normals, std::span<const std::uint32_t> neighbours, std::size_t each,
               std::uint32_t begin, std::uint32_t end, std::vector<Edge>& edges) {
  std::vector<Edge> within;
  for (std::uint32_t i = begin; i < end; ++i) {
    for (const std::uint32_t k : neighbours.subspan(i * each, each)) {
      const std::span<const std::uint32_t> theirs = neighbours.subspan(k * each, each);
      if (k == i || (k < i && std::find(theirs.begin(), theirs.end(), i) != theirs.end())) continue;  // each edge once
      const float weight = std::max(0.0F, 1 - std::abs(dot(normals[i], normals[k])));
      (k >= begin && k < end ? within : edges).push_back({weight, i, k});
    }
  }
  sort_by_weight(within);
  Parts parts(end - begin);
  for (const Edge& edge : within) {
    if (parts.connect(edge.from - begin, edge.to - begin, false)) edges.push_back(edge);
  }
}

std::vector<Edge> edges_of(std::span<const Float4> normals, std::span<const std::uint32_t> neighbours, std::size_t each,
                           const Workers& workers) {
  constexpr std::size_t run = 1 << 13;
  std::vector<std::vector<Edge>> runs((normals.size() + run - 1) / run);
  workers.in_pieces(normals.size(), run, [&](std::size_t begin, std::size_t end) {
    add_edges(normals, neighbours, each, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end),
              runs[begin / run]);
  });
  std::vector<Edge> edges;
  for (std::vector<Edge>& some : runs) {
    edges.insert(edges.end(), some.begin(), some.end());
    some = {};
  }
  sort_by_weight(edges);
  return edges;
}

// Returns for each part, indexed by its root, whether its normals must be reversed.
std::vector<bool> reversed_parts(Parts& parts, std::span<const Float4> points, std::span<const Float4> normals,
                                 const std::vector<bool>& given) {
  std::vector<std::uint32_t> leader(points.size(), 0xFFFFFFFF);
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    std::uint32_t& best = leader[parts.find(i).root];
    const bool none_yet = best == 0xFFFFFFFF;
    if (none_yet || (given[i] && !given[best]) || (given[i] == given[best] && points[i][2] > points[best][2])) best = i;
  }
  std::vector<bool> reversed(points.size());
  for (std::uint32_t root = 0; root < points.size(); ++root) {
    const std::uint32_t i = leader[root];
    if (i == 0xFFFFFFFF) continue;
    const bool right = given[i] || normals[i][2] >= 0;
    reversed[root] = right ? parts.find(i).reversed : !parts.find(i).reversed;
  }
  return reversed;
}

}  // namespace

void orient(std::span<const Float4> points, std::span<Float4> normals, std::span<const std::uint32_t> neighbours,
            std::size_t each, const std::vector<bool>& given, const Workers& workers) {
  Parts parts(points.size());
  std::uint32_t first_given = 0xFFFFFFFF;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (!given[i]) continue;
    if (first_given == 0xFFFFFFFF) first_given = i;
    parts.connect(first_given, i, false);
  }
  for (const Edge& edge : edges_of(normals, neighbours, each, workers))
    parts.connect(edge.from, edge.to, dot(normals[edge.from], normals[edge.to]) < 0);
  const std::vector<bool> reversed = reversed_parts(parts, points, normals, given);
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const Parts::Place place = parts.find(i);
    if (place.reversed != reversed[place.root]) normals[i] = -normals[i];
  }
}

}  // namespace glark::vstree
