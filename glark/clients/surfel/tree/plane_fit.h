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

// The plane through the mean position. Its normal is the mean of the surfels' normals, or the direction of least
// variance where these normals cancel or are not known.
Plane fit_plane(std::span<const Surfel> surfels);

// The mean distance between neighbours. It assumes that the surfels cover a rectangle of the plane evenly, or a line;
// their variances give its sides.
float mean_spacing(std::span<const Surfel> surfels, const Plane& plane);

}  // namespace glark::surfel
