// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/strip/drawn_triangles.h"

#include <algorithm>

#include "glark/clients/surfel/stitch/agreement.h"

namespace glark::surfel {
namespace {

bool is_stitched(const Level& level, const Corners& corners) {
  const auto& stitched = level.patches[drawing_leaf(level, corners)].stitched;
  const std::uint32_t all = corners[0] ^ corners[1] ^ corners[2];
  return std::any_of(stitched.begin(), stitched.end(), [&](const StitchedTriangle& other) {
    const auto [a, b, c] = other.triangle;
    return (a ^ b ^ c) == all && sorted_corners(a, b, c) == corners;
  });
}

}  // namespace

void collect_drawn_triangles(const Level& level, std::uint32_t leaf, Patch& patch, std::vector<Triangle>& valid) {
  valid.clear();
  PatchCounts& counts = patch.counts;
  counts.redundant = counts.dual = counts.out_of_reach = 0;
  const auto candidates = level.candidates_of(leaf);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Candidate& candidate = candidates[i];
    if (candidate.state == CandidateState::boundary) continue;
    if (candidate.state == CandidateState::out_of_reach) {
      ++counts.out_of_reach;
    } else if (candidate.state != CandidateState::agreed) {
      ++(is_stitched(level, candidate.corners) ? counts.redundant : counts.dual);
    } else if (i < patch.shared_count && drawing_leaf(level, candidate.corners) != leaf) {
      ++counts.redundant;
    } else {
      valid.push_back(triangle_of(candidate));
    }
  }
  for (const StitchedTriangle& stitched : patch.stitched) valid.push_back(stitched.triangle);
  counts.valid = valid.size();
}

}  // namespace glark::surfel
