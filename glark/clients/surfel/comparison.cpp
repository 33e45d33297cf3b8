// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/comparison.h"

#include <algorithm>
#include <span>
#include <utility>

namespace glark::surfel {
namespace {

bool all_owners_have(const Layer& layer, std::uint32_t leaf, const Corners& corners) {
  return std::all_of(corners.begin(), corners.end(), [&](std::uint32_t corner) {
    const std::uint32_t owner = layer.owner[corner];
    return owner == leaf || find(layer, owner, corners) != not_found;
  });
}

// The triangles that others see differently and that hang together with one of them. They are a whole, by which a gap between
// agreed triangles can be closed, if nothing but agreed triangles is around them.
void collect_gap(const Layer& layer, std::uint32_t leaf, std::span<Candidate> candidates, std::size_t seed,
                 std::uint32_t number, std::vector<GapEdge>& edges) {
  std::vector<std::size_t> members = {seed};
  candidates[seed].gap = number;
  bool closed = true;
  const std::size_t first_edge = edges.size();
  for (std::size_t next = 0; next < members.size(); ++next) {
    const Candidate& candidate = candidates[members[next]];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = candidate.corners[(k + 1) % 3], b = candidate.corners[(k + 2) % 3];
      const std::size_t beyond =
          candidate.across[k] == none ? not_found : find(layer, leaf, sorted(a, b, candidate.across[k]));
      if (beyond == not_found || candidates[beyond].state == State::out_of_reach) {
        closed = false;
      } else if (candidates[beyond].state == State::agreed) {
        edges.push_back({{std::min(a, b), std::max(a, b)}, number, false});
      } else if (candidates[beyond].gap == none) {
        candidates[beyond].gap = number;
        members.push_back(beyond);
      }
    }
  }
  if (!closed) return;
  for (const std::size_t member : members) candidates[member].state = State::closes_gap;
  for (std::size_t i = first_edge; i < edges.size(); ++i) edges[i].closed = true;
}

}  // namespace

Corners sorted(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  if (a > b) std::swap(a, b);
  if (b > c) std::swap(b, c);
  if (a > b) std::swap(a, b);
  return {a, b, c};
}

std::size_t find(const Layer& layer, std::uint32_t leaf, const Corners& corners) {
  const auto candidates = layer.candidates_of(leaf);
  const auto found = std::lower_bound(candidates.begin(), candidates.end(), corners,
                                      [](const Candidate& a, const Corners& b) { return a.corners < b; });
  if (found == candidates.end() || found->corners != corners) return not_found;
  return static_cast<std::size_t>(found - candidates.begin());
}

bool in_reach(const Layer& layer, const Corners& corners, float reach) {
  const Surfel& a = layer.surfel(corners[0]);
  const Surfel& b = layer.surfel(corners[1]);
  const Surfel& c = layer.surfel(corners[2]);
  const float most = reach * std::max({a.spacing, b.spacing, c.spacing});
  const auto squared = [](Vector v) { return dot(v, v); };
  return std::max({squared(a.position - b.position), squared(b.position - c.position),
                   squared(c.position - a.position)}) <= most * most;
}

void agree(Layer& layer, std::uint32_t leaf, float reach) {
  Patch& patch = layer.patches[leaf];
  const std::span<Candidate> candidates(layer.candidates.data() + patch.candidates.first, patch.candidates.count);
  for (Candidate& candidate : candidates) {
    candidate.gap = none;
    candidate.state = !in_reach(layer, candidate.corners, reach)        ? State::out_of_reach
                      : all_owners_have(layer, leaf, candidate.corners) ? State::agreed
                                                                        : State::contested;
  }
  patch.gaps = 0;
  patch.gap_edges.clear();
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (candidates[i].state != State::contested || candidates[i].gap != none) continue;
    collect_gap(layer, leaf, candidates, i, patch.gaps++, patch.gap_edges);
  }
  std::sort(patch.gap_edges.begin(), patch.gap_edges.end(),
            [](const GapEdge& a, const GapEdge& b) { return a.ends < b.ends; });
}

}  // namespace glark::surfel
