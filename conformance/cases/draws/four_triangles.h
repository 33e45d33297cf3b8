// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A mesh of four triangles. Places and colours show which of them were drawn.
#pragma once

#include "conformance/support/refined_draw.h"

namespace glark::conformance {

inline constexpr GLsizei all_vertices = 12;

// Four triangles at four places. The second pair repeats nothing of the first.
inline Mesh four_triangles() {
  Mesh mesh;
  for (int i = 0; i < 4; ++i)
    for (MeshVertex vertex : one_triangle()) {
      const auto n = static_cast<float>(i);
      vertex.position = {0.4F * vertex.position[0] + (i % 2 == 0 ? -0.5F : 0.45F),
                         0.4F * vertex.position[1] + (i < 2 ? -0.5F : 0.5F) + 0.02F * n, 0, 1};
      vertex.colour[2] += 0.2F * n;
      mesh.push_back(vertex);
    }
  number_triangles(mesh);
  return mesh;
}

inline void set_up_four_triangles(Test& t) {
  gl.UseProgram(colour_program(t));
  upload(four_triangles(), false);
}

}  // namespace glark::conformance
