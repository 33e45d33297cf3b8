// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The triangulation of a leaf, inflated by points of its neighbours.
// Based on: Boubekeur 2007, ch. 5.2.1 and 5.2.2.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "glark/clients/surfel/delaunay.h"
#include "glark/clients/surfel/inflation.h"
#include "glark/clients/surfel/stripping_tree.h"

namespace glark::surfel {

using Corners = std::array<std::uint32_t, 3>;  // points, ascending

// The first two as one.
inline std::uint64_t leading(const Corners& corners) { return std::uint64_t{corners[0]} << 32 | corners[1]; }
// Of points, or of triangles' corners as they are.
inline bool is_before(const Corners& a, const Corners& b) {
  return leading(a) < leading(b) || (leading(a) == leading(b) && a[2] < b[2]);
}

enum class State : std::uint8_t {
  contested,     // some leaf that could have it has it not
  agreed,        // all leaves that could have the triangle have it
  rejected,      // it is seen from behind, or has a point that is far from everything
  out_of_reach,  // an edge is too long
  rim,           // no triangle, but an edge beyond which there is none: two of the corners are one
};

// A triangle with a point of its leaf, which may be drawn.
struct Candidate {
  Corners corners;
  bool reversed;  // the corners are clockwise
  bool away;      // by the normals of its points it is seen from behind
  State state;
};

// The distance by which the reach of a triangle is measured, of those of its points.
float spacing_of(float a, float b, float c);

// Makes patches, one after the other, in memory that it keeps.
class Patcher {
 public:
  Patcher(const StrippingTree& tree, float reach, bool turn_edges)
      : reach_(reach), turn_edges_(turn_edges), inflation_(tree) {}

  // Afterwards the members below are of this leaf.
  void make(std::uint32_t leaf);

  std::vector<Candidate> candidates;  // first those with points of other leaves, ascending by corners
  std::uint32_t shared = 0;           // how many these are
  std::vector<float> spacings;        // of the leaf's used points
  std::size_t outer = 0;              // triangles without any of these
  std::size_t turned = 0;             // edges, for strips that turn less

 private:
  // What is measured of a triangle in space.
  struct Facet {
    std::array<float, 3> cotangents;  // of its angles
    std::array<float, 3> sizes;       // of the edges opposite to these, squared
    Vector normal;
  };

  const Inflation::Member& member(std::uint32_t corner) const { return inflation_.members[corner]; }
  bool is_inner(const Delaunay::Triangle& triangle) const;  // has a point of the leaf
  bool is_interior(const Delaunay::Triangle& triangle) const;
  void measure(std::uint32_t triangle);
  bool may_turn(std::uint32_t triangle, std::uint32_t side) const;
  void turn(std::uint32_t triangle, std::uint32_t side);
  bool prefers_other_diagonal(std::uint32_t triangle, std::uint32_t side) const;
  void relax();
  void measure_spacings();
  bool faces_away(std::uint32_t triangle) const;
  State state_of_interior(std::uint32_t triangle, bool away) const;
  bool is_agreed(std::uint32_t triangle) const;
  bool even(std::uint32_t triangle, std::uint32_t side);
  void find_valences();
  void even_valences();
  Candidate candidate_of(std::uint32_t triangle) const;
  void collect();
  void collect_rim(const Delaunay::Triangle& triangle);

  float reach_;
  bool turn_edges_;
  Inflation inflation_;
  Delaunay delaunay_;
  std::vector<Facet> facets_;           // of the triangulation's triangles
  std::vector<std::uint32_t> pending_;  // triangles whose edges may turn
  std::vector<std::array<float, 3>> shortest_;
  std::vector<std::uint8_t> valences_;  // of the members, their triangles modulo three
  std::vector<Candidate> interior_;
};

}  // namespace glark::surfel
