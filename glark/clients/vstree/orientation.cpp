// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/vstree/orientation.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace glark::vstree {
namespace {

// Sets of samples that are connected, and of each sample whether it is reversed with respect to the first of its set.
class Parts {
 public:
  explicit Parts(std::size_t count) : parent_(count), reversed_(count), size_(count, 1) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }

  struct Place {
    std::uint32_t root;
    bool reversed;
  };
  Place find(std::uint32_t i) {
    Place place{i, false};
    for (; parent_[place.root] != place.root; place.root = parent_[place.root])
      place.reversed ^= reversed_[place.root] != 0;
    bool reversed = place.reversed;
    while (parent_[i] != place.root && i != place.root) {  // the next time in one step
      const std::uint32_t next = std::exchange(parent_[i], place.root);
      const bool mine = reversed_[i] != 0;
      reversed_[i] = reversed ? 1 : 0;
      reversed ^= mine;
      i = next;
    }
    return place;
  }

  // Connects two samples, the one reversed with respect to the other or not; what is connected already stays as it is.
  void connect(std::uint32_t a, std::uint32_t b, bool reversed) {
    Place in_a = find(a), in_b = find(b);
    if (in_a.root == in_b.root) return;
    if (size_[in_a.root] < size_[in_b.root]) std::swap(in_a, in_b);
    parent_[in_b.root] = in_a.root;
    reversed_[in_b.root] = (in_a.reversed != in_b.reversed) != reversed ? 1 : 0;
    size_[in_a.root] += size_[in_b.root];
  }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint8_t> reversed_;
  std::vector<std::uint32_t> size_;
};

struct Edge {
  float weight;
  std::uint32_t from, to;
};

std::vector<Edge> edges_of(std::span<const Float4> normals, std::span<const std::uint32_t> neighbours,
                           std::size_t each) {
  std::vector<Edge> edges;
  edges.reserve(neighbours.size());
  for (std::uint32_t i = 0; i < normals.size(); ++i) {
    for (const std::uint32_t k : neighbours.subspan(i * each, each)) {
      if (i != k) edges.push_back({1 - std::abs(dot(normals[i], normals[k])), i, k});
    }
  }
  std::stable_sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.weight < b.weight; });
  return edges;
}

// Of each part, by its root: whether its normals have to be reversed.
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
            std::size_t each, const std::vector<bool>& given) {
  Parts parts(points.size());
  std::uint32_t first_given = 0xFFFFFFFF;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (!given[i]) continue;
    if (first_given == 0xFFFFFFFF) first_given = i;
    parts.connect(first_given, i, false);
  }
  for (const Edge& edge : edges_of(normals, neighbours, each))
    parts.connect(edge.from, edge.to, dot(normals[edge.from], normals[edge.to]) < 0);
  const std::vector<bool> reversed = reversed_parts(parts, points, normals, given);
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const Parts::Place place = parts.find(i);
    if (place.reversed != reversed[place.root]) normals[i] = -normals[i];
  }
}

}  // namespace glark::vstree
