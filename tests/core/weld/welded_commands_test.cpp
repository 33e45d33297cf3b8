// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// GL_WELD_ARK in every way to draw: fixed function, arrays, elements, strips, fans, restart, lists, glBegin, quads,
// instances. A closed mesh with seams has no hole with welding, and must have some without. Holes are counted as in
// welded_pictures_test.cpp. Only emitted light is visible: it gives the counters, and lighting makes the fixed function
// read the normal.
#include <functional>
#include <numeric>

#include "tests/core/support/meshes/views.h"

namespace glark::core::test {
namespace {

constexpr GLuint restart_index = 0xFFFFFFFF;

struct SceneVertex {
  Vector normal;
  Vector position;
};

std::vector<SceneVertex> scene_vertices(const SplitMesh& mesh) {
  std::vector<SceneVertex> result;
  for (const CurvedVertex& vertex : mesh.vertices) result.push_back({vertex.normal, vertex.position});
  return result;
}

class WeldedCommands : public testing::Test {
 protected:
  WeldedCommands() : vertices_(scene_vertices(gear(3, 0, true))), indices_(vertices_.size()) {
    std::iota(indices_.begin(), indices_.end(), 0U);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);  // of no effect on the picture, but it reads the normal
    glEnable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glClearColor(0, 0, 0, 0);
    glPrimitiveRestartIndex(restart_index);
    refine_uniformly(3, GL_CURVED_PN_ARK);
    make_arrays(vertices_);
  }
  void make_arrays(const std::vector<SceneVertex>& vertices) {
    make_buffer(GL_ARRAY_BUFFER, vertices);
    glInterleavedArrays(GL_N3F_V3F, 0, nullptr);
  }
  void make_indices(const std::vector<GLuint>& indices) { make_buffer(GL_ELEMENT_ARRAY_BUFFER, indices); }

  static void emit(GLfloat front, GLfloat back) {
    const std::array<GLfloat, 4> nothing{0, 0, 0, 0};
    const std::array<GLfloat, 4> light{front / 255, back / 255, 0, 0};
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, nothing.data());
    glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, light.data());
  }
  static int holes(const std::function<void()>& draw) {
    int result = 0;
    for (const Vector& direction : {Vector{0.3F, 0.2F, 1}, Vector{1, 0.4F, 0.6F}, Vector{-0.2F, 1, -0.4F}}) {
      glLoadMatrixf(view_along(direction).data());
      glClear(GL_COLOR_BUFFER_BIT);
      glCullFace(GL_BACK);
      emit(1, 0);
      draw();
      glCullFace(GL_FRONT);
      emit(0, 1);
      draw();
      result += open_pixels(read_picture());
    }
    return result;
  }
  static void expect_closed(const std::function<void()>& draw) {
    EXPECT_GT(holes(draw), 30) << "the scene has no seams";
    glARKParameteriARK(GL_WELD_ARK, GL_TRUE);
    EXPECT_EQ(holes(draw), 0);
    EXPECT_EQ(pending_errors(), "");
  }
  GLsizei count() const { return static_cast<GLsizei>(vertices_.size()); }

  OsmesaContext context_{Profile::compatibility};
  std::vector<SceneVertex> vertices_;
  std::vector<GLuint> indices_;
};

TEST_F(WeldedCommands, Arrays) {
  expect_closed([this] { glDrawArrays(GL_TRIANGLES, 0, count()); });
}

TEST_F(WeldedCommands, ArraysThatChange) {
  expect_closed([this] {
    glBufferSubData(GL_ARRAY_BUFFER, 0, sizeof(SceneVertex), vertices_.data());
    glDrawArrays(GL_TRIANGLES, 0, count());
  });
}

TEST_F(WeldedCommands, ClientArrays) {
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glInterleavedArrays(GL_N3F_V3F, 0, vertices_.data());
  expect_closed([this] { glDrawArrays(GL_TRIANGLES, 0, count()); });
}

TEST_F(WeldedCommands, Elements) {
  std::reverse(indices_.begin(), indices_.end());
  for (std::size_t i = 0; i < indices_.size(); i += 3) std::swap(indices_[i], indices_[i + 1]);
  make_indices(indices_);
  expect_closed([this] { glDrawElements(GL_TRIANGLES, count(), GL_UNSIGNED_INT, nullptr); });
}

TEST_F(WeldedCommands, StripsAndFansWithRestart) {
  std::vector<GLuint> restarted;
  for (std::size_t i = 0; i < indices_.size(); ++i) {
    restarted.push_back(indices_[i]);
    if (i % 3 == 2) restarted.push_back(restart_index);
  }
  make_indices(restarted);
  glEnable(GL_PRIMITIVE_RESTART);
  for (const GLenum mode : {GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN}) {
    glARKParameteriARK(GL_WELD_ARK, GL_FALSE);
    expect_closed([&] { glDrawElements(mode, static_cast<GLsizei>(restarted.size()), GL_UNSIGNED_INT, nullptr); });
  }
}

TEST_F(WeldedCommands, StripStitchedByDegenerateTriangles) {
  std::vector<GLuint> strip;
  for (std::size_t i = 0; i < indices_.size(); i += 3) {
    if (i > 0) strip.insert(strip.end(), {indices_[i - 1], indices_[i], indices_[i]});
    strip.insert(strip.end(), {indices_[i], indices_[i + 1], indices_[i + 2]});
  }
  make_indices(strip);
  expect_closed(
      [&] { glDrawElements(GL_TRIANGLE_STRIP, static_cast<GLsizei>(strip.size()), GL_UNSIGNED_INT, nullptr); });
}

