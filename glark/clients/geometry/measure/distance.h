// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// How far two surfaces are from each other, measured to triangles where there are any, to points otherwise.
#pragma once

#include <functional>

#include "glark/clients/geometry/geometry.h"

namespace glark::geometry {

// From samples of one surface to the nearest place of the other: all points (but those of no triangle), and samples of triangles by area.
struct OneWay {
  double greatest = 0;            // in the unit of the positions
  double rms = 0;                 // over the samples of triangles, or over points where there are none
  double normal_rms_degrees = 0;  // 0 to 180; of triangles, or the points' own
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
