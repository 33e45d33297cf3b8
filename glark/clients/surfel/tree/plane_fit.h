// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Planes through surfels.
// Based on: Boubekeur 2007, ch. 5.2.1.
#pragma once

#include <span>

#include "glark/clients/surfel/tree/stripping_tree.h"

namespace glark::surfel {

struct Plane {
  Vector centre;
  Vector normal;  // unit length
};

// Returns the plane through the mean position. Its normal is the mean of the surfels' normals. If these cancel or are
// not known, the normal is the direction of least variance.
Plane fit_plane(std::span<const Surfel> surfels);

// Returns the mean distance between neighbours. It assumes that the surfels evenly cover a rectangle of the plane, or a
// line. The variances of the surfels give the sides of the rectangle.
float mean_spacing(std::span<const Surfel> surfels, const Plane& plane);

}  // namespace glark::surfel
