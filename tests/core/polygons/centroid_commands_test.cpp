// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// GL_POLYGON_CENTROID_ARK by every drawing command that can have several polygons. Each command gives the same
// triangles, bit by bit, as the polygons drawn one by one. centroid_edges_test.cpp checks those against the neighbours
// of their edges.
#include <algorithm>
#include <functional>
#include <numeric>

#include "tests/core/support/curved_program.h"
#include "tests/core/support/measured_program.h"
#include "tests/core/support/osmesa_context.h"

namespace glark::core::test {
namespace {

constexpr GLuint level = 4;
constexpr std::size_t most = 100000;

// The numbers of vertices of polygons that follow one another. Two vertices make no polygon.
const std::vector<GLsizei> sizes = {3, 5, 2, 4, 7, 6};

std::vector<GLint> firsts() {
  std::vector<GLint> result(sizes.size(), 0);
  std::partial_sum(sizes.begin(), sizes.end() - 1, result.begin() + 1);
  return result;
}

std::vector<CurvedVertex> make_mesh() {
  std::vector<CurvedVertex> mesh;
  for (std::size_t polygon = 0; polygon < sizes.size(); ++polygon) {
    for (GLsizei k = 0; k < sizes[polygon]; ++k) {
      const GLfloat angle = 6.2831853F * static_cast<GLfloat>(k) / static_cast<GLfloat>(sizes[polygon]);
      const GLfloat x = 0.3F * std::cos(angle) + 0.2F * static_cast<GLfloat>(polygon) - 0.5F;
      const GLfloat y = 0.4F * std::sin(angle);
      const auto tag = static_cast<GLubyte>((3 * static_cast<std::size_t>(k) + polygon) % (level + 1));
      mesh.push_back(
          {{x, y, 0.3F * x * y}, {0.3F * x, -0.4F * y, 0.9F}, {x, y, 1}, static_cast<GLfloat>(polygon), tag});
    }
  }
  return mesh;
}

using Triangles = std::vector<std::array<PositionBits, 3>>;

class CentroidCommands : public testing::Test {
 protected:
  CentroidCommands() {
    glARKinit(level);
    glARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);
    glARKParameteriARK(GL_POLYGON_SPLIT_ARK, GL_POLYGON_CENTROID_ARK);
    glEnable(GL_ARK);
    glUseProgram(link_curved_program(Language::glsl_120));
    upload(make_mesh());
  }
  static Triangles triangles_of(const std::function<void()>& draw) {
    const std::vector<RefinedVertex> vertices = capture_refined(most, draw);
    Triangles triangles;
    for (std::size_t i = 0; i + 2 < vertices.size(); i += 3) {
      triangles.push_back({bits_of(vertices[i]), bits_of(vertices[i + 1]), bits_of(vertices[i + 2])});
    }
    std::sort(triangles.begin(), triangles.end());
    return triangles;
  }
  static void draw_one_by_one(GLenum mode) {
    const std::vector<GLint> first = firsts();
    for (std::size_t i = 0; i < sizes.size(); ++i) glDrawArrays(mode, first[i], sizes[i]);
  }
  // With tags and with a uniform depth.
  static void expect_the_same(const std::function<void()>& draw, const std::function<void()>& one_by_one) {
    for (const GLenum source : {GL_DEPTH_TAG_ARK, GL_UNIFORM_DEPTH_ARK}) {
      glARKParameteriARK(GL_DEPTH_SOURCE_ARK, static_cast<GLint>(source));
      glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 2);
      const Triangles expected = triangles_of(one_by_one);
      EXPECT_GT(expected.size(), 25U * 4);
      const Triangles found = triangles_of(draw);
      EXPECT_EQ(found.size(), expected.size());
      EXPECT_TRUE(found == expected) << "depth source " << source;
    }
    EXPECT_EQ(pending_errors(), "");
  }
  OsmesaContext context_{Profile::compatibility};
};

TEST_F(CentroidCommands, MultiDrawArrays) {
  const std::vector<GLint> first = firsts();
  for (const GLenum mode : {GL_POLYGON, GL_QUADS, GL_QUAD_STRIP}) {
    SCOPED_TRACE(mode);
    glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_DEPTH_TAG_ARK);
    const auto count = static_cast<GLsizei>(sizes.size());
    EXPECT_EQ(triangles_of([&] { glMultiDrawArrays(mode, first.data(), sizes.data(), count); }),
              triangles_of([&] { draw_one_by_one(mode); }));
  }
  expect_the_same(
      [&] { glMultiDrawArrays(GL_POLYGON, first.data(), sizes.data(), static_cast<GLsizei>(sizes.size())); },
      [] { draw_one_by_one(GL_POLYGON); });
}

TEST_F(CentroidCommands, MultiDrawElements) {
  std::vector<GLushort> indices(make_mesh().size());
  std::iota(indices.begin(), indices.end(), GLushort{0});
  make_buffer(GL_ELEMENT_ARRAY_BUFFER, indices);
  std::vector<const void*> offsets;
  for (const GLint first : firsts()) offsets.push_back(byte_offset(2 * static_cast<std::size_t>(first)));
  const auto count = static_cast<GLsizei>(sizes.size());
  expect_the_same([&] { glMultiDrawElements(GL_POLYGON, sizes.data(), GL_UNSIGNED_SHORT, offsets.data(), count); },
                  [] { draw_one_by_one(GL_POLYGON); });
  const std::vector<const void*> zeros(sizes.size(), nullptr);
  const std::vector<GLint> bases = firsts();
  expect_the_same(
      [&] {
        glMultiDrawElementsBaseVertex(GL_POLYGON, sizes.data(), GL_UNSIGNED_SHORT, zeros.data(), count, bases.data());
      },
      [] { draw_one_by_one(GL_POLYGON); });
}

