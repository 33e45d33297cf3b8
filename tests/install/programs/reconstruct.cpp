// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/reconstruct.h>

#include "sphere_points.h"

int main() {
  const std::vector<float> points = sphere_points(4000);
  return glark::reconstruct::reconstruct({.positions = points, .normals = points}).triangles.empty() ? 1 : 0;
}
