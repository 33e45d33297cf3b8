/* SPDX-FileCopyrightText: 2026 The glark authors
 * SPDX-License-Identifier: MIT */
#include <glark/c/qas.h>
#include <stdio.h>

int main(void) {
  const uint32_t corners[12] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
  const float positions[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const glark_qas_mesh mesh = {4, {corners, 12}, {NULL, 0}};
  const glark_floats points = {positions, 12};
  glark_qas_surface* surface = NULL;
  glark_error error;
  size_t patches;
  if (glark_qas_surface_create(&mesh, NULL, &surface, &error) != GLARK_SUCCESS ||
      glark_qas_surface_update(surface, points, &error) != GLARK_SUCCESS) {
    puts(error.message);
    return 1;
  }
  patches = glark_qas_surface_patches(surface).count;
  glark_qas_surface_free(surface);
  return patches == 4 ? 0 : 1;
}
