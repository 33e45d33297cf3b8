/* SPDX-FileCopyrightText: 2026 The glark authors
 * SPDX-License-Identifier: MIT */
#include <glark/c/reconstruct.h>
#include <stdio.h>

#include "sphere_points.h"

int main(void) {
  float points[3000];
  const glark_vstree_point_set set = {{points, 3000}, {points, 3000}, {NULL, 0}, {NULL, 0}};
  glark_reconstruct_mesh* mesh = NULL;
  glark_error error;
  size_t indices;
  sphere_points(1000, points);
  if (glark_reconstruct(&set, NULL, &mesh, &error) != GLARK_SUCCESS) {
    puts(error.message);
    return 1;
  }
  indices = glark_reconstruct_triangles(mesh).count;
  glark_reconstruct_mesh_free(mesh);
  return indices > 100 ? 0 : 1;
}