TEST_F(CentroidCommands, IndirectDraws) {
  std::vector<GLushort> indices(make_mesh().size());
  std::iota(indices.begin(), indices.end(), GLushort{0});
  make_buffer(GL_ELEMENT_ARRAY_BUFFER, indices);
  std::vector<GLuint> commands;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const auto first = static_cast<GLuint>(firsts()[i]);
    commands.insert(commands.end(), {static_cast<GLuint>(sizes[i]), 1, first, 0, 0});
  }
  make_buffer(GL_DRAW_INDIRECT_BUFFER, commands);
  const auto count = static_cast<GLsizei>(sizes.size());
  expect_the_same([&] { glMultiDrawArraysIndirect(GL_POLYGON, nullptr, count, 20); },
                  [] { draw_one_by_one(GL_POLYGON); });
  expect_the_same([&] { glMultiDrawElementsIndirect(GL_POLYGON, GL_UNSIGNED_SHORT, nullptr, count, 0); },
                  [] { draw_one_by_one(GL_POLYGON); });
}

// A buffer on the GPU says that fewer polygons are drawn than the command allows.
TEST_F(CentroidCommands, IndirectDrawsWithACountOfTheGpu) {
  const auto draw = proc<PFNGLMULTIDRAWARRAYSINDIRECTCOUNTARBPROC>("glMultiDrawArraysIndirectCountARB");
  std::vector<GLuint> commands;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    commands.insert(commands.end(), {static_cast<GLuint>(sizes[i]), 1, static_cast<GLuint>(firsts()[i]), 0});
  }
  make_buffer(GL_DRAW_INDIRECT_BUFFER, commands);
  make_buffer(GL_PARAMETER_BUFFER_ARB, std::vector<GLuint>{2});
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 2);
  GLuint query = 0;
  GLuint generated = 0;
  glGenQueries(1, &query);
  glBeginQuery(GL_PRIMITIVES_GENERATED, query);
  draw(GL_POLYGON, nullptr, 0, static_cast<GLsizei>(sizes.size()), 0);
  glEndQuery(GL_PRIMITIVES_GENERATED);
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &generated);
  EXPECT_EQ(generated, (3U + 5U) * 16U);
}

TEST_F(CentroidCommands, InstancesWithADivisor) {
  make_buffer(GL_ARRAY_BUFFER, std::vector<GLfloat>{1, 2, 3});
  glVertexAttribPointer(3, 1, GL_FLOAT, GL_FALSE, 0, nullptr);
  glVertexAttribDivisor(3, 1);
  const GLint first = firsts()[4];
  expect_the_same([=] { glDrawArraysInstanced(GL_POLYGON, first, 7, 3); },
                  [=] {
                    for (GLuint i = 0; i < 3; ++i) glDrawArraysInstancedBaseInstance(GL_POLYGON, first, 7, 1, i);
                  });
  for (const RefinedVertex& vertex : capture_refined(most, [=] { glDrawArraysInstanced(GL_POLYGON, first, 7, 3); })) {
    EXPECT_NEAR(vertex.triangle, std::round(vertex.triangle), 1e-5F);
    EXPECT_GE(vertex.triangle, 0.9F);
  }
}

TEST_F(CentroidCommands, MultiDrawsOfAList) {
  const std::vector<GLint> first = firsts();
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  glMultiDrawArrays(GL_POLYGON, first.data(), sizes.data(), 2);
  glMultiDrawArrays(GL_POLYGON, &first[3], &sizes[3], static_cast<GLsizei>(sizes.size()) - 3);
  glEndList();
  for (int i = 0; i < 3; ++i) {
    expect_the_same([=] { glCallList(list); }, [] { draw_one_by_one(GL_POLYGON); });
  }
}

// Edges from a corner to the centroid have fractional depths, too.
TEST_F(CentroidCommands, Geomorphing) {
  glARKParameteriARK(GL_GEOMORPH_ARK, GL_TRUE);
  const std::vector<GLint> first = firsts();
  expect_the_same(
      [&] { glMultiDrawArrays(GL_POLYGON, first.data(), sizes.data(), static_cast<GLsizei>(sizes.size())); },
      [] { draw_one_by_one(GL_POLYGON); });
}

// A quad in the plane of the screen, 32 by 32 of 64 pixels. At 8 pixels a segment, edges of 32 pixels get 4 segments.
// The edges to the centre (22.6 pixels) get 4 as well.
TEST(CentroidMeasured, EdgesToTheCentreAreMeasured) {
  const OsmesaContext context(Profile::compatibility);
  glViewport(0, 0, 64, 64);
  measure_depths(level, 8);
  glARKParameteriARK(GL_POLYGON_SPLIT_ARK, GL_POLYGON_CENTROID_ARK);
  glUseProgram(link_program(
      {.vertex = "#version 120\nvoid main() { gl_Position = gl_Vertex; }\n", .varyings = {"gl_Position"}}));
  GLuint query = 0;
  GLuint generated = 0;
  glGenQueries(1, &query);
  glBeginQuery(GL_PRIMITIVES_GENERATED, query);
  glBegin(GL_QUADS);
  glVertex2f(-0.5F, -0.5F);
  glVertex2f(0.5F, -0.5F);
  glVertex2f(0.5F, 0.5F);
  glVertex2f(-0.5F, 0.5F);
  glEnd();
  glEndQuery(GL_PRIMITIVES_GENERATED);
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &generated);
  EXPECT_EQ(generated, 4U * 16U);
}

}  // namespace
}  // namespace glark::core::test
