// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Closed meshes, and how many edges of a refined one are open.
#pragma once

#include <algorithm>
#include <map>

#include "tests/core/support/refined_capture.h"

namespace glark::core::test {

struct Mesh {
  std::vector<std::array<GLfloat, 3>> positions;
  std::vector<std::array<std::size_t, 3>> triangles;
};

inline Mesh icosahedron() {
  const GLfloat t = 1.618034F;
  return {{{-1, t, 0},
           {1, t, 0},
           {-1, -t, 0},
           {1, -t, 0},
           {0, -1, t},
           {0, 1, t},
           {0, -1, -t},
           {0, 1, -t},
           {t, 0, -1},
           {t, 0, 1},
           {-t, 0, -1},
           {-t, 0, 1}},
          {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
           {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
           {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
}

inline Mesh tetrahedron() {
  return {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
}

using Edge = std::pair<PositionBits, PositionBits>;

// Counts the directed edges without the same edge in the other direction, each edge once. A triangle that has collapsed
// to an edge, with the same bits at two corners, does not belong to the surface.
inline int open_edges(const std::vector<RefinedVertex>& vertices) {
  std::map<Edge, int> count;
  for (std::size_t i = 0; i + 2 < vertices.size(); i += 3) {
    const std::array<PositionBits, 3> corners{bits_of(vertices[i]), bits_of(vertices[i + 1]), bits_of(vertices[i + 2])};
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    for (std::size_t k = 0; k < 3; ++k) ++count[{corners[k], corners[(k + 1) % 3]}];
  }
  return static_cast<int>(std::count_if(count.begin(), count.end(), [&](const auto& entry) {
    const auto back = count.find({entry.first.second, entry.first.first});
    return entry.second != 1 || back == count.end() || back->second != 1;
  }));
}

}  // namespace glark::core::test
