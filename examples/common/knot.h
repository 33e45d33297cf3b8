// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace lesson {

struct Points {
  std::vector<float> positions, normals;  // three for each point
};

// Points on the surface of a knot about the z axis, evenly spread and unordered. The normals have the length 1.
Points make_knot(int count);

}  // namespace lesson
