// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The first pass over the points: how many there are for each triangle, and how far they are from the coarse mesh.
#pragma once

#include <vector>

#include "glark/clients/maps/project/shell.h"
#include "glark/clients/maps/project/splatter.h"

namespace glark::maps {

struct Census {
  std::vector<double> points;  // of each triangle; an estimate, because one point of several is looked at
  std::vector<float> spreads;  // of normals, as find_hard_edges() needs them; empty without normals
  double points_with_foot = 0;
  double root_mean_square = 0;  // of the heights
};

// Looks at about 250 000 points, in runs that are spread evenly over the stream.
Census take_census(SampleStream& stream, const Shell& shell, std::size_t triangles, const common::Workers& workers);

}  // namespace glark::maps
