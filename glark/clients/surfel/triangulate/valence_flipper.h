// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Flips interior edges so that more points have valence three or six. A strip passes a point along three of its
// triangles. So it needs no swap at such points.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "glark/clients/surfel/triangulate/interior_classifier.h"
#include "glark/clients/surfel/triangulate/space_triangulation.h"

namespace glark::surfel {

// Works on triangulations one by one, and reuses its memory.
class ValenceFlipper {
 public:
  explicit ValenceFlipper(SpaceTriangulation& triangulation) : triangulation_(triangulation) {}

  // Returns the number of flipped edges. No other leaf has the triangles at these edges. So leaves agree as before.
  std::size_t flip_for_valence(const InteriorClassifier& classifier);

 private:
  void count_valences();
  bool flip_if_flat(std::uint32_t triangle, std::uint32_t side, const InteriorClassifier& classifier);

  SpaceTriangulation& triangulation_;
  std::vector<std::uint8_t> valences_;  // the number of triangles of each member, modulo three
};

}  // namespace glark::surfel
