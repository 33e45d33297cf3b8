/* SPDX-FileCopyrightText: 2026 The glark authors
 * SPDX-License-Identifier: MIT */
#include <glark/c/vstree.h>
#include <stdio.h>

#include "sphere_points.h"

int main(void) {
  float points[3000];
  const glark_vstree_point_set set = {{points, 3000}, {points, 3000}, {NULL, 0}, {NULL, 0}};
  glark_vstree_tree* tree = NULL;
  glark_error error;
  size_t leaves;
  sphere_points(1000, points);
  if (glark_vstree_tree_create(&set, NULL, &tree, &error) != GLARK_SUCCESS) {
    puts(error.message);
    return 1;
  }
  leaves = glark_vstree_tree_leaf_count(tree);
  glark_vstree_tree_free(tree);
  return leaves > 1 ? 0 : 1;
}
