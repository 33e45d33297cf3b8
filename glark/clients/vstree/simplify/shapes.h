// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The shape of the surface in a cluster or node, from its samples and triangles.
#pragma once

#include "glark/clients/vstree/simplify/clusters.h"

namespace glark::vstree {

// How far a representative may be from the centroid, relative to the radius. At a boundary, it may reach the corner of
// a cluster whose samples are on one side.
constexpr float most_step = 0.75F, most_step_at_boundary = 1.25F;
constexpr float flat_share = 1e-6F;  // the share of the extent in an error, so that flat parts are divided evenly

// The quadric is relative to the centroid.
struct Shape {
  Float4 sum{};      // the sum of the points; the fourth is their number
  float radius = 0;  // the radius of a sphere about the centroid that holds all points
  Quadric quadric;

  Float4 centroid() const { return without_fourth(sum / sum[3]); }
  // Returns the error of the best point: the sum of the squared distances from the planes, plus a small share of the
  // extent.
  float error() const {
    return quadric.error_at(best_step()) + flat_share * radius * radius * (quadric.weight() + 1e-12F * sum[3]);
  }
  // Returns the step from the centroid to the best point. Planes that are nearly parallel meet far away, as do the
  // planes of a cone. The error falls along the whole step, so the step may
  // end earlier: at a share of the radius.
  Float4 best_step(float share = most_step) const {
    const Float4 step = quadric.best_point();
    const float square = dot(step, step);
    const float most = share * radius;
    return square > most * most ? step * (most / std::sqrt(square)) : step;
  }
};

// The shape of samples, from their tangent planes.
Shape shape_of(std::span<const Record> records);
// The sum of shapes.
Shape sum_of(std::span<const Shape> shapes);

// The representatives of all clusters.
struct Representatives {
  std::vector<Float4> points;   // in the unit cube
  std::vector<Float4> normals;  // the sums of the samples' unit normals
};

// With quadrics, a representative is the point nearest to the planes of the cluster's triangles, weighted by area. A
// triangle belongs to the clusters of all its corners. Without triangles, it is the point nearest to the tangent planes
// of the samples.
Representatives representatives(const Surface& surface, const Clusters& clusters, Representative how,
                                const Workers& workers);

}  // namespace glark::vstree
