// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Reads GL_SCALAR_TAGGED_PN_ARK (11.R.7a) back through transform feedback, and compares with the CPU, with plain PN,
// and the bits along edges.
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "tests/core/support/meshes/closed_mesh.h"
#include "tests/core/support/osmesa_context.h"
#include "tests/pn/tagged_program.h"

namespace glark::pn::test {
namespace {

class Tagged : public testing::Test {
 protected:
  Tagged() {
    glARKinit(5);
    glEnable(GL_ARK);
    GLuint array = 0;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
  }
  static std::vector<RefinedVertex> refine(const std::vector<TaggedVertex>& mesh, Shown shown,
                                           GLenum refinement = GL_SCALAR_TAGGED_PN_ARK) {
    glUseProgram(link_tagged_program(shown));
    glARKParameteriARK(GL_REFINEMENT_ARK, static_cast<GLint>(refinement));
    upload(mesh);
    const auto count = static_cast<GLsizei>(mesh.size());
    std::vector<RefinedVertex> refined =
        capture_refined(mesh.size() * 400, [count] { glDrawArrays(GL_TRIANGLES, 0, count); });
    EXPECT_EQ(pending_errors(), "");
    return refined;
  }
  OsmesaContext context_{Profile::core};
};

std::vector<Triangle> random_triangles(unsigned seed, int count) {
  Dice dice(seed);
  std::vector<Triangle> triangles;
  for (int i = 0; i < count; ++i) {
    triangles.push_back({dice.corner(i % 2 != 0), dice.corner(i % 4 > 1), dice.corner(i % 8 > 3)});
  }
  return triangles;
}

std::vector<TaggedVertex> mesh_of(const std::vector<Triangle>& triangles) {
  std::vector<TaggedVertex> mesh;
  for (std::size_t i = 0; i < triangles.size(); ++i) append(mesh, triangles[i], static_cast<int>(i));
  return mesh;
}

std::array<double, 3> weights_of(const RefinedVertex& vertex) {
  return {vertex.weights[0], vertex.weights[1], vertex.weights[2]};
}

TEST_F(Tagged, AgreesWithTheCpu) {
  const std::vector<Triangle> triangles = random_triangles(3, 64);
  for (const Shown shown : {Shown::position, Shown::normal}) {
    const std::vector<RefinedVertex> refined = refine(mesh_of(triangles), shown);
    ASSERT_EQ(refined.size(), 64U * 64 * 3);
    for (const RefinedVertex& vertex : refined) {
      const Sample sample = evaluate(triangles.at(static_cast<std::size_t>(vertex.triangle)), weights_of(vertex));
      const auto& expected = shown == Shown::position ? sample.position : sample.normal;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        ASSERT_NEAR(vertex.position[axis], expected[axis], shown == Shown::position ? 3e-6 : 2e-4)
            << "triangle " << vertex.triangle << " at " << vertex.weights[0] << " " << vertex.weights[1];
      }
    }
  }
}

TEST_F(Tagged, WithoutTagsItIsPlainPnBitForBit) {
  std::vector<Triangle> triangles = random_triangles(5, 32);
  for (Triangle& triangle : triangles) {
    for (Corner& corner : triangle) {
      corner.discontinuity = {0, 0, 0, 1};
      corner.tags[1] = 0;  // sharpness and bias have no effect without a discontinuity
    }
  }
  for (const Shown shown : {Shown::position, Shown::normal}) {
    const std::vector<RefinedVertex> plain = refine(mesh_of(triangles), shown, GL_CURVED_PN_ARK);
    const std::vector<RefinedVertex> tagged = refine(mesh_of(triangles), shown);
    ASSERT_EQ(plain.size(), tagged.size());
    for (std::size_t i = 0; i < plain.size(); ++i) ASSERT_EQ(bits_of(plain[i]), bits_of(tagged[i]));
  }
}

TEST_F(Tagged, VerticesWithoutArraysAreUntagged) {
  const std::vector<Triangle> triangles = random_triangles(7, 8);
  const std::vector<RefinedVertex> plain = refine(mesh_of(triangles), Shown::position, GL_CURVED_PN_ARK);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_SCALAR_TAGGED_PN_ARK);
  GLint attribute = 0;
  for (const GLenum name : {GL_DISCONTINUITY_ATTRIBUTE_ARK, GL_SCALAR_TAG_ATTRIBUTE_ARK}) {
    glGetIntegerv(name, &attribute);
    glDisableVertexAttribArray(static_cast<GLuint>(attribute));
  }
  const auto draw = [] { glDrawArrays(GL_TRIANGLES, 0, 24); };
  const std::vector<RefinedVertex> initial = capture_refined(10000, draw);
  ASSERT_EQ(plain.size(), initial.size());
  for (std::size_t i = 0; i < plain.size(); ++i) ASSERT_EQ(bits_of(plain[i]), bits_of(initial[i]));
  glVertexAttrib3f(static_cast<GLuint>(attribute), 0, 1, 0);  // the tension of all vertices
  const std::vector<RefinedVertex> tense = capture_refined(10000, draw);
  EXPECT_NE(bits_of(plain[4]), bits_of(tense[4]));
}

