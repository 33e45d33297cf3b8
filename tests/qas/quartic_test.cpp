// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Tests the quartic through 15 points of a triangle on the CPU, and as a refinement shader under OSMesa, bit by bit
// along shared edges.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/core/support/meshes/closed_mesh.h"
#include "tests/core/support/osmesa_context.h"
#include "tests/qas/meshes.h"

namespace glark::qas::test {
namespace {

using core::test::RefinedVertex;
constexpr GLuint level = 4;

Surface surface_of(const ControlMesh& mesh, unsigned splits = 1) {
  Surface surface(mesh.view(), {.splits = splits});
  surface.update(mesh.positions);
  return surface;
}

// It passes through the 15 points of the limit surface.
TEST(Quartic, InterpolatesTheLimitSurface) {
  const ControlMesh mesh = shaken(blocks(), 0.02);
  const Surface surface = surface_of(mesh);
  LoopSurface exact(mesh.view());
  exact.update(mesh.positions);
  for (std::size_t t = 0; t < mesh.triangles.size() / 3; t += 7) {
    for (int i = 0; i <= 4; ++i) {
      for (int j = 0; i + j <= 4; ++j) {
        const std::array<float, 3> at = {0.25F * static_cast<float>(4 - i - j), 0.25F * static_cast<float>(i),
                                         0.25F * static_cast<float>(j)};
        const Sample sample = surface.evaluate_quartic(t, at), limit = exact.evaluate(t, at);
        for (std::size_t k = 0; k < 3; ++k) {
          ASSERT_NEAR(sample.position[k], limit.position[k], 2e-5) << "triangle " << t << " at " << i << ' ' << j;
          ASSERT_NEAR(sample.normal[k], limit.normal[k], 2e-4) << "triangle " << t << " at " << i << ' ' << j;
        }
      }
    }
  }
}

// Loop's surface is a quartic box spline where every valence is 6.
TEST(Quartic, IsExactWhereTheMeshIsRegular) {
  const ControlMesh mesh = seven_meshes().front();
  const Surface surface = surface_of(mesh);
  LoopSurface exact(mesh.view());
  exact.update(mesh.positions);
  for (std::size_t t = 0; t < mesh.triangles.size() / 3; t += 5) {
    const std::array<float, 3> at = {0.1F, 0.65F, 0.25F};
    const Sample sample = surface.evaluate_quartic(t, at), limit = exact.evaluate(t, at);
    for (std::size_t k = 0; k < 3; ++k) ASSERT_NEAR(sample.position[k], limit.position[k], 2e-6 * mesh.diagonal());
  }
}

TEST(Quartic, NeedsASplitAndWritesNothingElse) {
  const ControlMesh mesh = icosahedron();
  const Surface without = surface_of(mesh, 0), with = surface_of(mesh);
  EXPECT_EQ(without.quartic_corner_count(), 0U);
  EXPECT_THROW(static_cast<void>(without.evaluate_quartic(0, {1, 0, 0})), Error);
  EXPECT_THROW(static_cast<void>(with.evaluate_quartic(20, {1, 0, 0})), Error);
  EXPECT_THROW(static_cast<void>(with.evaluate_quartic(0, {1, 1, 0})), Error);
  std::vector<QuarticCorner> corners(61);
  corners[0].points[0][0] = 7;
  EXPECT_THROW(with.write_quartic_corners(corners), Error);
  EXPECT_EQ(corners[0].points[0][0], 7);
}

struct Vertex {
  QuarticCorner corner;
  std::array<GLfloat, 3> weights;
  GLfloat triangle;
  GLubyte tag;
};

void upload(const ControlMesh& mesh, const Surface& surface, const std::vector<GLubyte>& tags, float torn) {
  std::vector<QuarticCorner> corners(surface.quartic_corner_count());
  surface.write_quartic_corners(corners);
  std::vector<Vertex> vertices;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t triangle = i / 3;
    vertices.push_back({corners[i], {}, static_cast<GLfloat>(triangle), tags[mesh.triangles[i]]});
    vertices.back().weights[i % 3] = 1;
  }
  vertices.front().corner.points[1][0] += torn;
  core::test::make_buffer(GL_ARRAY_BUFFER, vertices);
  for (GLuint i = 0; i < 10; ++i) {
    const std::size_t offset = i < 8    ? 16 * std::size_t{i}
                               : i == 8 ? offsetof(Vertex, weights)
                                        : offsetof(Vertex, triangle);
    glVertexAttribPointer(i,
                          i < 8    ? 4
                          : i == 8 ? 3
                                   : 1,
                          GL_FLOAT, GL_FALSE, sizeof(Vertex), core::test::byte_offset(offset));
    glEnableVertexAttribArray(i);
  }
  glDepthTagPointerARK(GL_UNSIGNED_BYTE, sizeof(Vertex), core::test::byte_offset(offsetof(Vertex, tag)));
  glEnable(GL_DEPTH_TAG_ARRAY_ARK);
}

std::vector<RefinedVertex> refined(const ControlMesh& mesh, const Surface& surface, const std::string& result,
                                   unsigned seed, float torn = 0) {
  std::mt19937 random(seed);
  std::vector<GLubyte> tags(mesh.vertex_count());
  for (GLubyte& tag : tags) tag = static_cast<GLubyte>(random() % (level + 1));
  GLuint array = 0;
  glGenVertexArrays(1, &array);
  glBindVertexArray(array);
  glARKinit(level);
  upload(mesh, surface, tags, torn);
  const GLuint program = core::test::link_program(
      {.vertex = "#version 450 core\nlayout(location = 0) in mat4 points; layout(location = 4) in mat4 normals;\n"
                 "layout(location = 8) in vec3 weights; layout(location = 9) in float number;\n"
                 "out vec3 passed_weights; out float passed_number;\n"
                 "void main() { gl_Position = " +
                 result + "; passed_weights = weights; passed_number = number; }\n",
       .varyings = {"gl_Position", "passed_weights", "passed_number"},
       .attributes = {}});
  const std::string source =
      quartic_refinement_shader("points", result.find("normals") == std::string::npos ? "" : "normals");
  const char* const text = source.c_str();
  glUseProgram(program);
  glRefinementShaderSourceARK(program, 1, &text, nullptr);
  glEnable(GL_ARK);
  auto vertices = core::test::capture_refined(((mesh.triangles.size() / 3) << (2 * level)) + 1, [&] {
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(mesh.triangles.size()));
  });
  EXPECT_EQ(core::test::pending_errors(), "");
  return vertices;
}

