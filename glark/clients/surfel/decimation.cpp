// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/decimation.h"

#include <algorithm>

#include "glark/clients/surfel/comparison.h"

namespace glark::surfel {
namespace {

bool is_mended(const Layer& layer, const Corners& corners) {
  const auto& mended = layer.patches[drawing_leaf(layer, corners)].mended;
  const std::uint32_t all = corners[0] ^ corners[1] ^ corners[2];
  return std::any_of(mended.begin(), mended.end(), [&](const MendedTriangle& other) {
    const auto [a, b, c] = other.triangle;
    return (a ^ b ^ c) == all && sorted(a, b, c) == corners;
  });
}

}  // namespace

void decimate(const Layer& layer, std::uint32_t leaf, Patch& patch, std::vector<StripTriangle>& valid) {
  valid.clear();
  patch.redundant = patch.dual = patch.out_of_reach = 0;
  const auto candidates = layer.candidates_of(leaf);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Candidate& candidate = candidates[i];
    if (candidate.state == State::rim) continue;
    if (candidate.state == State::out_of_reach) {
      ++patch.out_of_reach;
    } else if (candidate.state != State::agreed) {
      ++(is_mended(layer, candidate.corners) ? patch.redundant : patch.dual);
    } else if (i < patch.shared && drawing_leaf(layer, candidate.corners) != leaf) {
      ++patch.redundant;
    } else {
      const auto [a, b, c] = candidate.corners;
      valid.push_back(candidate.reversed ? StripTriangle{a, c, b} : StripTriangle{a, b, c});
    }
  }
  for (const MendedTriangle& mended : patch.mended) valid.push_back(mended.triangle);
  patch.valid = valid.size();
}

}  // namespace glark::surfel