TEST_F(Tagged, AttributesOfOnesOwnChoice) {
  const std::vector<Triangle> triangles = random_triangles(9, 8);
  const std::vector<RefinedVertex> usual = refine(mesh_of(triangles), Shown::position);
  for (GLuint i = 4; i < 15; ++i) glDisableVertexAttribArray(i);
  glARKParameteriARK(GL_DISCONTINUITY_ATTRIBUTE_ARK, 5);
  glARKParameteriARK(GL_SCALAR_TAG_ATTRIBUTE_ARK, 7);
  const std::vector<RefinedVertex> moved = refine(mesh_of(triangles), Shown::position);
  ASSERT_EQ(usual.size(), moved.size());
  for (std::size_t i = 0; i < usual.size(); ++i) ASSERT_EQ(bits_of(usual[i]), bits_of(moved[i]));
}

// Tests every pair of depth tags, and tagged and untagged ends, with random scalar tags. The third corners must not
// affect the edge.
TEST_F(Tagged, SharedEdgesHaveTheSameBits) {
  constexpr int depths = 6;
  constexpr int pairs = 16 * depths * depths;
  Dice dice(11);
  std::vector<TaggedVertex> mesh;
  for (int pair = 0; pair < pairs; ++pair) {
    const int depth_a = pair / 16 % depths;
    const int depth_b = pair / 16 / depths;
    const Corner a = dice.corner(pair % 2 != 0);
    const Corner b = dice.corner(pair % 4 > 1);
    append(mesh, {a, b, dice.corner(dice.whole(2) != 0)}, 2 * pair, {depth_a, depth_b, dice.whole(depths)},
           dice.whole(3));
    append(mesh, {a, b, dice.corner(dice.whole(2) != 0)}, 2 * pair + 1, {depth_a, depth_b, dice.whole(depths)},
           dice.whole(3));
    if (dice.whole(2) != 0) std::swap(mesh[mesh.size() - 1], mesh[mesh.size() - 2]);
  }
  for (const GLenum interior : {GL_MINIMUM_INTERIOR_ARK, GL_SMOOTH_INTERIOR_ARK}) {
    glARKParameteriARK(GL_PATTERN_INTERIOR_ARK, static_cast<GLint>(interior));
    std::map<int, std::set<PositionBits>> along;
    for (RefinedVertex vertex : refine(mesh, Shown::position)) {
      vertex.position[3] = 0;  // the vertex keeps the normal of one side
      if (vertex.weights[2] == 0) along[static_cast<int>(vertex.triangle)].insert(bits_of(vertex));
    }
    for (int pair = 0; pair < pairs; ++pair) {
      const int depth = (pair / 16 % depths + pair / 16 / depths) / 2;
      EXPECT_EQ(along[2 * pair].size(), (1U << depth) + 1) << pair;
      EXPECT_EQ(along[2 * pair], along[2 * pair + 1]) << pair;
    }
  }
}

TEST_F(Tagged, AClosedMeshStaysClosed) {
  const core::test::Mesh ball = icosahedron();
  for (unsigned seed = 0; seed < 8; ++seed) {
    Dice dice(seed);
    std::vector<Corner> corners;
    std::vector<int> depths;
    for (const auto& position : ball.positions) {
      corners.push_back(dice.corner(dice.whole(2) != 0));
      corners.back().position = corners.back().normal = position;
      depths.push_back(dice.whole(6));
    }
    std::vector<TaggedVertex> mesh;
    for (const auto& [i, j, k] : ball.triangles) {
      append(mesh, {corners[i], corners[j], corners[k]}, 0, {depths[i], depths[j], depths[k]}, dice.whole(3));
    }
    std::vector<RefinedVertex> refined = refine(mesh, Shown::position);
    for (RefinedVertex& vertex : refined) vertex.position[3] = 0;
    EXPECT_EQ(open_edges(refined), 0) << seed;
  }
}

