// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The distance of meshes from a statue.
#pragma once

#include <cmath>

#include "tests/bench_points/measure/surface_distance.h"
#include "tests/reconstruct/meshes.h"
#include "tests/shapes/clouds.h"

namespace glark::reconstruct::test {

// Root mean squares, relative to the statue's diagonal.
struct StatueDistance {
  double to_statue = 0, from_statue = 0;
};

inline StatueDistance distance_from(const shapes::Statue& statue, const Reconstructed& mesh) {
  constexpr std::size_t samples = 5000;
  StatueDistance result;
  const std::vector<float> on_mesh = bench::samples_of(mesh.positions, mesh.triangles, samples);
  for (std::size_t i = 0; i < on_mesh.size(); i += 3) {
    const double off = statue.distance(
        {static_cast<double>(on_mesh[i]), static_cast<double>(on_mesh[i + 1]), static_cast<double>(on_mesh[i + 2])});
    result.to_statue += off * off / samples;
  }
  result.to_statue = std::sqrt(result.to_statue) / statue.diagonal();
  const shapes::Cloud surface = shapes::cloud_of(statue, 99, {.samples = samples});
  result.from_statue =
      bench::SurfaceDistance(mesh.positions, mesh.triangles).rms(surface.positions) / statue.diagonal();
  return result;
}

inline PointSet points_of(const shapes::Cloud& cloud) {
  return {.positions = cloud.positions, .normals = cloud.normals};
}

}  // namespace glark::reconstruct::test
