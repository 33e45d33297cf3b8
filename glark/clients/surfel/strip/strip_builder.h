// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Divides the triangles of a patch into runs. In a run, each triangle shares an edge with the next one.
// Based on: Stewart, Tunneling for Triangle Strips, 2001. A walk over the triangles makes runs. Then edges between two
// runs are added to one of the runs as long as this reduces the number of indices.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/surfel/level/candidate.h"
#include "glark/clients/surfel/strip/triangle_adjacency.h"

namespace glark::surfel {

// Works on patches one by one, and reuses its memory.
class StripBuilder {
 public:
  // Puts each triangle into one run. The result depends only on the triangles.
  void build(std::span<const Triangle> triangles);

  std::size_t size() const { return crossed_.size(); }
  // Returns the sides of a triangle that its run crosses: one bit for each, at most two.
  std::uint8_t crossed(std::uint32_t triangle) const { return crossed_[triangle]; }
  // Returns whether a run begins or ends at the triangle.
  bool is_end(std::uint32_t triangle) const { return (crossed_[triangle] & (crossed_[triangle] - 1)) == 0; }
  // Lists the triangles of a run from one of its ends.
  void follow(std::uint32_t end, std::vector<std::uint32_t>& triangles) const;

 private:
  static constexpr std::uint32_t no_triangle = 0xFFFFFFFFU;
  static std::uint32_t triangle_of(std::uint32_t link) { return TriangleAdjacency::triangle_of(link); }
  static std::uint32_t side_of(std::uint32_t link) { return TriangleAdjacency::side_of(link); }

  void walk();
  void walk_from(std::uint32_t triangle);
  std::uint32_t next_start();
  void mark_used(std::uint32_t triangle);
  void note_if_low_degree(std::uint32_t triangle);
  // Returns the triangle across a side, or size() if there is none.
  std::uint32_t neighbour(std::uint32_t triangle, std::uint32_t side) const {
    return std::min(triangle_of(adjacency_.links(triangle)[side]), static_cast<std::uint32_t>(size()));
  }
  void improve();
  void extend(std::uint32_t end, std::uint32_t random);
  int extension_cost(std::uint32_t end, std::uint32_t side, std::uint32_t cut_side) const;
  static int swap_cost(std::uint8_t crossed, std::uint32_t side, std::uint8_t crossed_there, std::uint32_t side_there);
  int swap_cost_at(std::uint32_t triangle, std::uint32_t side, std::uint8_t crossed) const;
  int detached_cost(std::uint32_t triangle, std::uint32_t side) const;
  void join(std::uint32_t triangle, std::uint32_t side);
  void cut(std::uint32_t triangle, std::uint32_t side);
  bool is_loop(std::uint32_t first, std::uint32_t next) const;

  TriangleAdjacency adjacency_;
  std::vector<std::uint8_t> crossed_;
  // A XOR-linked list. Each element combines the numbers of the triangle's neighbours in the run, plus one, by
  // exclusive or.
  std::vector<std::uint32_t> run_neighbours_;
  std::vector<std::uint32_t> degrees_;     // the number of unused neighbours; at least is_used for used triangles
  std::vector<std::uint32_t> low_degree_;  // a stack of triangles that had few unused neighbours
  std::size_t low_degree_count_ = 0;
  std::vector<std::uint32_t> ends_;  // the ends of runs, and former ends
  std::uint32_t first_unused_ = 0;   // all triangles before this one are used
};

}  // namespace glark::surfel
