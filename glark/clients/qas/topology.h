// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The topology that the limit rules need: the edges of a triangle mesh, and for every vertex the fans of triangles
// between creases.
#pragma once

#include <glark/qas.h>

#include <array>
#include <cstdint>
#include <vector>

namespace glark::qas {

inline constexpr std::uint32_t none = 0xFFFFFFFFU;

// Triangles around a vertex that are joined by smooth edges. They share one normal. The ring of an open sector has one
// more vertex than the sector has triangles.
struct Sector {
  std::uint32_t vertex;
  std::uint32_t first;  // an index in Topology::rings; the ring is counter-clockwise
  std::uint32_t count;
  bool closed;  // the triangles surround the vertex, possibly with the one crease of a dart
};

enum class Rule : std::uint8_t { smooth, crease, corner };

struct Edge {
  std::array<std::uint32_t, 2> ends;
  std::uint32_t first_side;  // an index in Topology::sides
  std::uint32_t side_count;  // 2 if smooth
  bool smooth;               // not a boundary, crease or non-manifold edge
  bool marked;               // the caller made it a crease, not its sides
};

struct Topology {
  std::uint32_t vertex_count = 0;
  std::vector<std::uint32_t> triangles;  // as given, three indices each
  // For each triangle, the triangle that it copies: itself, an earlier triangle with the same vertices, or none if two
  // of its vertices are equal.
  std::vector<std::uint32_t> same_as;
  std::vector<Edge> edges;             // in the order of the triangles
  std::vector<std::uint32_t> sides;    // half-edges 3 * triangle + i, from corner i to corner i + 1
  std::vector<std::uint32_t> edge_of;  // the edge of each half-edge; none in copies and degenerate triangles
  std::vector<Sector> sectors;
  std::vector<std::uint32_t> rings;
  std::vector<std::uint32_t> sector_of;                         // the sector of each corner
  std::vector<Rule> rules;                                      // the rule of each vertex
  std::vector<std::array<std::uint32_t, 2>> crease_neighbours;  // for crease vertices

  std::uint32_t corner(std::uint32_t half_edge) const { return triangles[half_edge]; }
  std::uint32_t opposite(std::uint32_t half_edge) const { return triangles[before(half_edge)]; }
  static std::uint32_t after(std::uint32_t half_edge) { return half_edge % 3 == 2 ? half_edge - 2 : half_edge + 1; }
  static std::uint32_t before(std::uint32_t half_edge) { return half_edge % 3 == 0 ? half_edge + 2 : half_edge - 1; }
  // Returns the half-edge across a smooth edge, or none at other edges.
  std::uint32_t twin(std::uint32_t half_edge) const {
    const Edge& edge = edges[edge_of[half_edge]];
    if (!edge.smooth) return none;
    return sides[edge.first_side] == half_edge ? sides[edge.first_side + 1] : sides[edge.first_side];
  }
};

// Throws Error.
Topology analyse(const Mesh& mesh);

}  // namespace glark::qas
