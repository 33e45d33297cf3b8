// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/comparison.h"

#include <algorithm>
#include <span>
#include <utility>

namespace glark::surfel {
namespace {

// The same way round: where the surface bends too much for a plane, a triangle can be upside down on it.
bool has(const Layer& layer, std::uint32_t leaf, const Candidate& candidate, bool oriented) {
  const std::size_t found = find(layer, leaf, candidate.corners);
  return found != not_found && (!oriented || layer.candidates_of(leaf)[found].reversed == candidate.reversed);
}

// Few triangles have more than one owner other than the leaf.
bool all_owners_have(const Layer& layer, std::uint32_t leaf, const Candidate& candidate, bool oriented) {
  const auto [a, b, c] = candidate.corners;
  const std::array<std::uint32_t, 3> owners = {layer.owner[a], layer.owner[b], layer.owner[c]};
  const std::uint32_t other = owners[0] != leaf ? owners[0] : owners[1] != leaf ? owners[1] : owners[2];
  if (other == leaf) return true;
  return has(layer, other, candidate, oriented) && std::all_of(owners.begin(), owners.end(), [&](std::uint32_t owner) {
           return owner == leaf || owner == other || has(layer, owner, candidate, oriented);
         });
}

// Squared.
float longest_edge(Vector a, Vector b, Vector c) {
  return std::max({dot(a - b, a - b), dot(b - c, b - c), dot(c - a, c - a)});
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
  const std::uint64_t key = leading(corners);
  std::size_t first = 0;  // none before has the key
  // Halves without branches, of which every other one would be mispredicted.
  for (std::size_t count = candidates.size(); count > 0;) {
    const std::size_t half = (count + 1) / 2;
    first += half & (0 - static_cast<std::size_t>(leading(candidates[first + half - 1].corners) < key));
    count -= half;
  }
  for (; first < candidates.size() && leading(candidates[first].corners) == key; ++first) {
    if (candidates[first].corners[2] == corners[2]) return first;
  }
  return not_found;
}

float squared_size(const Layer& layer, const Corners& corners) {
  return longest_edge(layer.positions[corners[0]], layer.positions[corners[1]], layer.positions[corners[2]]);
}

bool in_reach(const Layer& layer, const Corners& corners, float reach) {
  const Surfel& a = layer.surfel(corners[0]);
  const Surfel& b = layer.surfel(corners[1]);
  const Surfel& c = layer.surfel(corners[2]);
  const float most = reach * spacing_of(a.spacing, b.spacing, c.spacing);
  return longest_edge(a.position, b.position, c.position) <= most * most;
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
