// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Groups of samples, each of which one point will stand for.
#pragma once

#include <glark/vstree.h>

#include "glark/clients/vstree/quadric.h"
#include "glark/clients/workers.h"

namespace glark::vstree {

// What is to be simplified, in the unit cube.
struct Surface {
  Cube cube;
  std::vector<Float4> points;
  std::vector<Float4> normals;  // of unit length or zero, the fourth 1 or 0
  std::span<const std::uint32_t> triangles;
};

// A cluster's quadric about its centroid.
struct Shape {
  Float4 sum{};      // of the points; the fourth is their number
  float radius = 0;  // all points are so near to the centroid
  Quadric quadric;

  Float4 centroid() const { return without_fourth(sum / sum[3]); }
  // From the centroid to the best point. Planes that are nearly one, or those of a cone, meet far away. But the error only falls on the
  // way there: it ends within the cluster.
  Float4 best_step() const {
    const Float4 step = quadric.best_point();
    const float square = dot(step, step);
    const float most = 0.75F * radius;
    return square > most * most ? step * (most / std::sqrt(square)) : step;
  }
};

struct Clusters {
  std::uint32_t count = 0;
  std::vector<std::uint32_t> of;         // [points]
  std::vector<std::uint32_t> nodes;      // [count], of the tree that they come from
  std::vector<Shape> shapes;             // [count], or empty: not known yet
  std::vector<std::uint32_t> triangles;  // over clusters; empty: not known yet
};

// Adds the planes of triangles or samples to the quadrics of their groups, whose sums are known.
void add_quadrics(const Surface& surface, std::span<const std::uint32_t> groups, std::vector<Shape>& shapes);

// Of groups of samples, by the planes of their triangles, weighed by area: those of a corner each; or, without triangles, by the
// tangent planes of the samples. `groups`: the group of each point.
std::vector<Shape> shapes_of(const Surface& surface, std::span<const std::uint32_t> groups, std::size_t count);

Clusters cluster(const Surface& surface, const SimplifyOptions& options, const Workers& workers);

// How many triangles have their corners in three clusters.
std::size_t spanning_triangles(std::span<const std::uint32_t> triangles, std::span<const std::uint32_t> clusters);

}  // namespace glark::vstree
