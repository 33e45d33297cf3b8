// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The sphere that the scenes draw: a coarse one, so that refinement has something to do. Normals are its positions.
#pragma once

#include <math.h>

enum { sphere_rings = 8, sphere_sectors = 12, sphere_corners = (sphere_rings + 1) * (sphere_sectors + 1) };
enum { sphere_indices = sphere_rings * sphere_sectors * 6 };

// positions: 3 floats a corner, on the unit sphere; indices: triangles, counter-clockwise from outside.
static inline void make_sphere(float positions[3 * sphere_corners], unsigned short indices[sphere_indices]) {
  const double pi = 3.14159265358979;
  for (int r = 0; r <= sphere_rings; ++r) {
    for (int s = 0; s <= sphere_sectors; ++s) {
      const double polar = pi * r / (double)sphere_rings;
      const double turn = 2 * pi * s / (double)sphere_sectors;
      float* p = positions + 3 * (r * (sphere_sectors + 1) + s);
      p[0] = (float)(sin(polar) * cos(turn));
      p[1] = (float)cos(polar);
      p[2] = (float)(-sin(polar) * sin(turn));
    }
  }
  for (int r = 0; r < sphere_rings; ++r) {
    for (int s = 0; s < sphere_sectors; ++s) {
      const unsigned short a = (unsigned short)(r * (sphere_sectors + 1) + s);
      const unsigned short b = (unsigned short)(a + sphere_sectors + 1);
      const unsigned short corners[6] = {
          a, b, (unsigned short)(b + 1), a, (unsigned short)(b + 1), (unsigned short)(a + 1)};
      for (int i = 0; i < 6; ++i) indices[(r * sphere_sectors + s) * 6 + i] = corners[i];
    }
  }
}
