/* SPDX-FileCopyrightText: 2026 The glark authors
 * SPDX-License-Identifier: MIT */
#include <glark/c/maps.h>
#include <stdio.h>

#include "sphere_points.h"

static const float corners[] = {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1};
static const uint32_t triangles[] = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};

int main(void) {
  float points[3000];
  const glark_maps_coarse_mesh mesh = {{0, 0, 0}, {corners, 18}, {NULL, 0}, {triangles, 24}, {NULL, 0}};
  const glark_maps_fine_mesh fine = {{0, 0, 0}, {points, 3000}, {points, 3000}, {NULL, 0}, {NULL, 0}};
  glark_maps_model* model = NULL;
  glark_error error;
  int good;
  sphere_points(1000, points);
  if (glark_maps_bake_mesh(&mesh, &fine, 1, NULL, &model, &error) != GLARK_SUCCESS ||
      glark_maps_write_model("maps_c.glb", model, &error) != GLARK_SUCCESS) {
    puts(error.message);
    return 1;
  }
  good = glark_maps_model_counts(model).points == 1000 && glark_maps_displacement_map(model).count > 0;
  glark_maps_model_free(model);
  if (remove("maps_c.glb") != 0 || remove("maps_c.displacement.png") != 0) return 1;
  return good ? 0 : 1;
}
