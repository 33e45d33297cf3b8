/* SPDX-FileCopyrightText: 2026 The glark authors
 * SPDX-License-Identifier: MIT */
#include <glark/c/pn.h>
#include <stdio.h>

int main(void) {
  const uint32_t corners[6] = {0, 1, 2, 2, 1, 3};
  const float positions[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 1};
  const glark_pn_mesh mesh = {{positions, 12}, {corners, 6}, {NULL, 0}, {NULL, 0}};
  glark_pn_tagged_mesh* tagged = NULL;
  glark_error error;
  size_t numbers;
  if (glark_pn_derive_tags(&mesh, NULL, &tagged, &error) != GLARK_SUCCESS) {
    puts(error.message);
    return 1;
  }
  numbers = glark_pn_normals(tagged).count;
  glark_pn_tagged_mesh_free(tagged);
  return numbers >= 12 ? 0 : 1;
}
