// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/vstree/normals/orientation.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "glark/clients/vstree/normals/agreement.h"
#include "glark/clients/vstree/normals/signed_parts.h"
#include "glark/clients/vstree/normals/upright.h"

namespace glark::vstree {
namespace {

constexpr std::uint32_t none = 0xFFFFFFFF;
constexpr std::size_t run_length = 1 << 13;
constexpr float smooth = 0.1F;           // the greatest weight of an edge that connects two large parts
constexpr std::uint32_t few = 30;        // samples of a part that is not large
constexpr float least_influence = 0.1F;  // of an edge from one side of a wall to the other, relative to one in a plane

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

struct Pair {
  std::uint32_t a, b;
};

// What the edges between two parts say together, relative to the first samples of the parts.
struct Vote {
  std::uint32_t a, b;
  float sum;
  std::uint64_t parts() const { return std::uint64_t{a} << 32 | b; }
};

// Adds up the votes about the same two parts.
void add_up(std::vector<Vote>& votes) {
  std::stable_sort(votes.begin(), votes.end(), [](const Vote& p, const Vote& q) { return p.parts() < q.parts(); });
  std::size_t count = 0;
  for (const Vote vote : votes) {
    if (count > 0 && votes[count - 1].parts() == vote.parts()) {
      votes[count - 1].sum += vote.sum;
    } else {
      votes[count++] = vote;
    }
  }
  votes.resize(count);
}

class Orientation {
 public:
  Orientation(std::span<const Float4> points, std::span<const Float4> normals,
              std::span<const std::uint32_t> neighbours, std::size_t each, std::span<const float> trust,
              const Workers& workers)
      : points_(points),
        normals_(normals),
        neighbours_(neighbours),
        each_(each),
        trust_(trust),
        workers_(workers),
        parts_(points.size()) {}

  // Returns the samples whose normals must be reversed.
  std::vector<bool> reversed(const std::vector<bool>& given) {
    connect(given);
    const std::vector<bool> is_part_reversed = reversed_parts(parts_, points_, normals_, trust_, given);
    std::vector<bool> result(points_.size());
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
      const SignedParts::Place place = parts_.find(i);
      result[i] = place.reversed != is_part_reversed[place.root];
    }
    return result;
  }

 private:
  std::span<const std::uint32_t> neighbours_of(std::size_t i) const { return neighbours_.subspan(i * each_, each_); }

  Agreement agreement_of(std::uint32_t a, std::uint32_t b) const {
    return agreement(points_[b] - points_[a], normals_[a], normals_[b]);
  }

  void connect(const std::vector<bool>& given) {
    std::uint32_t first_given = none;
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
      if (!given[i]) continue;
      if (first_given == none) first_given = i;
      parts_.connect(first_given, i, false);
    }
    connect_smooth_parts();
    connect_by_votes();
  }

  float weight_of(std::uint32_t a, std::uint32_t b) const {
    const Agreement found = agreement_of(a, b);
    return 1 - std::abs(found.flat) + found.slope * found.slope + 1 - std::min(trust_[a], trust_[b]);
  }

  // Adds the edges that may be in the minimum spanning tree: the spanning trees within a run of samples, and all edges
  // that leave the run. Near samples have near indices. So a run stays in the cache, and few edges leave it.
  void add_edges(std::uint32_t begin, std::uint32_t end, std::vector<Edge>& edges) const {
    std::vector<Edge> within;
    for (std::uint32_t i = begin; i < end; ++i) {
      for (const std::uint32_t k : neighbours_of(i)) {
        const std::span<const std::uint32_t> theirs = neighbours_of(k);
        if (k == i || (k < i && std::find(theirs.begin(), theirs.end(), i) != theirs.end()))
          continue;  // each edge once
        (k >= begin && k < end ? within : edges).push_back({weight_of(i, k), i, k});
      }
    }
    sort_by_weight(within);
    SignedParts parts(end - begin);
    for (const Edge& edge : within) {
      if (parts.connect(edge.from - begin, edge.to - begin, false)) edges.push_back(edge);
    }
  }

