// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/stitch/agreement.h"

#include <cstddef>
#include <utility>

#include "glark/clients/surfel/level/slot_array.h"
#include "glark/clients/surfel/level/triangle_spacing.h"

namespace glark::surfel {
namespace {

// Finds the triangle among the shared candidates of a leaf. Returns null if the leaf has no such triangle.
const Candidate* find_candidate(const Level& level, std::uint32_t leaf, const Corners& corners) {
  const auto candidates = level.candidates_of(leaf).first(level.patches[leaf].shared_count);
  const std::uint64_t key = first_two(corners);
  std::size_t first = 0;  // all candidates before `first` have smaller keys
  // The binary search has no branch, because the processor would mispredict every second one.
  for (std::size_t count = candidates.size(); count > 0;) {
    const std::size_t half = (count + 1) / 2;
    first += half & (0 - static_cast<std::size_t>(first_two(candidates[first + half - 1].corners) < key));
    count -= half;
  }
  for (; first < candidates.size() && first_two(candidates[first].corners) == key; ++first) {
    if (candidates[first].corners[2] == corners[2]) return &candidates[first];
  }
  return nullptr;
}

// Returns whether the leaf has the triangle with the same orientation. A triangle can be upside down on a leaf's plane,
// if the surface bends too much for the plane.
bool has_candidate(const Level& level, std::uint32_t leaf, const Candidate& candidate, bool oriented) {
  const Candidate* const found = find_candidate(level, leaf, candidate.corners);
  return found != nullptr && (!oriented || found->reversed == candidate.reversed);
}

bool do_all_owners_have(const Level& level, std::uint32_t leaf, const Candidate& candidate, bool oriented) {
  const auto [a, b, c] = candidate.corners;
  const std::array<std::uint32_t, 3> owners = {level.owner[a], level.owner[b], level.owner[c]};
  // Few triangles have more than one owner other than this leaf.
  const std::uint32_t other = owners[0] != leaf ? owners[0] : owners[1] != leaf ? owners[1] : owners[2];
  if (other == leaf) return true;
  return has_candidate(level, other, candidate, oriented) &&
         std::all_of(owners.begin(), owners.end(), [&](std::uint32_t owner) {
           return owner == leaf || owner == other || has_candidate(level, owner, candidate, oriented);
         });
}

float squared_longest_edge(Vector a, Vector b, Vector c) {
  return std::max({dot(a - b, a - b), dot(b - c, b - c), dot(c - a, c - a)});
}

// Does not read the states of other leaves' candidates.
void classify_candidates_of(Level& level, std::uint32_t leaf, const LevelOptions& options) {
  const Patch& patch = level.patches[leaf];
  for (Candidate& candidate : std::span(level.candidates).subspan(patch.candidates.first, patch.shared_count)) {
    if (candidate.state == CandidateState::boundary) continue;
    candidate.state = !is_in_reach(level, candidate.corners, options.reach)             ? CandidateState::out_of_reach
                      : candidate.back_facing                                           ? CandidateState::back_facing
                      : do_all_owners_have(level, leaf, candidate, options.has_normals) ? CandidateState::agreed
                                                                                        : CandidateState::conflicting;
  }
}

}  // namespace

void classify_candidates(Level& level, std::span<const std::uint32_t> leaves, const LevelOptions& options,
                         const common::Workers& workers) {
  workers.in_pieces(leaves.size(), leaves_a_batch, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) classify_candidates_of(level, leaves[i], options);
  });
}

Corners sorted_corners(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  if (a > b) std::swap(a, b);
  if (b > c) std::swap(b, c);
  if (a > b) std::swap(a, b);
  return {a, b, c};
}

float squared_longest_edge(const Level& level, const Corners& corners) {
  return squared_longest_edge(level.positions[corners[0]], level.positions[corners[1]], level.positions[corners[2]]);
}

bool is_in_reach(const Level& level, const Corners& corners, float reach) {
  const Surfel& a = level.surfel(corners[0]);
  const Surfel& b = level.surfel(corners[1]);
  const Surfel& c = level.surfel(corners[2]);
  const float longest = reach * triangle_spacing(a.spacing, b.spacing, c.spacing);
  return squared_longest_edge(a.position, b.position, c.position) <= longest * longest;
}

}  // namespace glark::surfel
