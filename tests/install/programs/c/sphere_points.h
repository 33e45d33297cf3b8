/* SPDX-FileCopyrightText: 2026 The glark authors
 * SPDX-License-Identifier: MIT */
#pragma once

#include <math.h>

/* Points that lie evenly on the unit sphere. A normal of this sphere equals its point. positions: [3 * count]. */
static void sphere_points(int count, float* positions) {
  int i;
  for (i = 0; i < count; ++i) {
    const double z = 1 - (2.0 * i + 1) / count;
    const double radius = sqrt(1 - z * z);
    positions[3 * i] = (float)(radius * cos(2.39996323 * i));
    positions[3 * i + 1] = (float)(radius * sin(2.39996323 * i));
    positions[3 * i + 2] = (float)z;
  }
}
