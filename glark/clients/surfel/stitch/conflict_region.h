// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A conflict region: a set of points where leaves disagree on triangles. All leaves agree on the triangles around the
// region. The conflicting triangles with the least cost are drawn. Then the remaining holes are filled.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/surfel/level/level.h"
#include "glark/clients/surfel/stitch/vertex_fan.h"

namespace glark::surfel {

// A triangle that some leaves have and others do not.
struct ConflictingTriangle {
  Triangle triangle;
  std::uint32_t missing;  // the number of leaves that own a corner and do not have the triangle
  float cost;
};

// Stitches one region after the other and reuses its memory.
class ConflictRegion {
 public:
  // number_in_region: for each point of a region, its position in the region's list of points.
  ConflictRegion(const Level& level, const std::uint32_t* number_in_region, const LevelOptions& options)
      : level_(level), number_in_region_(number_in_region), options_(options) {}

  // points: all points of a region, ascending. The caller keeps the array.
  void begin(std::span<const std::uint32_t> points);
  void add_agreed(const Triangle& triangle);
  // Adds the conflicting triangles that fit, in the order of their costs, and fills holes. The call sorts the list.
  void stitch(std::vector<ConflictingTriangle>& conflicting);

  // The triangles to draw, without the agreed ones.
  std::span<const Triangle> drawn() const { return drawn_; }

 private:
  VertexFan* fan_of(std::uint32_t point);
  VertexFan::Sector sector_of(const VertexFan& fan, std::uint32_t first, std::uint32_t second) const;
  bool fits(const Triangle& triangle);
  bool is_isolated(const Triangle& triangle);
  bool has_edge(std::uint32_t from, std::uint32_t to);
  void insert(const Triangle& triangle);
  std::uint32_t next_on_boundary(std::uint32_t before, std::uint32_t at);
  void fill_holes();
  void fill_hole_at(std::uint32_t before, std::uint32_t start);
  bool is_outer_boundary(std::span<const std::uint32_t> loop);
  void fill(std::span<const std::uint32_t> loop);
  float fill_cost(const Triangle& triangle, float squared_longest) const;

  const Level& level_;
  const std::uint32_t* number_in_region_;
  const LevelOptions& options_;
  std::span<const std::uint32_t> points_;
  std::vector<VertexFan> fans_;  // one for each point, and unused ones from larger regions before
  std::vector<std::uint32_t> path_;
  std::vector<Triangle> drawn_;
};

}  // namespace glark::surfel
