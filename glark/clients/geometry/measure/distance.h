// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The distance between two surfaces. The distance to a surface is the distance to its triangles, or to its points if it
// has no triangles.
#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "glark/clients/geometry/geometry.h"

namespace glark::geometry {

// Distances from samples of one surface to the other. The samples are random points on the triangles, and the corners
// of triangles. Without triangles, all points are samples.
struct OneWay {
  double greatest = 0;            // in the unit of the positions
  double rms = 0;                 // over the random points on triangles, or over points if there are no triangles
  double normal_rms_degrees = 0;  // 0 to 180; between normals of triangles, or else normals of points
  bool has_normals = false;
};

struct Distance {
  OneWay there, back;   // there: from the result to the reference; back: the opposite way
  double diagonal = 0;  // the diagonal of the reference's bounding box

  double hausdorff() const { return there.greatest > back.greatest ? there.greatest : back.greatest; }
  double rms() const;  // over both ways
};

// Returns the diagonal of the bounding box of the points. There is at least one.
double diagonal_of(const Geometry& geometry);

// Returns the distance of each point to the surface, in the unit of the positions. Neither geometry is empty.
std::vector<float> distances_of_points(const Geometry& points, const Geometry& surface);

Distance distance_between(const Geometry& result, const Geometry& reference,
                          const std::function<void(double fraction)>& progress);

// How exact a Hausdorff distance must be. Less saves time.
struct Needed {
  double least = 0;                                       // a distance that is less gives this number
  double most = std::numeric_limits<double>::infinity();  // one that is more gives any number above this one
  std::size_t one_of = 1;                                 // takes one of so many random points on triangles
};

// Without limits, it returns distance_between(result, reference).hausdorff(), in less time.
using HausdorffDistance = std::function<double(const Geometry& result, const Needed& needed)>;

// Returns the function for a reference, which outlives it. Neither geometry is empty.
HausdorffDistance hausdorff_from(const Geometry& reference);

}  // namespace glark::geometry
