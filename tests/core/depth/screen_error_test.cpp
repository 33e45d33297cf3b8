// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Depths by the distance between a curved edge and its chord on the screen, read back through transform feedback.
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "tests/core/support/measured_program.h"
#include "tests/core/support/meshes/closed_mesh.h"
#include "tests/core/support/osmesa_context.h"

namespace glark::core::test {
namespace {

constexpr GLuint level = 6;

CurvedVertex corner(std::array<GLfloat, 3> position, std::array<GLfloat, 3> normal = {0, 0, 1}) {
  return {position, normal, {}, 0, 0};
}

class ScreenError : public testing::Test {
 protected:
  ScreenError() {
    glViewport(0, 0, picture_size, picture_size);
    GLuint array = 0;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    program_ = link_measured_program();
    glUseProgram(program_);
    set_view(program_, flat_view);
    measure_depths(level, 0);
    glARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);
  }
  static std::vector<RefinedVertex> refine(std::vector<CurvedVertex> mesh) {
    for (std::size_t i = 0; i < mesh.size(); ++i) {
      const std::size_t triangle = i / 3;
      mesh[i].triangle = static_cast<GLfloat>(triangle);
      mesh[i].weights = {};
      mesh[i].weights[i % 3] = 1;
    }
    upload(mesh);
    return capture_refined(400000, [&] { glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(mesh.size())); });
  }
  // The segments of edge 0 of the first triangle.
  static int segments(const std::vector<CurvedVertex>& triangle) {
    const std::vector<RefinedVertex> vertices = refine(triangle);
    int count = 0;
    for (std::size_t i = 0; i < vertices.size(); i += 3) {
      int on_edge = 0;
      for (std::size_t k = 0; k < 3; ++k) on_edge += vertices[i + k].weights[2] == 0 ? 1 : 0;
      count += on_edge == 2 && vertices[i].triangle == 0 ? 1 : 0;
    }
    return count;
  }
  // Edge 0 is 32 pixels long, and its normals turn by the two angles in the plane of the screen.
  static std::vector<CurvedVertex> bent(GLfloat begin, GLfloat end, GLfloat size = 0.5F) {
    return {corner({0, 0, 0}, {std::sin(begin), std::cos(begin), 0}),
            corner({size, 0, 0}, {std::sin(end), std::cos(end), 0}), corner({0, 0, 0.5F})};
  }
  static std::vector<CurvedVertex> vertices_of(const Mesh& mesh, int copies = 1) {
    std::vector<CurvedVertex> vertices;
    for (int copy = 0; copy < copies; ++copy)
      for (const auto& triangle : mesh.triangles)
        for (const std::size_t vertex : triangle)
          vertices.push_back(corner(mesh.positions[vertex], mesh.positions[vertex]));
    return vertices;
  }
  OsmesaContext context_{Profile::core};
  GLuint program_ = 0;
};

// The curve leaves its chord by size / 4 sin cos of the angle, in pixels. It also slides along its segments a little.
TEST_F(ScreenError, DistanceFromTheChordGivesTheDepth) {
  const std::vector<CurvedVertex> arc = bent(-0.25F, 0.25F);  // 1.92 pixels
  const std::pair<GLfloat, int> expected[] = {{2.1F, 1}, {0.6F, 2}, {0.16F, 4}, {0.04F, 8}, {0.1F, 8}};
  for (const auto& [error, count] : expected) {
    glARKParameterfARK(GL_SCREEN_ERROR_ARK, error);
    EXPECT_EQ(segments(arc), count) << error;
  }
  EXPECT_EQ(pending_errors(), "");
}

TEST_F(ScreenError, DepthsFollowTheViewport) {
  glARKParameterfARK(GL_SCREEN_ERROR_ARK, 0.6F);
  EXPECT_EQ(segments(bent(-0.25F, 0.25F)), 2);
  glViewport(0, 0, 4 * picture_size, 4 * picture_size);
  EXPECT_EQ(segments(bent(-0.25F, 0.25F)), 4);
}

TEST_F(ScreenError, SShapedEdgesAreNotStraight) {
  glARKParameterfARK(GL_SCREEN_ERROR_ARK, 0.1F);
  EXPECT_GE(segments(bent(0.25F, 0.25F)), 8) << "the curve meets its chord in the middle";
}

TEST_F(ScreenError, StraightEdgesStayCoarse) {
  glARKParameterfARK(GL_SCREEN_ERROR_ARK, 0.01F);
  EXPECT_EQ(segments(bent(0, 0)), 1);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_LINEAR_INPUTS_ARK);
  EXPECT_EQ(segments(bent(-0.25F, 0.25F)), 1);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_LINEAR_OUTPUTS_ARK);
  EXPECT_EQ(segments(bent(-0.25F, 0.25F)), 1);
}

