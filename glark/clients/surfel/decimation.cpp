// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/decimation.h"

#include <algorithm>
#include <array>

#include "glark/clients/surfel/comparison.h"

namespace glark::surfel {
namespace {

class Decimator {
 public:
  Decimator(const Layer& layer, std::uint32_t leaf, float reach) : layer_(layer), leaf_(leaf), reach_(reach) {
    const Patch& patch = layer.patches[leaf];
    if (patch.gaps > 0) find_superseded(patch);
  }

  bool redundant(const Corners& corners) const {
    return std::any_of(corners.begin(), corners.end(), [&](std::uint32_t corner) {
      const std::uint32_t other = layer_.owner[corner];
      return other < leaf_ && find(layer_, other, corners) != not_found;
    });
  }

  // The triangle and one beside it are a quadrilateral of which another leaf has the other diagonal.
  bool dual(const Candidate& candidate) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t beyond = candidate.across[k];
      if (beyond == none) continue;
      const std::uint32_t apex = candidate.corners[k];
      const std::uint32_t a = candidate.corners[(k + 1) % 3], b = candidate.corners[(k + 2) % 3];
      const Corners one = sorted(apex, beyond, a), other = sorted(apex, beyond, b);
      for (const std::uint32_t point : {a, b, apex, beyond}) {
        const std::uint32_t leaf = layer_.owner[point];
        if (leaf >= leaf_ || find(layer_, leaf, one) == not_found || find(layer_, leaf, other) == not_found) continue;
        if (in_reach(layer_, one, reach_) && in_reach(layer_, other, reach_)) return true;
      }
    }
    return false;
  }

  bool superseded(const Candidate& candidate) const { return superseded_[candidate.gap]; }

 private:
  // Gaps of which all edges are those of gaps that other leaves close: the dual of more triangles than two. Of leaves that all
  // close one, the first does.
  void find_superseded(const Patch& patch) {
    std::vector<std::vector<std::uint32_t>> owners(patch.gaps);
    std::vector<bool> closed(patch.gaps, false);
    for (const Candidate& candidate : layer_.candidates_of(leaf_)) {
      if (candidate.gap == none) continue;
      closed[candidate.gap] = candidate.state == State::closes_gap;
      for (const std::uint32_t corner : candidate.corners) {
        const std::uint32_t owner = layer_.owner[corner];
        if (owner != leaf_) owners[candidate.gap].push_back(owner);
      }
    }
    for (auto& list : owners) {
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
    }
    std::vector<std::size_t> edges(patch.gaps, 0), filled(patch.gaps, 0);
    for (const GapEdge& edge : patch.gap_edges) {
      ++edges[edge.gap];
      filled[edge.gap] += std::any_of(owners[edge.gap].begin(), owners[edge.gap].end(), [&](std::uint32_t owner) {
        return (owner < leaf_ || !closed[edge.gap]) && closes(owner, edge.ends);
      });
    }
    for (std::uint32_t gap = 0; gap < patch.gaps; ++gap) {
      superseded_.push_back(edges[gap] > 0 && filled[gap] == edges[gap]);
    }
  }

  bool closes(std::uint32_t leaf, const std::array<std::uint32_t, 2>& ends) const {
    const auto& edges = layer_.patches[leaf].gap_edges;
    const auto found =
        std::lower_bound(edges.begin(), edges.end(), ends,
                         [](const GapEdge& a, const std::array<std::uint32_t, 2>& b) { return a.ends < b; });
    return found != edges.end() && found->ends == ends && found->closed;
  }

  const Layer& layer_;
  std::uint32_t leaf_;
  float reach_;
  std::vector<bool> superseded_;  // of the gaps
};

bool first_owner(const Layer& layer, std::uint32_t leaf, const Corners& corners) {
  return std::all_of(corners.begin(), corners.end(), [&](std::uint32_t corner) { return layer.owner[corner] >= leaf; });
}

}  // namespace

void decimate(const Layer& layer, std::uint32_t leaf, const LayerOptions& options, Patch& patch,
              std::vector<StripTriangle>& valid) {
  const Decimator decimator(layer, leaf, options.reach);
  valid.clear();
  patch.redundant = patch.dual = patch.valid = patch.out_of_reach = 0;
  for (const Candidate& candidate : layer.candidates_of(leaf)) {
    const bool contested = candidate.state == State::contested;
    if (candidate.state == State::out_of_reach) {
      ++patch.out_of_reach;
    } else if (contested ? decimator.redundant(candidate.corners)
                         : candidate.state == State::agreed && !first_owner(layer, leaf, candidate.corners)) {
      ++patch.redundant;
    } else if (candidate.state != State::agreed &&
               (decimator.superseded(candidate) || (contested && decimator.dual(candidate)))) {
      ++patch.dual;
    } else {
      ++patch.valid;
      const auto [a, b, c] = candidate.corners;
      valid.push_back(candidate.reversed ? StripTriangle{a, c, b} : StripTriangle{a, b, c});
    }
  }
}

}  // namespace glark::surfel
