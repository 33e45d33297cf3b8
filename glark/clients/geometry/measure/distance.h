// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The distance between two surfaces. It is measured to the triangles of a surface, or to its points if it has no
// triangles.
#pragma once

#include <functional>

#include "glark/clients/geometry/geometry.h"

namespace glark::geometry {

// Distances from samples of one surface to the other. The samples are the points, except points without triangles, and
// random points on the triangles.
struct OneWay {
  double greatest = 0;            // in the unit of the positions
  double rms = 0;                 // over the random points on triangles, or over points if there are no triangles
  double normal_rms_degrees = 0;  // 0 to 180; between normals of triangles, or those of the points
  bool has_normals = false;
};

struct Distance {
  OneWay there, back;   // from the result to the reference, and from that to the result
  double diagonal = 0;  // of the reference's bounding box

  double hausdorff() const { return there.greatest > back.greatest ? there.greatest : back.greatest; }
  double rms() const;  // of both ways together
};

Distance distance_between(const Geometry& result, const Geometry& reference,
                          const std::function<void(double fraction)>& progress);

}  // namespace glark::geometry
