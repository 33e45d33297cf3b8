// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Quadratic error functions: sums of the squared distances of a point from planes.
// Source: M. Garland, P. Heckbert, Surface Simplification Using Quadric Error Metrics, 1997.
#pragma once

#include <span>

#include "glark/clients/common/points/moments.h"

namespace glark::vstree {

using namespace common;  // Float4, records and workers

// A quadratic error function about an origin that the caller keeps. The error at x is x^T A x + 2 b x + c.
struct Quadric {
  Float4 rows[3] = {};  // the rows of A; the fourth column is b
  float constant = 0;

  // Adds the plane through `point` with the unit normal, times `weight`.
  void add_plane(Float4 point, Float4 normal, float weight) {
    Float4 plane = without_fourth(normal);
    plane[3] = -dot(plane, point);
    const Float4 weighted = plane * weight;
    rows[0] += splat<0>(plane) * weighted;
    rows[1] += splat<1>(plane) * weighted;
    rows[2] += splat<2>(plane) * weighted;
    constant += plane[3] * weighted[3];
  }
  void add(const Quadric& other) {
    for (int i = 0; i < 3; ++i) rows[i] += other.rows[i];
    constant += other.constant;
  }
  float weight() const { return rows[0][0] + rows[1][1] + rows[2][2]; }  // the weight of all planes
  // Returns the same function relative to an origin that is moved by `by`.
  Quadric moved(Float4 by) const;
  float error_at(Float4 point) const;
  // Returns the point of the least error. In directions that the planes leave open, it stays at the origin.
  Float4 best_point() const;
};

// Returns the mean squared distance of the best point from the tangent planes of the records that have normals.
float best_point_error(std::span<const Record> records, const Moments& moments);

}  // namespace glark::vstree
