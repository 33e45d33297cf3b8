// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The state of interior triangles. Only one leaf has all their points, so no other leaf can disagree.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "glark/clients/surfel/level/candidate.h"
#include "glark/clients/surfel/level/triangle_spacing.h"
#include "glark/clients/surfel/triangulate/space_triangulation.h"

namespace glark::surfel {

class InteriorClassifier {
 public:
  // spacings: the spacings of the leaf's own points. The caller keeps both arguments.
  InteriorClassifier(const SpaceTriangulation& triangulation, std::span<const float> spacings, float reach)
      : triangulation_(triangulation), spacings_(spacings), reach_(reach) {}

  CandidateState state_of(std::uint32_t triangle, bool back_facing) const {
    const auto [a, b, c] = triangulation_.triangles()[triangle].corners;
    const float longest = reach_ * triangle_spacing(spacings_[a], spacings_[b], spacings_[c]);
    const auto& lengths = triangulation_.facet(triangle).squared_lengths;
    if (std::max({lengths[0], lengths[1], lengths[2]}) > longest * longest) return CandidateState::out_of_reach;
    return back_facing ? CandidateState::back_facing : CandidateState::agreed;
  }
  bool is_agreed(std::uint32_t triangle) const {
    return state_of(triangle, triangulation_.is_back_facing(triangle)) == CandidateState::agreed;
  }

 private:
  const SpaceTriangulation& triangulation_;
  std::span<const float> spacings_;
  float reach_;
};

}  // namespace glark::surfel
