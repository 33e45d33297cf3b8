// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/maps.h>

#include <cstdio>

#include "sphere_points.h"

int main() {
  const std::vector<float> points = sphere_points(1000);
  const std::vector<float> corners = {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1};
  const std::vector<std::uint32_t> triangles = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
  glark::maps::FineMesh fine;
  fine.positions = fine.normals = points;
  glark::maps::CoarseMesh coarse;
  coarse.positions = corners;
  coarse.triangles = triangles;
  const glark::maps::Baked model = glark::maps::bake(coarse, glark::maps::mesh_source(fine, 1));
  glark::maps::write_model("maps_cpp.glb", model);
  const bool is_written = std::remove("maps_cpp.glb") == 0 && std::remove("maps_cpp.displacement.png") == 0;
  return is_written && model.points == 1000 && model.scale > 0 ? 0 : 1;
}
