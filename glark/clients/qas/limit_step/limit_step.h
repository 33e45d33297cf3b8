// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// One limit step of Loop's scheme: positions and normals of the limit surface at the vertices and edge midpoints of a
// mesh.
#pragma once

#include <cstdint>
#include <vector>

#include "glark/clients/common/workers.h"
#include "glark/clients/qas/float4.h"
#include "glark/clients/qas/limit_step/stencils.h"
#include "glark/clients/qas/topology.h"

namespace glark::qas {

class LimitStep {
 public:
  explicit LimitStep(const Topology& topology) : stencils_(make_stencils(topology)) {}

  std::size_t position_count() const { return stencils_.counts.vertices + stencils_.counts.edges; }
  std::size_t normal_count() const { return stencils_.counts.normals; }
  const std::vector<Patch>& patches() const { return stencils_.patches; }

  struct Frame {
    const Float4* from;  // [vertex_count]
    Float4* shift;       // [vertex_count], receives what one step of subdivision adds to a vertex
    Vector* positions;   // [position_count()]
    Vector* normals;     // [normal_count()]
    float unscale;       // the factor from the scaled space to the caller's space
  };
  void run(const Workers& workers, const Frame& frame) const;
  // Sets the normals of elements without a normal, and of triangles that are drawn as the back of another one.
  void finish(const Frame& frame) const;
  // Computes the vertices of the mesh after one step of subdivision: [position_count()].
  void subdivide(const Workers& workers, const Float4* from, Float4* to) const;

 private:
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

  const Stencils stencils_;
};

}  // namespace glark::qas