TEST_F(ScreenError, OfSeveralMeasuresTheLeastDepth) {
  glARKParameterfARK(GL_SCREEN_ERROR_ARK, 0.04F);  // 8 segments
  glARKParameteriARK(GL_EDGE_PIXELS_ARK, 16);      // 2
  EXPECT_EQ(segments(bent(-0.25F, 0.25F)), 2);
  glARKParameteriARK(GL_EDGE_PIXELS_ARK, 1);  // 32
  EXPECT_EQ(segments(bent(-0.25F, 0.25F)), 8);
}

// The camera is outside, in the mesh (ends behind the eye), in a corner and on an edge. A mesh of 20 triangles and one
// of 200 go different ways.
TEST_F(ScreenError, ClosedMeshesHaveNoCracks) {
  glARKParameterfARK(GL_SCREEN_ERROR_ARK, 0.2F);
  std::set<std::size_t> sizes;
  for (const GLint weld : {GL_FALSE, GL_TRUE}) {
    glARKParameteriARK(GL_WELD_ARK, weld);
    for (const bool culls : {false, true}) {
      (culls ? glEnable : glDisable)(GL_CULL_FACE);
      for (const GLfloat distance : {4.0F, 2.1F, 1.618034F, 1.0F, 0.3F, 0.0F, -1.0F, -3.0F}) {
        set_view(program_, perspective(distance, 0.37F));
        for (const Mesh& mesh : {icosahedron(), tetrahedron()}) {
          const std::vector<RefinedVertex> refined = refine(vertices_of(mesh));
          EXPECT_EQ(open_edges(refined), 0) << distance << (weld != 0 ? " welded" : "") << (culls ? " culled" : "");
          sizes.insert(refined.size());
        }
      }
    }
  }
  EXPECT_GT(sizes.size(), 10U) << "the depths do not follow the camera";
}

TEST_F(ScreenError, SmallAndLargeDrawsMeet) {
  glARKParameterfARK(GL_SCREEN_ERROR_ARK, 0.2F);
  set_view(program_, perspective(3.9F, 0.3F));
  for (const int copies : {8, 9, 10}) {  // 160, 180, 200 triangles: the last ones come in threes, or not
    const std::vector<RefinedVertex> small = refine(vertices_of(icosahedron()));
    const std::vector<RefinedVertex> large = refine(vertices_of(icosahedron(), copies));
    EXPECT_EQ(small.size() * static_cast<std::size_t>(copies), large.size());
    std::set<PositionBits> seen;
    for (const RefinedVertex& vertex : small) seen.insert(bits_of(vertex));
    EXPECT_TRUE(std::all_of(large.begin(), large.end(),
                            [&](const RefinedVertex& vertex) { return seen.contains(bits_of(vertex)); }));
  }
}

// Edges whose triangles all face away have depth 0 if GL culls them, and if welding knows the triangles of an edge.
TEST_F(ScreenError, CulledTrianglesStayCoarse) {
  glARKParameterfARK(GL_SCREEN_ERROR_ARK, 0.05F);
  set_view(program_, perspective(16, 0.3F));
  for (const int copies : {1, 10}) {
    const auto count = [&] { return refine(vertices_of(icosahedron(), copies)).size(); };
    glARKParameteriARK(GL_WELD_ARK, GL_TRUE);
    glDisable(GL_CULL_FACE);
    const std::size_t all = count();
    glEnable(GL_CULL_FACE);
    glFrontFace(GL_CCW);
    const std::size_t outside = count();
    glFrontFace(GL_CW);
    const std::size_t inside = count();
    glFrontFace(GL_CCW);
    EXPECT_LT(outside, all * 4 / 5);
    EXPECT_LT(inside, all * 9 / 10);
    glARKParameteriARK(GL_WELD_ARK, GL_FALSE);
    EXPECT_EQ(count(), all);
  }
}

TEST_F(ScreenError, TrianglesOutsideOfTheViewStayCoarse) {
  glARKParameterfARK(GL_SCREEN_ERROR_ARK, 0.04F);
  glARKParameteriARK(GL_WELD_ARK, GL_TRUE);
  std::vector<CurvedVertex> arc = bent(-0.25F, 0.25F);
  EXPECT_EQ(segments(arc), 8);
  for (CurvedVertex& vertex : arc) vertex.position[0] += 1.5F;
  EXPECT_EQ(segments(arc), 1);
  for (CurvedVertex& vertex : arc) vertex.position[0] -= 0.75F;  // partly inside
  EXPECT_EQ(segments(arc), 8);
}

