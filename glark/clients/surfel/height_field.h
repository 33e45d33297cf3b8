// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Whether points lie over a plane, and which.
// Based on: Boubekeur 2007, ch. 3.2.2 and 5.2.1.
#pragma once

#include <span>

#include "glark/clients/surfel/stripping_tree.h"

namespace glark::surfel {

struct Plane {
  Vector centre;
  Vector normal;  // of unit length: the mean of the points', or the direction in which they extend least
};

Plane fit_plane(std::span<const Surfel> surfels);

// Of neighbours, were the points spread evenly over a rectangle of the plane that has their variances, or over a line.
float mean_distance(std::span<const Surfel> surfels, const Plane& plane);

enum class Shape { height_field, folded, thick };  // thick: a point is too far from the plane

Shape shape_of(std::span<const Surfel> surfels, const Plane& plane, const TreeOptions& options);

// Reorders folded surfels so that those of two normals of the most different come first and last; how many are first.
std::size_t split_by_normals(std::span<Surfel> surfels, const Plane& plane);

}  // namespace glark::surfel
