// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/vstree.h>

#include "sphere_points.h"

int main() {
  const std::vector<float> points = sphere_points(1000);
  const glark::vstree::Tree tree({.positions = points, .normals = points});
  return tree.leaf_count() > 1 ? 0 : 1;
}
