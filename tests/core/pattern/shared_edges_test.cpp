// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// There are no cracks: sections 11.R.5 (patterns) and 11.R.8 (shared edges), read back through transform feedback.
//
// Plan: two triangles share the edge A-B. The refined vertices along A-B have the same bits from both sides, and make
// 2^d segments. This holds for every triple of tags, every rotation of both triangles and both orientations of the
// second one. The control is SharedEdgeOfDifferentTags: with different tags at A the sides must differ.
#include <algorithm>
#include <random>
#include <set>

#include "tests/core/support/curved_program.h"
#include "tests/core/support/meshes/closed_mesh.h"
#include "tests/core/support/osmesa_context.h"

namespace glark::core::test {
namespace {

constexpr GLuint level = 6;
constexpr int tags = level + 1;
constexpr int pairs = tags * tags * tags;

struct Way {
  Language language;
  GLenum refinement;
  GLenum interior;
};

std::string name_of(const testing::TestParamInfo<Way>& info) {
  const std::string language = info.param.language == Language::glsl_450_core ? "core" : "glsl120";
  const std::string refinement = info.param.refinement == GL_CURVED_PN_ARK        ? "Curved"
                                 : info.param.refinement == GL_PHONG_ARK          ? "Phong"
                                 : info.param.refinement == GL_LINEAR_OUTPUTS_ARK ? "Outputs"
                                                                                  : "Inputs";
  return language + refinement + (info.param.interior == GL_SMOOTH_INTERIOR_ARK ? "Smooth" : "Minimum");
}

Profile profile_of(Language language) {
  return language == Language::glsl_450_core ? Profile::core : Profile::compatibility;
}

// A corner of the pair: A, B, C or D (the fourth corner, of the second triangle).
struct Corner {
  std::array<GLfloat, 3> position;
  std::array<GLfloat, 3> normal;
  int tag;
};

std::array<Corner, 4> corners_of_pair(int a, int b, int c) {
  return {{{{0.13F, -0.71F, 0.33F}, {0.2F, -0.5F, 0.9F}, a},
           {{1.07F, 0.59F, -0.41F}, {0.7F, 0.3F, 1.1F}, b},
           {{-0.93F, 0.77F, 0.21F}, {-0.6F, 0.4F, 0.8F}, c},
           {{1.31F, -1.03F, -0.17F}, {0.5F, -0.9F, 0.7F}, (3 * c + a + 1) % tags}}};
}

void append_triangle(std::vector<CurvedVertex>& mesh, const std::array<Corner, 3>& corners, int rotation, int number) {
  for (int k = 0; k < 3; ++k) {
    const auto corner = static_cast<std::size_t>((k + rotation) % 3);
    CurvedVertex vertex{corners[corner].position,
                        corners[corner].normal,
                        {},
                        static_cast<GLfloat>(number),
                        static_cast<GLubyte>(corners[corner].tag)};
    vertex.weights[corner] = 1;  // of A, B and the third corner, for every rotation
    mesh.push_back(vertex);
  }
}

// Triangles 2p and 2p + 1 share the edge of pair p.
std::vector<CurvedVertex> all_pairs(int rotation, int other_rotation, bool flipped) {
  std::vector<CurvedVertex> mesh;
  for (int pair = 0; pair < pairs; ++pair) {
    const auto [a, b, c, d] = corners_of_pair(pair / (tags * tags), pair / tags % tags, pair % tags);
    append_triangle(mesh, {a, b, c}, rotation, 2 * pair);
    std::vector<CurvedVertex> second;
    append_triangle(second, {a, b, d}, other_rotation, 2 * pair + 1);
    if (flipped) std::swap(second[1], second[2]);
    mesh.insert(mesh.end(), second.begin(), second.end());
  }
  return mesh;
}

struct RefinedTriangle {
  std::set<PositionBits> edge_vertices;  // along A-B
  int edge_segments = 0;
  int count = 0;
  double area = 0;  // signed, in barycentric coordinates; the whole is 1
  double smallest = 1;
};

std::vector<RefinedTriangle> measure(const std::vector<RefinedVertex>& vertices) {
  std::vector<RefinedTriangle> result(2 * pairs);
  for (std::size_t i = 0; i + 2 < vertices.size(); i += 3) {
    RefinedTriangle& triangle = result.at(static_cast<std::size_t>(vertices[i].triangle));
    const auto& [p, q, r] = std::array{vertices[i].weights, vertices[i + 1].weights, vertices[i + 2].weights};
    const double area = double{q[0] - p[0]} * double{r[1] - p[1]} - double{q[1] - p[1]} * double{r[0] - p[0]};
    ++triangle.count;
    triangle.area += area;
    triangle.smallest = std::min(triangle.smallest, std::abs(area));
    int on_edge = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (vertices[i + k].weights[2] == 0) {
        triangle.edge_vertices.insert(bits_of(vertices[i + k]));
        ++on_edge;
      }
    }
    triangle.edge_segments += on_edge == 2 ? 1 : 0;
  }
  return result;
}

// Section 11.R.5, MINIMUM_INTERIOR_ARK.
int triangles_of_pattern(int a, int b, int c) {
  const int d0 = (a + b) / 2;
  const int d1 = (b + c) / 2;
  const int d2 = (c + a) / 2;
  const int m = 1 << std::min({d0, d1, d2});
  return (m - 1) * (m - 2) + (1 << d0) + (1 << d1) + (1 << d2) - 2;
}

class SharedEdges : public testing::TestWithParam<Way> {
 protected:
  SharedEdges() {
    glARKinit(level);
    glARKParameteriARK(GL_REFINEMENT_ARK, static_cast<GLint>(GetParam().refinement));
    glARKParameteriARK(GL_PATTERN_INTERIOR_ARK, static_cast<GLint>(GetParam().interior));
    glEnable(GL_ARK);
    GLuint array = 0;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glUseProgram(link_curved_program(GetParam().language));
  }
  std::vector<RefinedVertex> refine(const std::vector<CurvedVertex>& mesh, std::size_t most) {
    upload(mesh);
    const auto count = static_cast<GLsizei>(mesh.size());
    return capture_refined(most, [count] { glDrawArrays(GL_TRIANGLES, 0, count); });
  }
  void expect_closed(const std::vector<RefinedTriangle>& triangles, bool flipped) {
    for (int pair = 0; pair < pairs && !HasFailure(); ++pair) {
      const auto [a, b, c, d] = corners_of_pair(pair / (tags * tags), pair / tags % tags, pair % tags);
      SCOPED_TRACE(testing::Message() << "tags " << a.tag << b.tag << c.tag << d.tag);
      const std::size_t first = std::size_t{2} * static_cast<std::size_t>(pair);
      const RefinedTriangle& one = triangles[first];
      const RefinedTriangle& two = triangles[first + 1];
      const int segments = 1 << ((a.tag + b.tag) / 2);
      EXPECT_EQ(one.edge_segments, segments);
      EXPECT_EQ(two.edge_segments, segments);
      EXPECT_EQ(one.edge_vertices.size(), static_cast<std::size_t>(segments + std::int64_t{1}));
      EXPECT_EQ(one.edge_vertices, two.edge_vertices);
      EXPECT_EQ(one.area, 1.0);
      EXPECT_EQ(two.area, flipped ? -1.0 : 1.0);
      EXPECT_GT(std::min(one.smallest, two.smallest), 0.0);
      if (GetParam().interior == GL_MINIMUM_INTERIOR_ARK) {
        EXPECT_EQ(one.count, triangles_of_pattern(a.tag, b.tag, c.tag));
        EXPECT_EQ(two.count, triangles_of_pattern(a.tag, b.tag, d.tag));
      }
    }
  }
  OsmesaContext context_{profile_of(GetParam().language)};
};

INSTANTIATE_TEST_SUITE_P(All, SharedEdges,
                         testing::Values(Way{Language::glsl_120, GL_LINEAR_INPUTS_ARK, GL_MINIMUM_INTERIOR_ARK},
                                         Way{Language::glsl_120, GL_CURVED_PN_ARK, GL_MINIMUM_INTERIOR_ARK},
                                         Way{Language::glsl_450_core, GL_LINEAR_INPUTS_ARK, GL_SMOOTH_INTERIOR_ARK},
                                         Way{Language::glsl_450_core, GL_LINEAR_OUTPUTS_ARK, GL_MINIMUM_INTERIOR_ARK},
                                         Way{Language::glsl_450_core, GL_CURVED_PN_ARK, GL_MINIMUM_INTERIOR_ARK},
                                         Way{Language::glsl_120, GL_PHONG_ARK, GL_MINIMUM_INTERIOR_ARK},
                                         Way{Language::glsl_450_core, GL_PHONG_ARK, GL_SMOOTH_INTERIOR_ARK},
                                         Way{Language::glsl_450_core, GL_CURVED_PN_ARK, GL_SMOOTH_INTERIOR_ARK}),
                         name_of);

TEST_P(SharedEdges, EveryTripleRotationAndOrientation) {
  for (int way = 0; way < 18 && !HasFailure(); ++way) {
    const bool flipped = way >= 9;
    SCOPED_TRACE(testing::Message() << "rotations " << way % 3 << way / 3 % 3 << " flipped " << flipped);
    expect_closed(measure(refine(all_pairs(way % 3, way / 3 % 3, flipped), 600000)), flipped);
  }
}

TEST_P(SharedEdges, SharedEdgeOfDifferentTags) {
  std::vector<CurvedVertex> mesh;
  auto [a, b, c, d] = corners_of_pair(4, 4, 2);
  append_triangle(mesh, {a, b, c}, 0, 0);
  a.tag = 2;
  append_triangle(mesh, {a, b, d}, 0, 1);
  const std::vector<RefinedTriangle> triangles = measure(refine(mesh, 10000));
  EXPECT_EQ(triangles[0].edge_segments, 16);
  EXPECT_EQ(triangles[1].edge_segments, 8);
  EXPECT_NE(triangles[0].edge_vertices, triangles[1].edge_vertices);
}

TEST_P(SharedEdges, ClosedMeshWithRandomTags) {
  std::mt19937 random(7);
  for (const Mesh& mesh : {icosahedron(), tetrahedron(), icosahedron(), icosahedron()}) {
    std::vector<int> tag(mesh.positions.size());
    for (int& value : tag) value = static_cast<int>(random() % tags);
    std::vector<CurvedVertex> vertices;
    for (const auto& triangle : mesh.triangles) {
      std::array<Corner, 3> corners;
      for (std::size_t k = 0; k < 3; ++k)
        corners[k] = {mesh.positions[triangle[k]], mesh.positions[triangle[k]], tag[triangle[k]]};
      append_triangle(vertices, corners, static_cast<int>(random() % 3), 0);
    }
    const std::vector<RefinedVertex> refined = refine(vertices, 200000);
    EXPECT_GT(refined.size(), 3 * mesh.triangles.size());
    EXPECT_EQ(open_edges(refined), 0);
  }
}

TEST(SharedEdgesControl, OpenEdgesAreFound) {
  RefinedVertex a{{0, 0, 0, 1}, {}, 0};
  RefinedVertex b{{1, 0, 0, 1}, {}, 0};
  RefinedVertex c{{0, 1, 0, 1}, {}, 0};
  RefinedVertex moved = c;
  moved.position[0] = 1e-7F;
  EXPECT_EQ(open_edges({a, b, c, a, c, b}), 0);
  EXPECT_EQ(open_edges({a, b, c, a, moved, b}), 4);
}

}  // namespace
}  // namespace glark::core::test