TEST_F(WeldedCommands, BeginAndEnd) {
  expect_closed([this] {
    glBegin(GL_TRIANGLES);
    for (const SceneVertex& vertex : vertices_) {
      glNormal3fv(vertex.normal.data());
      glVertex3fv(vertex.position.data());
    }
    glEnd();
  });
}

TEST_F(WeldedCommands, DisplayList) {
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  glBegin(GL_TRIANGLES);
  for (const SceneVertex& vertex : vertices_) {
    glNormal3fv(vertex.normal.data());
    glVertex3fv(vertex.position.data());
  }
  glEnd();
  glEndList();
  expect_closed([list] { glCallList(list); });
}

TEST_F(WeldedCommands, Quads) {
  const Mesh mesh = cube();
  const SplitMesh seams = seams_everywhere(mesh, 0.5F, 21);
  std::vector<SceneVertex> quads;
  for (std::size_t t = 0; t + 1 < mesh.triangles.size(); t += 2) {
    const std::vector<SceneVertex> all = scene_vertices(seams);
    quads.insert(quads.end(), {all[3 * t], all[3 * t + 1], all[3 * t + 2], all[3 * t + 5]});
  }
  make_arrays(quads);
  for (const GLenum split : {GL_POLYGON_TRIANGLES_ARK, GL_POLYGON_CENTROID_ARK}) {
    glARKParameteriARK(GL_POLYGON_SPLIT_ARK, static_cast<GLint>(split));
    glARKParameteriARK(GL_WELD_ARK, GL_FALSE);
    expect_closed([&] { glDrawArrays(GL_QUADS, 0, static_cast<GLsizei>(quads.size())); });
  }
}

// With the greatest number of attributes, the records are read from a storage block.
TEST_F(WeldedCommands, LongRecords) {
  for (GLenum unit = 0; unit < 4; ++unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glEnable(GL_TEXTURE_2D);
    glMultiTexCoord4f(GL_TEXTURE0 + unit, 0, 0, 0, 1);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_ADD);
    const std::array<GLubyte, 4> black{};
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, black.data());
  }
  expect_closed([this] { glDrawArrays(GL_TRIANGLES, 0, count()); });
}

struct MappedVertex {
  std::array<GLfloat, 2> coordinate;
  SceneVertex vertex;
};

// Every edge is also a seam of the texture.
TEST_F(WeldedCommands, Displacement) {
  std::mt19937 random(17);
  const auto number = [&] { return static_cast<GLfloat>(random() % 1001) / 1000; };
  std::vector<MappedVertex> mapped;
  for (const SceneVertex& vertex : vertices_) mapped.push_back({{number(), number()}, vertex});
  make_buffer(GL_ARRAY_BUFFER, mapped);
  glInterleavedArrays(GL_T2F_N3F_V3F, 0, nullptr);
  std::vector<GLfloat> heights;
  for (int i = 0; i < 64; ++i) heights.push_back(number());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, 8, 8, 0, GL_RED, GL_FLOAT, heights.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, 0);
  glARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, 0.3F);
  for (const GLenum refinement : {GL_LINEAR_INPUTS_ARK, GL_CURVED_PN_ARK, GL_SCALAR_TAGGED_PN_ARK}) {
    glARKParameteriARK(GL_REFINEMENT_ARK, static_cast<GLint>(refinement));
    glARKParameteriARK(GL_WELD_ARK, GL_FALSE);
    expect_closed([this] { glDrawArrays(GL_TRIANGLES, 0, count()); });
  }
  glARKParameteriARK(GL_POLYGON_SPLIT_ARK, GL_POLYGON_CENTROID_ARK);
  glARKParameteriARK(GL_WELD_ARK, GL_FALSE);
  expect_closed([] {
    const Mesh mesh = cube();
    glBegin(GL_QUADS);
    for (std::size_t t = 0; t + 1 < mesh.triangles.size(); t += 2) {
      const auto& [a, b, c] = mesh.triangles[t];
      const std::array<std::size_t, 4> corners = {a, b, c, mesh.triangles[t + 1][2]};
      glNormal3fv(face_normal(mesh, mesh.triangles[t]).data());
      for (std::size_t k = 0; k < 4; ++k) {
        glTexCoord2f(k == 1 || k == 2 ? 0.9F : 0.1F, k > 1 ? 0.8F : 0.2F);
        glVertex3fv(mesh.positions[corners[k]].data());
      }
    }
    glEnd();
  });
}

// One draw has the same mesh three times, each with its own normals. The normals of one instance do not bend another
// one.
TEST_F(WeldedCommands, InstancesAreNotWelded) {
  glUseProgram(link_program(
      {.vertex = "#version 120\nattribute vec3 turn;\nvarying vec3 n;\n"
                 "void main() { n = gl_Normal + turn; gl_Position = ftransform(); }\n",
       .fragment = "#version 120\nvarying vec3 n;\nvoid main() { gl_FragColor = vec4(gl_FrontFacing ? vec2(1.0, 0.0) : "
                   "vec2(0.0, 1.0), n.x > 9.0 ? 1.0 : 0.0, 0.0) / 255.0; }\n",
       .attributes = {"unused", "turn"}}));
  const GLint turn = 1;
  make_buffer(GL_ARRAY_BUFFER, std::vector<Vector>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  glVertexAttribPointer(turn, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  glEnableVertexAttribArray(turn);
  glVertexAttribDivisor(turn, 1);
  expect_closed([this] { glDrawArraysInstanced(GL_TRIANGLES, 0, count(), 3); });
}

}  // namespace
}  // namespace glark::core::test
