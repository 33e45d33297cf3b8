// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The height-field indicator: whether surfels can be projected onto a plane without folds.
// Based on: Boubekeur 2007, ch. 3.2.2.
#pragma once

#include <cstddef>
#include <span>

#include "glark/clients/surfel/tree/plane_fit.h"

namespace glark::surfel {

struct HeightFieldLimits {
  float delta_a;  // the least cosine between a surfel's normal and the plane's
  float delta_d;  // the greatest distance of a surfel from the plane, in radii of the surfels
};

enum class Shape {
  height_field,
  folded,  // a normal differs from the plane's normal by more than delta_a allows
  thick,   // a surfel is farther from the plane than delta_d allows
};

Shape classify_shape(std::span<const Surfel> surfels, const Plane& plane, const HeightFieldLimits& limits);

// Partitions folded surfels by the two normals that differ most. Returns the size of the first part.
std::size_t split_by_normals(std::span<Surfel> surfels, const Plane& plane);

}  // namespace glark::surfel