  std::vector<Edge> edges() const {
    std::vector<std::vector<Edge>> runs((points_.size() + run_length - 1) / run_length);
    workers_.in_pieces(points_.size(), run_length, [&](std::size_t begin, std::size_t end) {
      add_edges(static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end), runs[begin / run_length]);
    });
    std::vector<Edge> result;
    for (std::vector<Edge>& some : runs) {
      result.insert(result.end(), some.begin(), some.end());
      some = {};
    }
    sort_by_weight(result);
    return result;
  }

  // Connects samples along the minimum spanning tree, but large parts only where the surface is smooth. One wrong normal
  // could connect the two sides of a wall.
  void connect_smooth_parts() {
    std::vector<std::uint32_t> sizes(points_.size(), 1);
    for (const Edge& edge : edges()) {
      const std::uint32_t a = parts_.find(edge.from).root, b = parts_.find(edge.to).root;
      if (a == b || (edge.weight > smooth && std::min(sizes[a], sizes[b]) >= few)) continue;
      const std::uint32_t size = sizes[a] + sizes[b];
      parts_.connect(edge.from, edge.to, agreement_of(edge.from, edge.to).flat < 0);
      sizes[parts_.find(edge.from).root] = size;
    }
  }

  // Returns the pairs of neighbours that are in different parts.
  std::vector<Pair> pairs_between_parts() {
    std::vector<Pair> result;
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
      const std::uint32_t root = parts_.find(i).root;
      for (const std::uint32_t k : neighbours_of(i)) {
        if (parts_.find(k).root != root) result.push_back({i, k});
      }
    }
    return result;
  }

  std::vector<Vote> votes_of(std::span<const Pair> pairs) {
    std::vector<Vote> result;
    for (const auto& [i, k] : pairs) {
      const SignedParts::Place mine = parts_.find(i), theirs = parts_.find(k);
      const Agreement found = agreement_of(i, k);
      const float value = found.sides * std::min(trust_[i], trust_[k]) * (1 + least_influence - found.slope);
      result.push_back({std::min(mine.root, theirs.root), std::max(mine.root, theirs.root),
                        mine.reversed == theirs.reversed ? value : -value});
    }
    add_up(result);
    return result;
  }

  // Connects each part with the one about which the edges between them say most, until no edges are left between parts.
  void connect_by_votes() {
    for (std::vector<Pair> pairs = pairs_between_parts(); !pairs.empty();) {
      std::vector<Vote> votes = votes_of(pairs);
      std::stable_sort(votes.begin(), votes.end(),
                       [](const Vote& p, const Vote& q) { return std::abs(p.sum) > std::abs(q.sum); });
      std::vector<bool> is_connected(points_.size());
      for (const Vote& vote : votes) {
        if (is_connected[vote.a] && is_connected[vote.b]) continue;
        is_connected[vote.a] = is_connected[vote.b] = true;
        parts_.connect(vote.a, vote.b, vote.sum < 0);
      }
      std::erase_if(pairs, [&](const Pair& pair) { return parts_.find(pair.a).root == parts_.find(pair.b).root; });
    }
  }

  std::span<const Float4> points_, normals_;
  std::span<const std::uint32_t> neighbours_;
  std::size_t each_;
  std::span<const float> trust_;
  const Workers& workers_;
  SignedParts parts_;
};

}  // namespace

void orient(std::span<const Float4> points, std::span<Float4> normals, std::span<const std::uint32_t> neighbours,
            std::size_t each, std::span<const float> trust, const std::vector<bool>& given, const Workers& workers) {
  const std::vector<bool> reversed = Orientation(points, normals, neighbours, each, trust, workers).reversed(given);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (reversed[i]) normals[i] = -normals[i];
  }
}

}  // namespace glark::vstree
