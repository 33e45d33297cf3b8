/* SPDX-FileCopyrightText: 2026 The glark authors
 * SPDX-License-Identifier: MIT */
#include <glark/c/depth.h>
#include <stdio.h>

int main(void) {
  const uint32_t triangle[3] = {0, 1, 2};
  const float positions[9] = {0, 0, 0, 1, 0, 0, 0, 5, 0};
  float tags[3] = {-1, -1, -1};
  const glark_indices triangles = {triangle, 3};
  const glark_floats points = {positions, 9};
  const glark_float_output output = {tags, 3};
  const glark_depth_distance_range range = glark_depth_default_distance_range();
  glark_depth_tagger* tagger = NULL;
  glark_error error;
  if (glark_depth_tagger_create(3, triangles, 5, &tagger, &error) != GLARK_SUCCESS ||
      glark_depth_by_distance(tagger, points, &range, output, &error) != GLARK_SUCCESS) {
    puts(error.message);
    return 1;
  }
  glark_depth_tagger_free(tagger);
  return tags[0] > tags[2] ? 0 : 1;
}
