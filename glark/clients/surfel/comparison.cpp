// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/comparison.h"

#include <algorithm>
#include <span>
#include <utility>

namespace glark::surfel {
namespace {

// The same way round: where the surface bends too much for a plane, a triangle can be upside down on it.
bool all_owners_have(const Layer& layer, std::uint32_t leaf, const Candidate& candidate, bool oriented) {
  return std::all_of(candidate.corners.begin(), candidate.corners.end(), [&](std::uint32_t corner) {
    const std::uint32_t owner = layer.owner[corner];
    if (owner == leaf) return true;
    const std::size_t found = find(layer, owner, candidate.corners);
    return found != not_found && (!oriented || layer.candidates_of(owner)[found].reversed == candidate.reversed);
  });
}

}  // namespace

Corners sorted(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  if (a > b) std::swap(a, b);
  if (b > c) std::swap(b, c);
  if (a > b) std::swap(a, b);
  return {a, b, c};
}

std::size_t find(const Layer& layer, std::uint32_t leaf, const Corners& corners) {
  const auto candidates = layer.candidates_of(leaf).first(layer.patches[leaf].shared);
  const auto found = std::lower_bound(candidates.begin(), candidates.end(), corners,
                                      [](const Candidate& a, const Corners& b) { return is_before(a.corners, b); });
  if (found == candidates.end() || found->corners != corners) return not_found;
  return static_cast<std::size_t>(found - candidates.begin());
}

float squared_size(const Layer& layer, const Corners& corners) {
  const Vector a = layer.surfel(corners[0]).position, b = layer.surfel(corners[1]).position;
  const Vector c = layer.surfel(corners[2]).position;
  return std::max({dot(a - b, a - b), dot(b - c, b - c), dot(c - a, c - a)});
}

bool in_reach(const Layer& layer, const Corners& corners, float reach) {
  const float most = reach * spacing_of(layer.surfel(corners[0]).spacing, layer.surfel(corners[1]).spacing,
                                        layer.surfel(corners[2]).spacing);
  return squared_size(layer, corners) <= most * most;
}

std::uint32_t drawing_leaf(const Layer& layer, const Corners& corners) {
  return std::min({layer.owner[corners[0]], layer.owner[corners[1]], layer.owner[corners[2]]});
}

void agree(Layer& layer, std::uint32_t leaf, const LayerOptions& options) {
  const Patch& patch = layer.patches[leaf];
  for (Candidate& candidate : std::span(layer.candidates).subspan(patch.candidates.first, patch.shared)) {
    if (candidate.state == State::rim) continue;
    candidate.state = !in_reach(layer, candidate.corners, options.reach)          ? State::out_of_reach
                      : candidate.away                                            ? State::rejected
                      : all_owners_have(layer, leaf, candidate, options.oriented) ? State::agreed
                                                                                  : State::contested;
  }
}

}  // namespace glark::surfel
