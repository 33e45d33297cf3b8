/* SPDX-FileCopyrightText: 2026 The glark authors
 * SPDX-License-Identifier: MIT */
#include <glark/c/surfel.h>
#include <stdio.h>

#include "sphere_points.h"

int main(void) {
  float points[3000];
  const glark_surfel_cloud cloud = {{points, 3000}, {points, 3000}};
  glark_surfel_strips* strips = NULL;
  glark_error error;
  size_t indices;
  sphere_points(1000, points);
  if (glark_surfel_strips_create(&cloud, NULL, &strips, &error) != GLARK_SUCCESS) {
    puts(error.message);
    return 1;
  }
  indices = glark_surfel_strips_indices(strips).count;
  glark_surfel_strips_free(strips);
  return indices > 1000 ? 0 : 1;
}
