// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/surfel.h>

#include "sphere_points.h"

int main() {
  const std::vector<float> points = sphere_points(1000);
  const glark::surfel::Strips strips({.positions = points, .normals = points});
  return strips.indices().empty() ? 1 : 0;
}
