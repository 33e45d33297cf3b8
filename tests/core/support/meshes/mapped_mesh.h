// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Split meshes with texture coordinates, displaced by a rough height map while GL_WELD_ARK is on.
#pragma once

#include "tests/core/support/meshes/welded_edges.h"
#include "tests/core/support/osmesa_context.h"

namespace glark::core::test {

inline constexpr unsigned deepest = 7;
inline constexpr GLuint coordinate_attribute = 4;
inline constexpr GLenum refinements[] = {GL_LINEAR_INPUTS_ARK, GL_CURVED_PN_ARK, GL_SCALAR_TAGGED_PN_ARK, GL_PHONG_ARK};

using Coordinate = std::array<GLfloat, 2>;

struct MappedMesh {
  SplitMesh mesh;
  std::vector<Coordinate> coordinates;
};

// Every edge is a seam.
inline MappedMesh mapped_at_random(const SplitMesh& mesh, unsigned seed) {
  std::mt19937 random(seed);
  const auto number = [&] { return static_cast<GLfloat>(random() % 4001) / 2000 - 1; };
  MappedMesh result{mesh, {}};
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) result.coordinates.push_back({number(), number()});
  return result;
}

// Each side of the cube has the whole texture, as in modelling programs.
inline MappedMesh mapped_cube() {
  MappedMesh result{flat_shaded(cube()), {}};
  for (const CurvedVertex& vertex : result.mesh.vertices) {
    const Vector& p = vertex.position;
    const std::size_t axis = vertex.normal[0] != 0 ? 0 : vertex.normal[1] != 0 ? 1 : 2;
    result.coordinates.push_back({0.5F + 0.5F * p[(axis + 1) % 3], 0.5F + 0.5F * p[(axis + 2) % 3]});
  }
  return result;
}

// A sphere by longitude and latitude, which has a seam and two poles. Normals are smooth.
inline MappedMesh globe() {
  const int sides = 8;
  const int rings = 5;
  const auto at = [&](int s, int r) {
    const double a = 2 * M_PI * (s % sides) / sides;
    const double b = M_PI * r / rings;
    const double radius = r % rings == 0 ? 0 : std::sin(b);
    return Vector{static_cast<GLfloat>(radius * std::cos(a)), static_cast<GLfloat>(radius * std::sin(a)),
                  static_cast<GLfloat>(std::cos(b))};
  };
  MappedMesh result;
  const auto add = [&](const std::array<std::array<int, 2>, 3>& places) {
    std::array<Vector, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = at(places[k][0], places[k][1]);
      result.coordinates.push_back(
          {static_cast<GLfloat>(places[k][0]) / sides + 0.03F, static_cast<GLfloat>(places[k][1]) / rings});
    }
    result.mesh.add(corners, corners);
  };
  for (int r = 0; r < rings; ++r) {
    for (int s = 0; s < sides; ++s) {
      if (r + 1 < rings) add({{{s, r}, {s, r + 1}, {s + 1, r + 1}}});
      if (r > 0) add({{{s, r}, {s + 1, r + 1}, {s + 1, r}}});
    }
  }
  return result;
}

inline void bind_rough_heights() {
  constexpr int size = 32;
  std::mt19937 random(5);
  std::vector<GLfloat> heights;
  for (int i = 0; i < size * size; ++i) heights.push_back(static_cast<GLfloat>(random() % 1001) / 1000);
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, size, size, 0, GL_RED, GL_FLOAT, heights.data());
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
    glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
  }
}

class DisplacedEdges : public testing::Test {
 protected:
  DisplacedEdges() {
    glARKinit(deepest);
    glARKParameteriARK(GL_WELD_ARK, GL_TRUE);
    glARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, 0);
    glARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, 0.3F);
    glEnable(GL_ARK);
    GLuint array = 0;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    bind_rough_heights();
    capture_program_ = link_program(
        {.vertex = "#version 450 core\nin vec3 position; in vec3 normal; in vec3 weights; in float triangle;\n"
                   "in vec2 texcoord; out vec3 passed_weights; out float passed_triangle; out vec3 color;\n"
                   "void main() { gl_Position = vec4(position, 1.0); color = vec3(normal.xy, texcoord.x);\n"
                   "  passed_weights = weights; passed_triangle = triangle; }\n",
         .fragment = "#version 450 core\nin vec3 color; out vec4 result;\n"
                     "void main() { result = vec4(color, 1.0); }\n",
         .varyings = {"gl_Position", "passed_weights", "passed_triangle"},
         .attributes = {"position", "normal", "weights", "triangle", "texcoord"}});
  }
  static void set_refinement(GLenum refinement) {
    glARKParameteriARK(GL_REFINEMENT_ARK, static_cast<GLint>(refinement));
  }
  static void upload(const MappedMesh& mapped) {
    test::upload(mapped.mesh.vertices);
    make_buffer(GL_ARRAY_BUFFER, mapped.coordinates);
    glVertexAttribPointer(coordinate_attribute, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
    glEnableVertexAttribArray(coordinate_attribute);
  }
  std::vector<RefinedVertex> refine(const MappedMesh& mapped, unsigned level) const {
    glUseProgram(capture_program_);
    upload(mapped);
    const auto count = static_cast<GLsizei>(mapped.coordinates.size());
    return capture_refined((mapped.mesh.triangles() << (2 * level)) + 1,
                           [count] { glDrawArrays(GL_TRIANGLES, 0, count); });
  }
  int parted_edges(const MappedMesh& mapped, unsigned level) const {
    return test::parted_edges(mapped.mesh, refine(mapped, level));
  }
  void expect_welded(const MappedMesh& mapped) const {
    for (unsigned level = 1; level <= deepest; level += 2) {
      MappedMesh tagged = mapped;
      tagged.mesh = mapped.mesh.tagged_at_random(level, level);
      for (const GLenum refinement : refinements) {
        set_refinement(refinement);
        EXPECT_EQ(parted_edges(tagged, level), 0) << "refinement " << refinement << ", level " << level;
      }
    }
    EXPECT_EQ(pending_errors(), "");
  }
  OsmesaContext context_{Profile::core};
  GLuint capture_program_ = 0;
};

}  // namespace glark::core::test
