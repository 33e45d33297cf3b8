// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Triangulates a leaf and lists its candidate triangles.
// Based on: Boubekeur 2007, ch. 5.2.1 and 5.2.2.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "glark/clients/surfel/level/candidate.h"
#include "glark/clients/surfel/triangulate/space_triangulation.h"
#include "glark/clients/surfel/triangulate/valence_flipper.h"

namespace glark::surfel {

// Triangulates leaves one by one, and reuses its memory.
class LeafTriangulator {
 public:
  struct Result {
    std::vector<Candidate> candidates;  // candidates with points of other leaves come first, in ascending order
    std::uint32_t shared_count = 0;     // the number of these candidates
    std::vector<float> spacings;        // for the leaf's own points
    std::size_t outer = 0;              // the number of triangles without any of the leaf's own points
    std::size_t flipped = 0;            // the number of edges that were flipped for valence
  };

  LeafTriangulator(const StrippingTree& tree, float reach, bool flip_edges)
      : reach_(reach), flip_edges_(flip_edges), triangulation_(tree), flipper_(triangulation_) {}
  LeafTriangulator(const LeafTriangulator&) = delete;
  LeafTriangulator& operator=(const LeafTriangulator&) = delete;

  // The result is valid until the next call.
  const Result& triangulate(std::uint32_t leaf);

 private:
  void measure_spacings();
  Candidate candidate_of(std::uint32_t triangle) const;
  void collect_candidates(const InteriorClassifier& classifier);
  void add_boundary_edge(const Delaunay::Triangle& triangle);

  float reach_;
  bool flip_edges_;
  SpaceTriangulation triangulation_;
  ValenceFlipper flipper_;
  std::vector<std::array<float, 3>> shortest_;  // squared lengths of the shortest edges at each of the leaf's points
  std::vector<Candidate> interior_;
  Result result_;
};

}  // namespace glark::surfel
