// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What the samples and triangles of a cluster or of a node say of the surface there.
#pragma once

#include "glark/clients/vstree/simplify/clusters.h"

namespace glark::vstree {

constexpr float flat_share = 1e-6F;  // of the extent in an error, so that what is flat is divided evenly

// Its quadric is about its centroid.
struct Shape {
  Float4 sum{};      // of the points; the fourth is their number
  float radius = 0;  // all points are so near to the centroid
  Quadric quadric;

  Float4 centroid() const { return without_fourth(sum / sum[3]); }
  // Of the best point: the sum of the squared distances from the planes, and a little of the extent.
  float error() const {
    return quadric.error_at(best_step()) + flat_share * radius * radius * (quadric.weight() + 1e-12F * sum[3]);
  }
  // From the centroid to the best point. Planes that are nearly one, or those of a cone, meet far away. But the error only falls on the
  // way there: it ends within the cluster.
  Float4 best_step() const {
    const Float4 step = quadric.best_point();
    const float square = dot(step, step);
    const float most = 0.75F * radius;
    return square > most * most ? step * (most / std::sqrt(square)) : step;
  }
};

// Of samples, by their tangent planes.
Shape shape_of(std::span<const Record> records);
// Of all of some shapes.
Shape sum_of(std::span<const Shape> shapes);

// Of each cluster.
struct Representatives {
  std::vector<Float4> points;   // in the unit cube
  std::vector<Float4> normals;  // the sums of the samples' unit normals
};

// By quadrics: nearest to the planes of a cluster's triangles, weighed by area, each at the clusters of its corners; or, without
// triangles, to the tangent planes of the samples.
Representatives representatives(const Surface& surface, const Clusters& clusters, Representative how,
                                const Workers& workers);

}  // namespace glark::vstree
