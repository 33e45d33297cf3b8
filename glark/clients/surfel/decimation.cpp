// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/decimation.h"

#include <algorithm>
#include <array>
#include <utility>

namespace glark::surfel {
namespace {

Corners sorted(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  if (a > b) std::swap(a, b);
  if (b > c) std::swap(b, c);
  if (a > b) std::swap(a, b);
  return {a, b, c};
}

class Decimator {
 public:
  Decimator(const Layer& layer, std::uint32_t leaf, float reach) : layer_(layer), leaf_(leaf), reach_(reach) {}

  // The length that the points' distances allow is the same for all leaves, so that they agree on what is a hole.
  bool in_reach(const Corners& corners) const {
    const Surfel& a = layer_.surfel(corners[0]);
    const Surfel& b = layer_.surfel(corners[1]);
    const Surfel& c = layer_.surfel(corners[2]);
    const float most = reach_ * std::max({a.spacing, b.spacing, c.spacing});
    const auto squared = [](Vector v) { return dot(v, v); };
    return std::max({squared(a.position - b.position), squared(b.position - c.position),
                     squared(c.position - a.position)}) <= most * most;
  }

  bool redundant(const Corners& corners) const {
    for (const std::uint32_t corner : corners) {
      const std::uint32_t other = layer_.owner[corner];
      if (other < leaf_ && has(other, corners)) return true;
    }
    return false;
  }

  bool dual(const Candidate& candidate) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t beyond = candidate.across[k];
      if (beyond == none) continue;
      const std::uint32_t apex = candidate.corners[k];
      const std::uint32_t a = candidate.corners[(k + 1) % 3], b = candidate.corners[(k + 2) % 3];
      const Corners one = sorted(apex, beyond, a), other = sorted(apex, beyond, b);
      for (const std::uint32_t point : {a, b, apex, beyond}) {
        const std::uint32_t leaf = layer_.owner[point];
        if (leaf >= leaf_ || !has(leaf, one) || !has(leaf, other)) continue;
        if (in_reach(one) && in_reach(other)) return true;
      }
    }
    return false;
  }

 private:
  bool has(std::uint32_t leaf, const Corners& corners) const {
    const auto candidates = layer_.candidates_of(leaf);
    const auto found = std::lower_bound(candidates.begin(), candidates.end(), corners,
                                        [](const Candidate& a, const Corners& b) { return a.corners < b; });
    return found != candidates.end() && found->corners == corners;
  }

  const Layer& layer_;
  std::uint32_t leaf_;
  float reach_;
};

}  // namespace

void decimate(const Layer& layer, std::uint32_t leaf, const LayerOptions& options, Patch& patch,
              std::vector<StripTriangle>& valid) {
  const Decimator decimator(layer, leaf, options.reach);
  valid.clear();
  patch.redundant = patch.dual = patch.valid = patch.out_of_reach = 0;
  for (const Candidate& candidate : layer.candidates_of(leaf)) {
    if (!decimator.in_reach(candidate.corners)) {
      ++patch.out_of_reach;
    } else if (decimator.redundant(candidate.corners)) {
      ++patch.redundant;
    } else if (decimator.dual(candidate)) {
      ++patch.dual;
    } else {
      ++patch.valid;
      const auto [a, b, c] = candidate.corners;
      valid.push_back(candidate.reversed ? StripTriangle{a, c, b} : StripTriangle{a, b, c});
    }
  }
}

}  // namespace glark::surfel
