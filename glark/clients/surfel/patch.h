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
#include "glark/clients/surfel/stripping_tree.h"

namespace glark::surfel {

using Corners = std::array<std::uint32_t, 3>;  // points, ascending

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
  Patcher(const StrippingTree& tree, float reach) : tree_(tree), reach_(reach) {}

  // Afterwards the members below are of this leaf.
  void make(std::uint32_t leaf);

  std::vector<Candidate> candidates;  // first those with points of other leaves, ascending by corners
  std::uint32_t shared = 0;           // how many these are
  std::vector<float> spacings;        // of the leaf's used points
  std::size_t outer = 0;              // triangles without any of these

  // Leaves of which points are taken in, or that take in points of this one.
  static void neighbours(const StrippingTree& tree, std::uint32_t leaf, std::vector<std::uint32_t>& found);

 private:
  struct Member {
    Vector position;
    std::uint32_t index;
    Vector normal;
  };

  std::array<float, 5> slabs_of(Vector position) const;
  void inflate(std::uint32_t leaf);
  void project(const Leaf& leaf);
  bool may_turn(std::uint32_t triangle, std::uint32_t link, std::uint32_t side) const;
  void turn(std::uint32_t triangle, std::uint32_t side);
  void measure_angles(std::uint32_t triangle);
  bool is_inner(const Delaunay::Triangle& triangle) const;  // has a point of the leaf
  void relax();
  bool prefers_other_diagonal(std::uint32_t triangle, std::uint32_t side) const;
  bool faces_away(const Delaunay::Triangle& triangle) const;
  void collect();
  void collect_rim(const Delaunay::Triangle& triangle);
  void measure_spacings();

  State state_of_interior(const Delaunay::Triangle& triangle, bool away) const;

  const StrippingTree& tree_;
  float reach_;
  Vector centre_, normal_, u_, v_;  // the leaf's frame
  std::size_t own_ = 0;
  std::vector<std::uint32_t> neighbours_;
  std::vector<std::uint32_t> pending_;  // triangles whose edges may turn
  std::vector<Member> members_;         // the leaf's own first
  std::vector<std::array<float, 2>> plane_;
  std::vector<Delaunay::Point> points_;
  std::vector<std::array<float, 3>> shortest_;
  std::vector<std::array<float, 3>> angles_;  // of the triangulation's triangles, their cotangents
  std::vector<std::uint8_t> inner_;
  std::vector<Candidate> interior_;
  Delaunay delaunay_;
};

}  // namespace glark::surfel
