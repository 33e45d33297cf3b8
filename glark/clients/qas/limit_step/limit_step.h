// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// One limit step of Loop's scheme: positions and normals of the limit surface at the vertices and edge midpoints of a
// mesh. Tables of stencils are made from the topology. They are grouped by kind, so that no kernel branches on the
// kind.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "glark/clients/common/workers.h"
#include "glark/clients/qas/float4.h"
#include "glark/clients/qas/topology.h"

namespace glark::qas {

// The weights of the ends and of the opposite vertices for the middle of an edge: Loop's rule, and a cubic B-spline on
// creases.
inline constexpr float smooth_end = 0.375F, smooth_opposite = 0.125F;
inline constexpr float sharp_end = 0.5F, sharp_opposite = 0;

class LimitStep {
 public:
  explicit LimitStep(const Topology& topology);

  std::size_t position_count() const { return vertex_count_ + edge_count_; }
  std::size_t normal_count() const { return normal_count_; }
  const std::vector<Patch>& patches() const { return patches_; }

  struct Frame {
    const Float4* from;  // [vertex_count]
    Float4* shift;       // [vertex_count], receives what one step of subdivision adds to a vertex
    Vector* positions;   // [position_count()]
    Vector* normals;     // [normal_count()]
    float unscale;       // the factor of the resulting positions
  };
  void run(const Workers& workers, const Frame& frame) const;
  // Sets the normals of elements without a normal, and of triangles that are drawn as the back of another one.
  void finish(const Frame& frame) const;
  // Computes the vertices of the mesh after one step of subdivision: [position_count()].
  void subdivide(const Workers& workers, const Float4* from, Float4* to) const;

 private:
  // Vertices of the same valence inside closed fans. Their rings lie one after the other.
  struct Fan {
    std::uint32_t valence;
    std::uint32_t first;  // in fan_vertices_
    std::uint32_t count;
    std::size_t first_ring;    // in rings_
    std::size_t first_weight;  // in weights_
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
  // An edge a b, the opposite vertices c of triangle a b c and d of b a d, and those across a c, b c, a d, b d.
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
    std::array<std::uint32_t, 2> across;  // a c, b c
    std::array<float, 2> ends, opposites;
    std::uint32_t normal;
  };
  struct Reversed {
    std::uint32_t from, to;
  };

  void add_fans(const Topology& topology);
  void add_to_fan(const FanVertex& vertex, std::uint32_t valence);
  void add_closed_tangents(std::uint32_t valence);
  void add_ring(const Topology& topology, const Sector& sector, std::uint32_t count);
  void add_open_sectors(const Topology& topology);
  void add_edges(const Topology& topology);
  void add_smooth_edge(const Topology& topology, std::uint32_t edge);
  void add_sharp_edge(const Topology& topology, std::uint32_t edge, std::uint32_t& extra_normal);
  void add_patches(const Topology& topology);
  Patch copied_patch(const Topology& topology, std::uint32_t triangle);

  // With_limits: computes shifts and limits. Otherwise frame.shift receives the vertices after the step.
  template <bool With_limits>
  void run_fans(const Frame& frame, std::size_t begin, std::size_t end) const;
  template <bool With_limits>
  void run_fan(const Frame& frame, const Fan& fan, std::size_t begin, std::size_t end) const;
  template <bool With_limits>
  void run_regular_fan(const Frame& frame, const Fan& fan, std::size_t begin, std::size_t end) const;
  template <bool With_limits>
  void run_creases(const Frame& frame, std::size_t begin, std::size_t end) const;
  void run_open_sectors(const Frame& frame, std::size_t begin, std::size_t end) const;
  void finish_edge(const Frame& frame, const SmoothEdge& edge, Float4 limit, Float4 along, Float4 across) const;
  void run_regular_edges(const Frame& frame, std::size_t begin, std::size_t end) const;
  void run_general_edges(const Frame& frame, std::size_t begin, std::size_t end) const;
  void run_sharp_edges(const Frame& frame, std::size_t begin, std::size_t end) const;
  void run_sharp_sides(const Frame& frame, std::size_t begin, std::size_t end) const;

  std::size_t vertex_count_, edge_count_, sector_count_, normal_count_;
  std::size_t no_normal_ = 0;  // of elements without a normal
  std::vector<Fan> fans_;
  std::vector<FanVertex> fan_vertices_;
  std::vector<std::uint32_t> rings_;
  std::vector<TangentWeights> weights_;
  std::vector<CreaseVertex> creases_;
  std::vector<std::uint32_t> corners_;
  std::vector<OpenSector> open_sectors_;
  std::vector<SmoothEdge> regular_edges_;  // no crease is near
  std::vector<SmoothEdge> general_edges_;
  std::vector<MiddleWeights> middle_weights_;  // of general_edges_
  std::vector<SharpEdge> sharp_edges_;
  std::vector<SharpSide> sharp_sides_;
  std::vector<std::uint32_t> normal_of_;  // of each half-edge, until the patches are made
  std::vector<Reversed> reversed_;
  std::vector<Patch> patches_;
};

}  // namespace glark::qas
