// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Checks that hold for every curved refinement.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "conformance/support/surface.h"

namespace glark::conformance {

inline std::vector<SurfaceVertex> draw_surface(Test& t, const Mesh& mesh) {
  gl.UseProgram(surface_program(t));
  upload(mesh);
  return capture_surface(t, mesh);
}

// Draws three triangles. In each of them, another edge has both ends at one place.
inline void check_equal_corners(Test& t, GLenum refinement, SurfaceOf surface) {
  refine_uniformly(3, refinement);
  for (const std::size_t from : {0U, 1U, 2U}) {
    Mesh mesh = bent_mesh();
    mesh.resize(3);
    mesh[(from + 1) % 3].position = mesh[from].position;
    expect_surface(t, draw_surface(t, mesh), mesh, {}, surface);
  }
}

// A triangle with all corners at one place.
inline void check_one_place(Test& t, GLenum refinement) {
  refine_uniformly(4, refinement);
  Mesh mesh = bent_mesh();
  mesh.resize(3);
  for (MeshVertex& vertex : mesh) vertex.position = {0.1F, -0.7F, 0.3F, 1};
  const auto vertices = draw_surface(t, mesh);
  t.require(vertices.size() == 768, "the triangle is refined");
  for (const SurfaceVertex& vertex : vertices)
    if (!t.expect(std::equal(vertex.position.begin(), vertex.position.begin() + 3, mesh[0].position.begin()),
                  "every refined vertex has the bits of P_0"))
      return;
}

// Positions along the edge that bent_mesh()'s two triangles share: corners 0 and 2 of the first, 2 and 0 of the second.
inline std::array<std::vector<Vec4>, 2> shared_edge(const std::vector<SurfaceVertex>& vertices, std::size_t segments) {
  std::array<std::vector<Vec4>, 2> sides = {std::vector<Vec4>(segments + 1), std::vector<Vec4>(segments + 1)};
  for (const SurfaceVertex& vertex : vertices) {
    if (vertex.weights[1] != 0) continue;
    const bool is_second = vertex.triangle >= 1;
    const float along = static_cast<float>(segments) * vertex.weights[is_second ? 2 : 0];
    sides[is_second ? 1 : 0][static_cast<std::size_t>(std::lround(along))] = vertex.position;
  }
  return sides;
}

// The third corners differ: only the ends of the shared edge matter.
inline void check_shared_edge(Test& t, GLenum refinement) {
  refine_uniformly(4, refinement);
  const auto sides = shared_edge(draw_surface(t, bent_mesh()), 16);
  for (std::size_t i = 0; i <= 16; ++i)
    t.expect(same_position(sides[0][i], sides[1][i]), "the edge has the same bits in both triangles");
}

// The vertex stage lacks a normal or a position. Without a position, `where` at location 8 holds the positions.
inline void check_missing_input(Test& t, GLenum refinement, bool has_position) {
  refine_uniformly(2, refinement);
  const Mesh mesh = bent_mesh();
  const std::string normal = has_position ? "" : "layout(location = 1) in vec3 normal;";
  const std::string position =
      has_position ? "layout(location = 0) in vec4 position;" : "layout(location = 8) in vec4 where;";
  gl.UseProgram(build_program(
      t, {.vertex = position + normal +
                    "layout(location = 2) in vec3 weights; layout(location = 6) in float triangle;\n"
                    "out vec4 colour; out vec3 weights_out; out float triangle_out;\n"
                    "void main() { weights_out = weights; triangle_out = triangle; colour = vec4(" +
                    (has_position ? "1.0); gl_Position = position; }\n" : "normal, 1.0); gl_Position = where; }\n"),
          .captured = {"gl_Position", "weights_out", "triangle_out"}}));
  upload(mesh);
  gl.VertexAttribPointer(8, 4, GL_FLOAT, GL_FALSE, sizeof(MeshVertex), nullptr);
  gl.EnableVertexAttribArray(8);
  for (const CapturedVertex& vertex : capture(t, [] { gl.DrawArrays(GL_TRIANGLES, 0, 6); })) {
    const std::size_t first = 3 * static_cast<std::size_t>(std::lround(vertex.triangle));
    for (std::size_t i = 0; i < 4; ++i)
      t.expect_near(vertex.position[i],
                    reference::refined(vertex.weights, mesh[first].position[i], mesh[first + 1].position[i],
                                       mesh[first + 2].position[i]),
                    t.is_gles() ? 3e-7 : 0, "the position is refined linearly");
  }
}

}  // namespace glark::conformance
