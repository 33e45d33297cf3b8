// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// GL_WELD_ARK under displacement: points on an edge have the same bits for all its sides, for any texture coordinates
// and normals. The controls are the same meshes without welding, which must crack.
#include <limits>

#include "tests/core/support/measured_program.h"
#include "tests/core/support/meshes/mapped_mesh.h"

namespace glark::core::test {
namespace {

constexpr GLuint discontinuity_attribute = 14;
constexpr GLuint scalar_tag_attribute = 13;

TEST_F(DisplacedEdges, HardEdges) {
  expect_welded(mapped_cube());
  expect_welded(mapped_at_random(gear(5, 0.4F, false), 3));
}

TEST_F(DisplacedEdges, SeamOfASphere) { expect_welded(globe()); }

TEST_F(DisplacedEdges, SeamsEverywhere) {
  expect_welded(mapped_at_random(flat_shaded(icosahedron()), 7));
  expect_welded(mapped_at_random(seams_everywhere(icosahedron(), 0.5F, 4), 8));
}

TEST_F(DisplacedEdges, SeamsPartWithoutWeld) {
  glARKParameteriARK(GL_WELD_ARK, GL_FALSE);
  for (const GLenum refinement : refinements) {
    set_refinement(refinement);
    EXPECT_GE(parted_edges(globe(), 4), 4);
    EXPECT_GT(parted_edges(mapped_at_random(flat_shaded(icosahedron()), 7), 4), 20);
  }
}

// Sides are repeated and reversed, each with other coordinates, on edges of many sides.
TEST_F(DisplacedEdges, NonManifoldEdgesAndFlippedWindings) {
  SplitMesh mesh = seams_everywhere(icosahedron(), 0.4F, 6);
  for (std::size_t t = 0; t < mesh.triangles(); t += 3) {
    std::swap(mesh.vertices[3 * t], mesh.vertices[3 * t + 1]);
    std::swap(mesh.vertices[3 * t].weights, mesh.vertices[3 * t + 1].weights);
    for (std::size_t k = 0; k < 3; ++k) {
      for (GLfloat& value : mesh.vertices[3 * t + k].normal) value = -value;
    }
  }
  const std::vector<CurvedVertex> all = mesh.vertices;
  for (std::size_t i = 0; i + 2 < all.size(); i += 6) {
    mesh.add({all[i + 1].position, all[i].position, {0, 0, 0}}, {all[i].normal, all[i + 2].normal, all[i + 1].normal});
    mesh.add({all[i].position, all[i + 1].position, all[i + 2].position},
             {all[i + 1].normal, all[i].normal, all[i + 2].normal});
  }
  expect_welded(mapped_at_random(mesh, 9));
}

// There are more triangles than one work group takes.
TEST_F(DisplacedEdges, ManyTriangles) {
  const SplitMesh gears = gear(12, 0.3F, true);
  ASSERT_GT(gears.triangles(), 128U);
  expect_welded(mapped_at_random(gears, 11));
}

TEST_F(DisplacedEdges, Geomorphing) {
  glARKParameteriARK(GL_GEOMORPH_ARK, GL_TRUE);
  for (const MappedMesh& mapped : {mapped_cube(), mapped_at_random(seams_everywhere(icosahedron(), 0.4F, 4), 8)}) {
    upload(mapped);
    std::vector<GLfloat> tags;
    for (const CurvedVertex& vertex : mapped.mesh.tagged_at_random(200, 3).vertices) {
      tags.push_back(static_cast<GLfloat>(vertex.tag) / 40);
    }
    for (const GLenum refinement : refinements) {
      set_refinement(refinement);
      glUseProgram(capture_program_);
      upload(mapped);
      make_buffer(GL_ARRAY_BUFFER, tags);
      glDepthTagPointerARK(GL_FLOAT, 0, nullptr);
      const auto count = static_cast<GLsizei>(mapped.coordinates.size());
      const auto refined =
          capture_refined(mapped.mesh.triangles() << 12, [count] { glDrawArrays(GL_TRIANGLES, 0, count); });
      EXPECT_EQ(test::parted_edges(mapped.mesh, refined), 0) << "refinement " << refinement;
    }
  }
  EXPECT_EQ(pending_errors(), "");
}

TEST_F(DisplacedEdges, MeasuredDepths) {
  for (const GLint degrees : {0, 4}) {
    measure_depths(5, 4, degrees);
    for (const GLenum refinement : refinements) {
      set_refinement(refinement);
      EXPECT_EQ(parted_edges(mapped_cube(), 5), 0) << "refinement " << refinement << ", degrees " << degrees;
      const auto seams = mapped_at_random(seams_everywhere(icosahedron(), 0.4F, 4), 8);
      EXPECT_GT(refine(seams, 5).size(), 2 * seams.coordinates.size()) << "nothing is refined";
      EXPECT_EQ(parted_edges(seams, 5), 0) << "refinement " << refinement << ", degrees " << degrees;
    }
  }
  EXPECT_EQ(pending_errors(), "");
}

// Creases by scalar tags on split vertices: one discontinuity and one set of tags for each place, coordinates and
// normals at random.
TEST_F(DisplacedEdges, TaggedCreases) {
  set_refinement(GL_SCALAR_TAGGED_PN_ARK);
  std::mt19937 random(31);
  const auto number = [&] { return static_cast<GLfloat>(random() % 2001) / 1000 - 1; };
  for (unsigned trial = 0; trial < 8; ++trial) {
    glARKParameteriARK(GL_GEOMORPH_ARK, trial % 2 != 0 ? GL_TRUE : GL_FALSE);
    MappedMesh mapped = mapped_at_random(seams_everywhere(icosahedron(), 0, 1), trial);
    mapped.mesh = mapped.mesh.tagged_at_random(5, trial);
    std::map<PositionBits, std::pair<std::array<GLfloat, 4>, Vector>> tags_of;
    std::vector<std::array<GLfloat, 4>> discontinuities;
    std::vector<Vector> tags;
    for (const CurvedVertex& vertex : mapped.mesh.vertices) {
      const auto [place, is_new] = tags_of.try_emplace(bits_of(vertex.position));
      if (is_new && random() % 2 != 0) {
        place->second = {{0.3F * number(), 0.3F * number(), 0.3F * number(), static_cast<GLfloat>(random() % 2)},
                         {1 + number(), number(), number()}};
      }
      discontinuities.push_back(place->second.first);
      tags.push_back(place->second.second);
    }
    make_buffer(GL_ARRAY_BUFFER, discontinuities);
    glVertexAttribPointer(discontinuity_attribute, 4, GL_FLOAT, GL_FALSE, 0, nullptr);
    glEnableVertexAttribArray(discontinuity_attribute);
    make_buffer(GL_ARRAY_BUFFER, tags);
    glVertexAttribPointer(scalar_tag_attribute, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    glEnableVertexAttribArray(scalar_tag_attribute);
    EXPECT_EQ(parted_edges(mapped, 5), 0) << "trial " << trial;
    if (trial % 4 == 0) {
      glARKParameteriARK(GL_WELD_ARK, GL_FALSE);
      EXPECT_GT(parted_edges(mapped, 5), 5) << "the scene has no seams";
      glARKParameteriARK(GL_WELD_ARK, GL_TRUE);
    }
  }
  EXPECT_EQ(pending_errors(), "");
}

std::vector<PositionBits> bits_of_all(const std::vector<RefinedVertex>& refined) {
  std::vector<PositionBits> bits;
  for (const RefinedVertex& vertex : refined) bits.push_back(bits_of(vertex));
  return bits;
}

TEST_F(DisplacedEdges, WhereNothingIsSplitNothingChanges) {
  MappedMesh mapped{seams_everywhere(icosahedron(), 0, 1).tagged_at_random(4, 2), {}};
  for (const CurvedVertex& vertex : mapped.mesh.vertices) {
    mapped.coordinates.push_back({0.4F * vertex.position[0], 0.4F * vertex.position[1] + 0.1F * vertex.position[2]});
  }
  for (const GLenum refinement : refinements) {
    set_refinement(refinement);
    glARKParameteriARK(GL_WELD_ARK, GL_TRUE);
    const auto welded = bits_of_all(refine(mapped, 4));
    glARKParameteriARK(GL_WELD_ARK, GL_FALSE);
    EXPECT_EQ(welded, bits_of_all(refine(mapped, 4))) << "refinement " << refinement;
  }
}

bool is_inside(const RefinedVertex& vertex) {
  return vertex.weights[0] != 0 && vertex.weights[1] != 0 && vertex.weights[2] != 0;
}

TEST_F(DisplacedEdges, TheInsideKeepsItsOwnCoordinates) {
  set_refinement(GL_LINEAR_INPUTS_ARK);
  MappedMesh mapped = mapped_at_random(flat_shaded(icosahedron()), 7);
  mapped.mesh = mapped.mesh.tagged_at_random(4, 2);
  for (CurvedVertex& vertex : mapped.mesh.vertices) vertex.tag = 4;
  const auto welded = refine(mapped, 4);
  glARKParameteriARK(GL_WELD_ARK, GL_FALSE);
  const auto parted = refine(mapped, 4);
  ASSERT_EQ(welded.size(), parted.size());
  int inside = 0;
  for (std::size_t i = 0; i < welded.size(); ++i) {
    ASSERT_EQ(welded[i].weights, parted[i].weights);
    if (!is_inside(welded[i])) continue;
    ++inside;
    EXPECT_EQ(bits_of(welded[i]), bits_of(parted[i]));
  }
  EXPECT_GT(inside, 1000);
}

// The surface does not depend on the order of the triangles, nor on the order of their corners.
TEST_F(DisplacedEdges, TheOrderOfTrianglesDoesNotMatter) {
  const auto reversed = [](MappedMesh mesh) {
    std::reverse(mesh.mesh.vertices.begin(), mesh.mesh.vertices.end());
    std::reverse(mesh.coordinates.begin(), mesh.coordinates.end());
    return mesh;
  };
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 3);
  const auto border = [&](const MappedMesh& mesh) {
    Points points;
    for (const RefinedVertex& vertex : refine(mesh, 3)) {
      if (!is_inside(vertex)) points.insert(bits_of(vertex));
    }
    return points;
  };
  for (const GLenum refinement : refinements) {
    set_refinement(refinement);
    for (const MappedMesh& mapped : {globe(), mapped_at_random(seams_everywhere(icosahedron(), 0.5F, 4), 8)}) {
      EXPECT_EQ(border(mapped), border(reversed(mapped))) << "refinement " << refinement;
    }
  }
}

// Invalid normals have no direction. Triangles without an area do not affect edges.
TEST_F(DisplacedEdges, BadInput) {
  const GLfloat nan = std::numeric_limits<GLfloat>::quiet_NaN();
  const GLfloat infinity = std::numeric_limits<GLfloat>::infinity();
  MappedMesh mapped = mapped_at_random(seams_everywhere(icosahedron(), 0.5F, 7), 14);
  std::vector<CurvedVertex>& all = mapped.mesh.vertices;
  all[4].normal = {nan, 0, 1};
  all[13].normal = {0, infinity, 1};
  all[22].normal = {0, 0, 0};
  all[31].normal = {1e30F, -1e30F, 1e-30F};
  for (std::size_t i = 0; i < 30; i += 3) {
    const std::array<Vector, 2> ends = {all[i].position, all[i + 1].position};
    mapped.mesh.add({ends[0], ends[1], ends[0]}, {all[i + 1].normal, all[i].normal, all[i + 2].normal});
    mapped.coordinates.insert(mapped.coordinates.end(), {{0.3F, 0.1F}, {0.7F, 0.9F}, {0.2F, 0.5F}});
  }
  mapped.mesh = mapped.mesh.tagged_at_random(4, 3);
  set_refinement(GL_CURVED_PN_ARK);
  const SplitMesh sound{{mapped.mesh.vertices.begin(), mapped.mesh.vertices.begin() + 60}};
  std::vector<RefinedVertex> refined = refine(mapped, 4);
  std::erase_if(refined, [](const RefinedVertex& vertex) { return vertex.triangle >= 20; });
  EXPECT_EQ(test::parted_edges(sound, refined), 0);
  EXPECT_TRUE(std::all_of(refined.begin(), refined.end(), [](const RefinedVertex& vertex) {
    const bool finite = std::isfinite(vertex.position[0] + vertex.position[1] + vertex.position[2]);
    return finite || (is_inside(vertex) && (vertex.triangle == 1 || vertex.triangle == 4));
  }));
  mapped.coordinates[7] = {nan, 0.5F};
  mapped.coordinates[9] = {0.5F, -infinity};
  refine(mapped, 4);
  EXPECT_EQ(pending_errors(), "");
}

// The record is so long that only a storage block could hold it, but the program has storage blocks of its own. It is
// displaced as without welding.
TEST_F(DisplacedEdges, WhereTheRecordHasNoRoom) {
  capture_program_ = link_program(
      {.vertex = "#version 450 core\nin vec3 position; in vec3 normal; in vec3 weights; in float triangle;\n"
                 "in vec2 texcoord; out vec3 passed_weights; out float passed_triangle;\n"
                 "layout(std430, binding = 0) readonly buffer Far { float shift; };\n"
                 "void main() { gl_Position = vec4(position + shift + 0.0 * (normal.x + texcoord.x), 1.0);\n"
                 "  passed_weights = weights; passed_triangle = triangle; }\n",
       .fragment = "#version 450 core\nout vec4 result;\nvoid main() { result = vec4(1.0); }\n",
       .varyings = {"gl_Position", "passed_weights", "passed_triangle"},
       .attributes = {"position", "normal", "weights", "triangle", "texcoord"}});
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, make_buffer(GL_ARRAY_BUFFER, std::vector<GLfloat>{0}));
  set_refinement(GL_CURVED_PN_ARK);
  MappedMesh mapped = mapped_cube();
  for (CurvedVertex& vertex : mapped.mesh.vertices) vertex.tag = 3;
  const auto welded = bits_of_all(refine(mapped, 3));
  EXPECT_EQ(welded.size(), mapped.coordinates.size() << 6);
  glARKParameteriARK(GL_WELD_ARK, GL_FALSE);
  EXPECT_EQ(welded, bits_of_all(refine(mapped, 3)));
  EXPECT_EQ(pending_errors(), "");
}

// A kept capture has the border's coordinates from the attribute that was set at the time of the capture.
TEST_F(DisplacedEdges, KeptDrawsFollowTheCoordinateAttribute) {
  const GLuint program = link_program(
      {.vertex =
           "#version 450 core\nin vec3 position; in vec3 normal; in vec3 weights; in float triangle;\n"
           "in vec2 texcoord; in vec2 other; out vec3 passed_weights; out float passed_triangle; out vec3 color;\n"
           "void main() { gl_Position = vec4(position, 1.0); color = vec3(normal.x, texcoord.x, other.x);\n"
           "  passed_weights = weights; passed_triangle = triangle; }\n",
       .fragment = "#version 450 core\nin vec3 color; out vec4 result;\n"
                   "void main() { result = vec4(color, 1.0); }\n",
       .varyings = {"gl_Position", "passed_weights", "passed_triangle"},
       .attributes = {"position", "normal", "weights", "triangle", "texcoord", "other"}});
  const MappedMesh mapped = mapped_at_random(flat_shaded(icosahedron()), 7);
  const auto count = static_cast<GLsizei>(mapped.coordinates.size());
  glUseProgram(program);
  upload(mapped);
  make_buffer(GL_ARRAY_BUFFER, mapped_at_random(mapped.mesh, 8).coordinates);
  glVertexAttribPointer(coordinate_attribute + 1, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
  glEnableVertexAttribArray(coordinate_attribute + 1);
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 2);
  const auto draw = [count] { glDrawArrays(GL_TRIANGLES, 0, count); };
  const auto captured = [&] { return bits_of_all(capture_refined((mapped.mesh.triangles() << 4) + 1, draw)); };
  glARKParameteriARK(GL_DISPLACEMENT_COORDINATE_ARK, coordinate_attribute + 1);
  const auto expected = captured();
  glARKParameteriARK(GL_DISPLACEMENT_COORDINATE_ARK, coordinate_attribute);
  for (int repetition = 0; repetition < 3; ++repetition) draw();
  EXPECT_NE(captured(), expected);
  glARKParameteriARK(GL_DISPLACEMENT_COORDINATE_ARK, coordinate_attribute + 1);
  EXPECT_EQ(captured(), expected);
  EXPECT_EQ(pending_errors(), "");
}

// A flat sheet, cut in two, with steps of height. On the cut, all vertices have the height of one of the two sides.
TEST_F(DisplacedEdges, AnEdgeHasTheHeightsOfOneOfItsSides) {
  set_refinement(GL_LINEAR_INPUTS_ARK);
  const std::vector<GLfloat> heights = {0, 1};
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, 2, 1, 0, GL_RED, GL_FLOAT, heights.data());
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
    glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
  }
  const Vector up{0, 0, 1};
  MappedMesh sheet;
  sheet.mesh.add({{{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {up, up, up});
  sheet.mesh.add({{{1, 0, 0}, {-1, 0, 0}, {0, -1, 0}}}, {up, up, up});
  sheet.coordinates = {{0.75F, 0}, {0.75F, 0}, {0.75F, 0}, {0.25F, 0}, {0.25F, 0}, {0.25F, 0}};
  sheet.mesh = sheet.mesh.tagged_at_random(0, 1);
  for (CurvedVertex& vertex : sheet.mesh.vertices) vertex.tag = 3;
  int on_cut = 0;
  for (const RefinedVertex& vertex : refine(sheet, 3)) {
    const bool cut = vertex.weights[2] == 0;
    on_cut += cut ? 1 : 0;
    // 0.25 comes before 0.75
    EXPECT_EQ(vertex.position[2], cut || vertex.triangle == 1 ? 0.0F : 0.3F);
  }
  EXPECT_GE(on_cut, 18);
}

// Two sheets at right angles, with the same heights: the edge moves outwards half way between their normals.
TEST_F(DisplacedEdges, HardEdgesGoBetweenTheirNormals) {
  set_refinement(GL_LINEAR_INPUTS_ARK);
  const std::vector<GLfloat> heights = {1};
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, 1, 1, 0, GL_RED, GL_FLOAT, heights.data());
  MappedMesh mapped = mapped_cube();
  for (CurvedVertex& vertex : mapped.mesh.vertices) vertex.tag = 2;
  int middles = 0;
  for (const RefinedVertex& vertex : refine(mapped, 2)) {
    std::array<GLfloat, 3> p{};
    for (std::size_t i = 0; i < 3; ++i) p[i] = std::abs(vertex.position[i]);
    std::sort(p.begin(), p.end());
    if (p[0] > 1e-4F || is_inside(vertex) || p[1] < 0.9F) continue;
    ++middles;
    EXPECT_NEAR(p[1], 1 + 0.3F * std::sqrt(0.5F), 1e-3F);
    EXPECT_NEAR(p[2], 1 + 0.3F * std::sqrt(0.5F), 1e-3F);
  }
  EXPECT_GT(middles, 12);
}

}  // namespace
}  // namespace glark::core::test
