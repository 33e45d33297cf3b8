// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Tables of stencils for a limit step, made from the topology. The tables are grouped by kind, so that no kernel
// branches on the kind.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "glark/clients/qas/topology.h"

namespace glark::qas {

// The weights of the ends and of the opposite vertices for the middle of an edge: Loop's rule, and a cubic B-spline on
// creases.
inline constexpr float smooth_end = 0.375F, smooth_opposite = 0.125F;
inline constexpr float sharp_end = 0.5F, sharp_opposite = 0;

// Vertices of the same valence inside closed fans. Their rings lie one after the other.
struct Fan {
  std::uint32_t valence;
  std::uint32_t first;  // in fan_vertices
  std::uint32_t count;
  std::size_t first_ring;    // in Stencils::rings
  std::size_t first_weight;  // in Stencils::weights
  float shift;               // the factor of the sum over the ring: Loop's beta
  float limit;
};
struct FanVertex {
  std::uint32_t vertex, sector;
};
struct CreaseVertex {
  std::uint32_t vertex, before, after;
};
struct OpenSector {
  std::uint32_t sector, vertex, count;
  std::size_t first_ring;
  std::size_t first_weight;
  bool corner;
  bool closed;
};
struct TangentWeights {
  float first, second;
};
// An edge a b. The vertices c and d are opposite to it, in the triangles a b c and b a d. Four more vertices lie across
// the edges a c, b c, a d and b d.
struct SmoothEdge {
  std::uint32_t a, b, c, d;
  std::array<std::uint32_t, 4> across;
  std::uint32_t edge;
};
// The weights of the middles of the edges a c, b c, a d, b d.
struct MiddleWeights {
  std::array<float, 4> ends, opposites;
};
struct SharpEdge {
  std::uint32_t a, b, edge;
};
struct SharpSide {
  std::uint32_t a, b, c;
  std::array<std::uint32_t, 2> across;  // the vertices across a c and b c
  std::array<float, 2> ends, opposites;
  std::uint32_t normal;
};
struct Reversed {
  std::uint32_t from, to;
};

struct VertexStencils {
  std::vector<Fan> fans;
  std::vector<FanVertex> fan_vertices;
  std::vector<CreaseVertex> creases;
  std::vector<std::uint32_t> corners;
  std::vector<OpenSector> open_sectors;
};

struct EdgeStencils {
  std::vector<SmoothEdge> regular;  // edges without a crease nearby
  std::vector<SmoothEdge> general;
  std::vector<MiddleWeights> middle_weights;  // the weights of the general edges
  std::vector<SharpEdge> sharp;
  std::vector<SharpSide> sharp_sides;
};

struct Stencils {
  struct Counts {
    std::size_t vertices, edges, sectors, normals;
  };
  Counts counts{};
  VertexStencils vertices;
  EdgeStencils edges;
  std::vector<std::uint32_t> rings;
  std::vector<TangentWeights> weights;
  std::size_t no_normal = 0;  // where elements without a normal point to
  std::vector<Reversed> reversed;
  std::vector<Patch> patches;
};

Stencils make_stencils(const Topology& topology);

}  // namespace glark::qas
