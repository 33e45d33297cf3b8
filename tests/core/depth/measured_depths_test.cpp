// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Measured depths (section 11.R.4), read back through transform feedback. There are no cracks for any camera. The depth
// of an edge follows from its length on the screen, or from the turn between its normals.
#include <algorithm>
#include <random>
#include <set>

#include "tests/core/support/measured_program.h"
#include "tests/core/support/meshes/closed_mesh.h"
#include "tests/core/support/osmesa_context.h"

namespace glark::core::test {
namespace {

constexpr GLuint level = 5;

CurvedVertex corner(std::array<GLfloat, 3> position, std::array<GLfloat, 3> normal = {0, 0, 1}) {
  return {position, normal, {}, 0, 0};
}

class MeasuredDepths : public testing::TestWithParam<GLenum> {
 protected:
  MeasuredDepths() {
    glViewport(0, 0, picture_size, picture_size);
    GLuint array = 0;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    program_ = link_measured_program();
    glUseProgram(program_);
    set_view(program_, flat_view);
    measure_depths(level, 8);
  }
  std::vector<RefinedVertex> refine(std::vector<CurvedVertex> mesh) {
    for (std::size_t i = 0; i < mesh.size(); ++i) {
      const std::size_t triangle = i / 3;
      mesh[i].triangle = static_cast<GLfloat>(triangle);
      mesh[i].weights = {};
      mesh[i].weights[i % 3] = 1;
    }
    upload(mesh);
    const auto count = static_cast<GLsizei>(mesh.size());
    return capture_refined(200000, [count] {  // in two draws, which must agree
      glDrawArrays(GL_TRIANGLES, 0, count / 6 * 3);
      glDrawArrays(GL_TRIANGLES, count / 6 * 3, count - count / 6 * 3);
    });
  }
  // Segments of edge 0, 1 and 2 of one triangle.
  std::array<int, 3> segments(const std::vector<CurvedVertex>& triangle) {
    const std::vector<RefinedVertex> vertices = refine(triangle);
    std::array<int, 3> count{};
    for (std::size_t i = 0; i < vertices.size(); i += 3) {
      for (std::size_t edge = 0; edge < 3; ++edge) {
        int on_edge = 0;
        for (std::size_t k = 0; k < 3; ++k) on_edge += vertices[i + k].weights[(edge + 2) % 3] == 0 ? 1 : 0;
        count[edge] += on_edge == 2 ? 1 : 0;
      }
    }
    return count;
  }
  OsmesaContext context_{Profile::core};
  GLuint program_ = 0;
};

class MeasureRefinement : public MeasuredDepths {};

std::string name_of(const testing::TestParamInfo<GLenum>& refinement) {
  return refinement.param == GL_LINEAR_INPUTS_ARK    ? "Inputs"
         : refinement.param == GL_LINEAR_OUTPUTS_ARK ? "Outputs"
                                                     : "Curved";
}

INSTANTIATE_TEST_SUITE_P(All, MeasureRefinement,
                         testing::Values(GL_LINEAR_INPUTS_ARK, GL_LINEAR_OUTPUTS_ARK, GL_CURVED_PN_ARK), name_of);
INSTANTIATE_TEST_SUITE_P(All, MeasuredDepths, testing::Values(GL_LINEAR_INPUTS_ARK), name_of);

std::vector<CurvedVertex> turned(const Mesh& mesh, std::mt19937& random) {
  std::vector<CurvedVertex> vertices;
  for (const auto& triangle : mesh.triangles) {
    const std::size_t rotation = random() % 3;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& position = mesh.positions[triangle[(k + rotation) % 3]];
      vertices.push_back(corner(position, position));
    }
  }
  return vertices;
}

// The camera is outside, in the mesh (ends behind the eye), in a corner and on an edge (ends and edges through the
// eye).
TEST_P(MeasureRefinement, ClosedMeshesHaveNoCracks) {
  glARKParameteriARK(GL_REFINEMENT_ARK, static_cast<GLint>(GetParam()));
  std::mt19937 random(11);
  std::set<std::size_t> sizes;
  for (const Mesh& mesh : {icosahedron(), tetrahedron()}) {
    for (const GLfloat distance : {4.0F, 2.1F, 1.618034F, 1.0F, 0.3F, 0.0F, -1.0F, -3.0F}) {
      for (const GLint degrees : {0, 5}) {
        glARKParameteriARK(GL_EDGE_DEGREES_ARK, degrees);
        set_view(program_, perspective(distance, 0.37F * static_cast<GLfloat>(random() % 17)));
        const std::vector<RefinedVertex> refined = refine(turned(mesh, random));
        EXPECT_EQ(open_edges(refined), 0) << "distance " << distance << " degrees " << degrees;
        sizes.insert(refined.size());
      }
    }
  }
  EXPECT_GT(sizes.size(), 10U) << "the depths do not follow the camera";
}

// A fan of many triangles about all edges of the mesh goes through the bins; the mesh itself does not. Their depths
// must agree.
TEST_P(MeasuredDepths, SmallAndLargeDrawsMeet) {
  std::mt19937 random(5);
  const Mesh sphere = icosahedron();
  for (const GLint degrees : {0, 5}) {
    glARKParameteriARK(GL_EDGE_DEGREES_ARK, degrees);
    set_view(program_, perspective(1.9F, 0.3F));
    std::vector<CurvedVertex> mesh = turned(sphere, random);
    const std::vector<RefinedVertex> small = refine(mesh);
    const std::size_t once = mesh.size();
    while (mesh.size() < 6 * 200)
      mesh.insert(mesh.end(), mesh.begin(), mesh.begin() + static_cast<std::ptrdiff_t>(once));
    const std::vector<RefinedVertex> large = refine(mesh);
    EXPECT_EQ(small.size() * (mesh.size() / once), large.size());
    std::set<PositionBits> seen;
    for (const RefinedVertex& vertex : small) seen.insert(bits_of(vertex));
    EXPECT_TRUE(std::all_of(large.begin(), large.end(),
                            [&](const RefinedVertex& vertex) { return seen.contains(bits_of(vertex)); }));
  }
}

TEST_P(MeasuredDepths, ScreenLengthGivesTheDepth) {
  // 32, 24 and 40 pixels of 8: 4 segments, 3 and 5 of them rounded up to powers of two.
  const std::vector<CurvedVertex> triangle{corner({0, 0, 0}), corner({0.5F, 0, 0}), corner({0.5F, 0.375F, 0})};
  EXPECT_EQ(segments(triangle), (std::array{4, 4, 8}));
  glViewport(0, 0, picture_size / 2, picture_size);
  EXPECT_EQ(segments(triangle), (std::array{2, 4, 4}));
  glViewport(0, 0, picture_size, picture_size);
  glARKParameteriARK(GL_EDGE_PIXELS_ARK, 40);
  EXPECT_EQ(segments(triangle), (std::array{1, 1, 1}));
  glARKParameteriARK(GL_EDGE_PIXELS_ARK, 1);
  EXPECT_EQ(segments(triangle), (std::array{32, 32, 32}));  // level 5 is the deepest
  EXPECT_EQ(pending_errors(), "");
}

TEST_P(MeasuredDepths, DepthsFollowTheCamera) {
  const std::vector<CurvedVertex> triangle{corner({-1, -1, 0}), corner({1, -1, 0}), corner({0, 1, 0})};
  const auto refined_at = [&](GLfloat distance) {
    set_view(program_, perspective(distance));
    return segments(triangle);
  };
  EXPECT_EQ(refined_at(4), (std::array{4, 8, 8}));  // 32 pixels, and 35.8
  EXPECT_EQ(refined_at(8), (std::array{2, 4, 4}));
  EXPECT_EQ(refined_at(64), (std::array{1, 1, 1}));
  EXPECT_EQ(refined_at(0), (std::array{16, 32, 32}));  // 90 degrees, and through the eye
  EXPECT_EQ(refined_at(-8), (std::array{2, 4, 4}));    // behind the eye: as far away as in front of it
  EXPECT_EQ(refined_at(-64), (std::array{1, 1, 1}));
}

TEST_P(MeasuredDepths, NormalsGiveTheDepth) {
  glARKParameteriARK(GL_EDGE_PIXELS_ARK, 0);
  glARKParameteriARK(GL_EDGE_DEGREES_ARK, 30);
  const std::vector<CurvedVertex> triangle{corner({0, 0, 0}, {0, 0, 5}), corner({0.5F, 0, 0}, {0, 0.1F, 0}),
                                           corner({0.5F, 0.4F, 0}, {0, 0, -3})};
  EXPECT_EQ(segments(triangle), (std::array{4, 4, 8}));  // 90, 90 and 180 degrees
  glARKParameteriARK(GL_EDGE_DEGREES_ARK, 90);
  EXPECT_EQ(segments(triangle), (std::array{1, 1, 2}));
  EXPECT_EQ(segments({corner({0, 0, 0}), corner({1, 0, 0}), corner({0, 1, 0}, {0, 0, 0})}), (std::array{1, 1, 1}));
}

TEST_P(MeasuredDepths, OfTwoMeasuresTheLesserDepth) {
  glARKParameteriARK(GL_EDGE_DEGREES_ARK, 45);
  EXPECT_EQ(
      segments({corner({0, 0, 0}, {0, 0, 1}), corner({0.5F, 0, 0}, {0, 0, 1}), corner({0.5F, 0.05F, 0}, {0, 1, 0})}),
      (std::array{1, 1, 2}));  // 4 on the screen, but flat; 2 by the turn, but short; 8 and 2
}

}  // namespace
}  // namespace glark::core::test