// The cache of a draw depends on its tags.
TEST_F(Tagged, TagsThatChangeAreSeen) {
  const std::vector<TaggedVertex> mesh = mesh_of(random_triangles(21, 4));
  const std::vector<RefinedVertex> before = refine(mesh, Shown::position);
  const auto draw = [] { glDrawArrays(GL_TRIANGLES, 0, 12); };
  for (int frame = 0; frame < 4; ++frame) EXPECT_EQ(bits_of(capture_refined(10000, draw)[4]), bits_of(before[4]));
  const std::array<GLfloat, 3> tense = {0, 1, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t offset = i * sizeof(TaggedVertex) + offsetof(TaggedVertex, corner.tags);
    glBufferSubData(GL_ARRAY_BUFFER, static_cast<GLintptr>(offset), sizeof(tense), tense.data());
  }
  EXPECT_NE(bits_of(capture_refined(10000, draw)[4]), bits_of(before[4]));
}

// The vertex stage also reads the tags, as vec4 and as vec3. They are captured once, and still shape the surface.
TEST_F(Tagged, ATagMayBeAnInputOfTheProgram) {
  const std::vector<Triangle> triangles = random_triangles(23, 8);
  const std::vector<RefinedVertex> expected = refine(mesh_of(triangles), Shown::position);
  glARKParameteriARK(GL_DISCONTINUITY_ATTRIBUTE_ARK, 4);
  glARKParameteriARK(GL_SCALAR_TAG_ATTRIBUTE_ARK, 5);
  refine(mesh_of(triangles), Shown::position);  // points the arrays there
  glUseProgram(link_program(
      {.vertex = "#version 450 core\nin vec3 position; in vec3 normal; in vec3 weights; in float triangle;\n"
                 "in vec4 jump; in vec3 tags; out vec3 passed_weights; out float passed_triangle;\n"
                 "void main() { gl_Position = vec4(position, jump.x + tags.y + normal.x);\n"
                 "  passed_weights = weights; passed_triangle = triangle; }\n",
       .fragment = "#version 450 core\nout vec4 color;\nvoid main() { color = vec4(1.0); }\n",
       .varyings = {"gl_Position", "passed_weights", "passed_triangle"},
       .attributes = {"position", "normal", "weights", "triangle", "jump", "tags"}}));
  const std::vector<RefinedVertex> refined = capture_refined(10000, [] { glDrawArrays(GL_TRIANGLES, 0, 24); });
  EXPECT_EQ(pending_errors(), "");
  ASSERT_EQ(refined.size(), expected.size());
  for (std::size_t i = 0; i < refined.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) ASSERT_EQ(refined[i].position[axis], expected[i].position[axis]);
  }
}

TEST_F(Tagged, NormalsAreSharedAlongUntaggedEdges) {
  Dice dice(13);
  std::vector<TaggedVertex> mesh;
  for (int pair = 0; pair < 64; ++pair) {
    const Corner a = dice.corner(false);
    const Corner b = dice.corner(false);
    append(mesh, {a, b, dice.corner(true)}, 2 * pair, {3, 3, 3}, dice.whole(3));
    append(mesh, {b, a, dice.corner(true)}, 2 * pair + 1, {3, 3, 3}, dice.whole(3));
  }
  std::map<int, std::set<PositionBits>> along;
  for (const RefinedVertex& vertex : refine(mesh, Shown::normal)) {
    if (vertex.weights[2] == 0) along[static_cast<int>(vertex.triangle)].insert(bits_of(vertex));
  }
  for (int pair = 0; pair < 64; ++pair) EXPECT_EQ(along[2 * pair], along[2 * pair + 1]) << pair;
}

TEST_F(Tagged, NothingMakesNan) {
  constexpr float huge = std::numeric_limits<float>::infinity();
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  std::vector<Triangle> triangles;
  for (const float odd : {huge, -huge, nan, 1e30F, 1e-30F, 0.0F}) {
    Dice dice(17);
    for (int word = 0; word < 7; ++word) {
      Triangle triangle = {dice.corner(true), dice.corner(true), dice.corner(false)};
      (word < 4 ? triangle[0].discontinuity.at(static_cast<std::size_t>(word))
                : triangle[0].tags.at(static_cast<std::size_t>(word - 4))) = odd;
      triangles.push_back(triangle);
    }
    Triangle point = {dice.corner(true), dice.corner(true), dice.corner(true)};
    for (Corner& corner : point) corner.position = {1, 2, 3};
    triangles.push_back(point);
  }
  for (const Shown shown : {Shown::position, Shown::normal}) {
    for (const RefinedVertex& vertex : refine(mesh_of(triangles), shown)) {
      for (const float value : vertex.position) ASSERT_TRUE(std::isfinite(value)) << vertex.triangle;
    }
  }
}

}  // namespace
}  // namespace glark::pn::test
