// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The points of a mesh, each with all vertices at its position; the edges between points; and the sectors into which
// creases divide the triangles around a point.
#pragma once

#include <cstdint>
#include <vector>

#include "glark/clients/common/vector.h"
#include "glark/pn.h"

namespace glark::pn {

using Vector = common::Vector3d;

// An edge between two points, a < b, with one or more triangles.
struct Edge {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  std::uint32_t first = 0;  // the index of the first of its sides
  std::uint32_t count = 0;
  bool crease = false;
};

// The edge of one triangle from corner k to the next corner.
struct Side {
  std::uint32_t triangle = 0;
  std::uint32_t k = 0;
};

class SurfacePoints {
 public:
  // Errors: as derive_tags() for the arrays of the mesh.
  SurfacePoints(const Mesh& mesh, double crease_degrees);

  std::uint32_t count() const { return point_count_; }
  std::uint32_t point_of(std::uint32_t vertex) const { return point_of_[vertex]; }
  std::uint32_t point_at(std::uint32_t corner) const { return point_of_[mesh_.triangles[corner]]; }
  bool degenerate(std::uint32_t triangle) const { return degenerate_[triangle]; }
  const std::vector<Edge>& edges() const { return edges_; }
  const std::vector<Side>& sides() const { return sides_; }
  // The sector of corner 3 t + k. Corners that no crease separates at their point have the same sector.
  std::uint32_t sector(std::uint32_t corner) const { return sector_[corner]; }
  // The unit normal of a sector; (0, 0, 1) where it is unknown.
  const Vector& normal(std::uint32_t sector) const { return normals_[sector]; }
  // The sectors at each point, in ascending order.
  const std::vector<std::vector<std::uint32_t>>& sectors() const { return sectors_; }

 private:
  void weld();
  void find_edges();
  void mark_creases(double crease_degrees);
  void name_creases();
  void find_sectors();
  void find_normals();
  std::uint32_t corner_of(const Side& side, std::uint32_t point) const;
  Vector position(std::uint32_t vertex) const;
  Vector given_normal(std::uint32_t vertex) const;  // returns zero if there is none
  bool normals_differ(const Edge& edge) const;
  const Edge* find(std::uint32_t a, std::uint32_t b) const;

  const Mesh& mesh_;
  std::uint32_t point_count_ = 0;
  std::vector<std::uint32_t> point_of_;
  std::vector<bool> degenerate_;
  std::vector<Vector> planes_;  // normals of the triangles; the length is twice the area
  std::vector<Edge> edges_;     // sorted by their points
  std::vector<Side> sides_;
  std::vector<std::uint32_t> sector_;
  std::vector<Vector> normals_;
  std::vector<std::vector<std::uint32_t>> sectors_;
};

}  // namespace glark::pn