// No number may make the two sides of an edge differ, or the depths run away.
TEST_F(ScreenError, StrangePositionsHaveNoCracks) {
  glARKParameterfARK(GL_SCREEN_ERROR_ARK, 0.2F);
  glARKParameteriARK(GL_WELD_ARK, GL_TRUE);
  glEnable(GL_CULL_FACE);
  for (const GLfloat scale : {1e9F, 1e18F, 1e30F}) {
    Mesh mesh = icosahedron();
    for (auto& position : mesh.positions)
      for (GLfloat& value : position) value *= scale;
    set_view(program_, perspective(4));
    EXPECT_EQ(open_edges(refine(vertices_of(mesh))), 0) << scale;
  }
  const GLfloat nan = std::numeric_limits<GLfloat>::quiet_NaN();
  const GLfloat infinity = std::numeric_limits<GLfloat>::infinity();
  for (const GLfloat value : {nan, infinity, -infinity}) {
    std::vector<CurvedVertex> arc = bent(-0.25F, 0.25F);
    arc[0].position[0] = value;
    std::vector<CurvedVertex> other = {arc[1], arc[0], corner({0, 0, -0.5F})};
    const int count = segments(arc);
    EXPECT_GT(count, 0);
    EXPECT_EQ(segments(other), count) << value;
  }
  EXPECT_EQ(pending_errors(), "");
}

// The middle of the triangle leaves its place, but no edge does.
TEST_F(ScreenError, BulgesOfTheInsideAreNotLost) {
  const GLuint program = link_program(
      {.vertex = "#version 450 core\nin vec3 position; in vec3 normal; in vec3 weights; in float triangle;\n"
                 "out vec3 passed_weights; out float passed_triangle;\n"
                 "void main() { float bulge = 6.0 * weights.x * weights.y * weights.z;\n"
                 "  gl_Position = vec4(position.x, position.y + bulge, position.z + 1e-3 * normal.z, 1.0);\n"
                 "  passed_weights = weights; passed_triangle = triangle; }\n",
       .fragment = "#version 450 core\nout vec4 color;\nvoid main() { color = vec4(1.0); }\n",
       .varyings = {"gl_Position", "passed_weights", "passed_triangle"},
       .attributes = {"position", "normal", "weights", "triangle"}});
  glUseProgram(program);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_LINEAR_INPUTS_ARK);
  glARKParameteriARK(GL_WELD_ARK, GL_TRUE);
  glARKParameterfARK(GL_SCREEN_ERROR_ARK, 1);  // of 14 pixels: 4 segments
  std::vector<CurvedVertex> mesh = {corner({-0.9F, -0.9F, 0}), corner({0.9F, -0.9F, 0}), corner({0, 0.9F, 0})};
  EXPECT_EQ(refine(mesh).size(), 3U * 16);
  while (mesh.size() < 600) mesh.insert(mesh.end(), mesh.begin(), mesh.begin() + 3);
  EXPECT_EQ(refine(mesh).size(), 16 * mesh.size());
}

// Six times the volume, in (x, y, w), of a closed mesh.
GLfloat volume(const std::vector<RefinedVertex>& vertices) {
  GLfloat sum = 0;
  for (std::size_t i = 0; i < vertices.size(); i += 3) {
    const auto& a = vertices[i].position;
    const auto& b = vertices[i + 1].position;
    const auto& c = vertices[i + 2].position;
    const GLfloat from = vertices[0].position[3];
    sum += a[0] * (b[1] * (c[3] - from) - c[1] * (b[3] - from)) + b[0] * (c[1] * (a[3] - from) - a[1] * (c[3] - from)) +
           c[0] * (a[1] * (b[3] - from) - b[1] * (a[3] - from));
  }
  return sum;
}

// The camera comes nearer. Without geomorphing, the volume jumps where a depth changes.
TEST_F(ScreenError, NothingPopsWhileMorphing) {
  glARKParameterfARK(GL_SCREEN_ERROR_ARK, 0.4F);
  const auto largest_step = [&](GLint geomorph) {
    glARKParameteriARK(GL_GEOMORPH_ARK, geomorph);
    GLfloat last = 0;
    GLfloat largest = 0;
    for (int i = 0; i < 60; ++i) {
      set_view(program_, perspective(12 - 0.1F * static_cast<GLfloat>(i)));
      const GLfloat now = volume(refine(vertices_of(tetrahedron())));
      largest = i == 0 ? 0 : std::max(largest, std::abs(now - last));
      last = now;
    }
    return largest;
  };
  const GLfloat jump = largest_step(GL_FALSE);
  EXPECT_GT(jump, 0.01F) << "the path crosses no level";
  EXPECT_LT(largest_step(GL_TRUE), 0.25F * jump);
}

}  // namespace
}  // namespace glark::core::test
