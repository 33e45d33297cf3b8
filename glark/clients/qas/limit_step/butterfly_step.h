// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// One step of the Modified Butterfly scheme. The scheme interpolates: its vertices and edge midpoints lie on the limit
// surface.
//
// Based on: Zorin, Schroeder, Sweldens, Interpolating Subdivision for Meshes with Arbitrary Topology, 1996. Our
// additions: creases have the four-point rule. Where a stencil reaches across a crease, the missing vertex is the
// mirror image of the opposite one in the middle of the edge.
#pragma once

#include <cstdint>
#include <vector>

#include "glark/clients/qas/limit_step/limit_step.h"

namespace glark::qas {

class ButterflyStep {
 public:
  // numbering: a limit step of the same topology, which numbers the positions and normals.
  ButterflyStep(const Topology& topology, const LimitStep& numbering);

  // Computes the vertices of the mesh after one step: [position_count()] of the numbering.
  void subdivide(const Workers& workers, const Float4* from, Float4* to) const;
  // points: [position_count()], receives the vertices after the step. frame.from is the mesh.
  void run(const Workers& workers, const LimitStep::Frame& frame, Float4* points) const;

 private:
  struct Term {
    std::uint32_t point;
    float weight;
  };
  // A term of the two tangents at a vertex. `point` is a vertex after the step.
  struct TangentTerm {
    std::uint32_t point;
    float first, second;
  };
  struct Normal {
    std::uint32_t centre, normal;
    std::size_t first, last;  // a range in tangent_terms_
    std::uint32_t coarse;     // the triangle that gives the normal if the tangents do not
  };

  void add_term(std::uint32_t vertex, double weight);
  void add_edge(const Topology& topology, std::uint32_t edge);
  void add_crease(const Topology& topology, const Edge& edge);
  void add_spokes(const Topology& topology, std::uint32_t half_edge, double share);
  void add_wing(const Topology& topology, std::uint32_t half_edge);
  void add_vertex_normal(const Topology& topology, std::uint32_t sector);
  void add_edge_normals(const Topology& topology, std::uint32_t edge);
  void add_smooth_edge_normal(const Topology& topology, std::uint32_t edge);
  void begin_normal(std::uint32_t centre, std::uint32_t normal, std::uint32_t half_edge);
  void add_tangent(std::uint32_t point, double weight, double angle);

  std::size_t vertex_count_ = 0;
  const LimitStep& numbering_;
  std::vector<std::size_t> first_term_;  // the first term of each edge, and the end
  std::vector<Term> terms_;              // the terms of coarse vertices
  std::vector<Normal> normals_;
  std::vector<TangentTerm> tangent_terms_;
  std::vector<std::uint32_t> triangles_;
};

}  // namespace glark::qas