class QuarticShader : public testing::Test {
 protected:
  core::test::OsmesaContext context_{core::test::Profile::core};
};

TEST_F(QuarticShader, GivesWhatTheCpuEvaluates) {
  const ControlMesh mesh = shaken(sheet(4), 0.02);
  const Surface surface = surface_of(mesh);
  const auto positions = refined(mesh, surface, "vec4(points[0].xyz, normals[0].x)", 1);
  const auto normals = refined(mesh, surface, "vec4(normals[0].xyz, points[0].x)", 1);
  ASSERT_EQ(positions.size(), normals.size());
  ASSERT_GT(positions.size(), mesh.triangles.size());
  double farthest = 0;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Sample sample =
        surface.evaluate_quartic(static_cast<std::size_t>(positions[i].triangle), positions[i].weights);
    for (std::size_t k = 0; k < 3; ++k) {
      farthest = std::max<double>(farthest, std::fabs(sample.position[k] - positions[i].position[k]));
      farthest = std::max<double>(farthest, std::fabs(sample.normal[k] - normals[i].position[k]));
    }
  }
  EXPECT_LE(farthest, 2e-6);
}

TEST_F(QuarticShader, LeavesNoEdgeOpenUnderRandomTags) {
  for (const ControlMesh& mesh : {shaken(icosahedron(), 0.05), blocks(), drum(7)}) {
    const Surface surface = surface_of(mesh);
    for (const unsigned seed : {1U, 2U, 3U}) {
      const auto vertices = refined(mesh, surface, "vec4(points[0].xyz, 1.0)", seed);
      EXPECT_GT(vertices.size(), mesh.triangles.size());
      EXPECT_EQ(core::test::open_edges(vertices), 0) << mesh.name << " seed " << seed;
    }
  }
}

// The control is an edge with different points on its two sides.
TEST_F(QuarticShader, ADifferentPointOpensTheEdge) {
  const ControlMesh mesh = icosahedron();
  EXPECT_GT(core::test::open_edges(refined(mesh, surface_of(mesh), "vec4(points[0].xyz, 1.0)", 5, 1e-4F)), 0);
}

}  // namespace
}  // namespace glark::qas::test
