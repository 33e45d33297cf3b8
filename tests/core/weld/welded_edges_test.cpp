// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// GL_WELD_ARK: triangles that meet in the same positions refine to the same bits there, for all normals and tags
// (section 11.R.8). Read back through transform feedback. The control is NormalsPartWithoutWeld: the same meshes must
// crack without it.
#include <map>
#include <set>

#include "tests/core/support/meshes/models.h"
#include "tests/core/support/meshes/welded_edges.h"
#include "tests/core/support/osmesa_context.h"

namespace glark::core::test {
namespace {

constexpr unsigned level = 5;

class WeldedEdges : public testing::Test {
 protected:
  WeldedEdges() {
    glARKinit(level);
    glARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);
    glARKParameteriARK(GL_WELD_ARK, GL_TRUE);
    glEnable(GL_ARK);
    GLuint array = 0;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glUseProgram(link_program(
        {.vertex = "#version 450 core\nin vec3 position; in vec3 normal; in vec3 weights; in float triangle;\n"
                   "out vec3 passed_weights; out float passed_triangle; out vec3 color;\n"
                   "void main() { gl_Position = vec4(position, 1.0); color = normal;\n"
                   "  passed_weights = weights; passed_triangle = triangle; }\n",
         .fragment = "#version 450 core\nin vec3 color; out vec4 result;\n"
                     "void main() { result = vec4(color, 1.0); }\n",
         .varyings = {"gl_Position", "passed_weights", "passed_triangle"},
         .attributes = {"position", "normal", "weights", "triangle"}}));
  }
  std::vector<RefinedVertex> refine(const SplitMesh& mesh) {
    upload(mesh.vertices);
    const auto count = static_cast<GLsizei>(mesh.vertices.size());
    return capture_refined((mesh.triangles() << (2 * level)) + 1, [count] { glDrawArrays(GL_TRIANGLES, 0, count); });
  }
  int parted_edges(const SplitMesh& mesh) {
    const std::vector<RefinedVertex> refined = refine(mesh);
    EXPECT_GE(refined.size(), mesh.vertices.size());
    return test::parted_edges(mesh, refined);
  }
  void expect_welded(const SplitMesh& mesh) {
    for (const unsigned seed : {1U, 2U}) {
      EXPECT_EQ(parted_edges(mesh.tagged_at_random(level, seed)), 0);
    }
    EXPECT_EQ(pending_errors(), "");
  }
  OsmesaContext context_{Profile::core};
};

TEST_F(WeldedEdges, HardEdges) {
  expect_welded(flat_shaded(cube()));
  expect_welded(gear(5, 0.4F, false));
  expect_welded(gear(7, 0, true));
}

TEST_F(WeldedEdges, SeamsEverywhere) {
  expect_welded(seams_everywhere(icosahedron(), 0.01F, 3));
  expect_welded(seams_everywhere(icosahedron(), 0.5F, 4));
  expect_welded(seams_everywhere(icosahedron(), 2, 5));
}

TEST_F(WeldedEdges, NormalsPartWithoutWeld) {
  glARKParameteriARK(GL_WELD_ARK, GL_FALSE);
  EXPECT_GT(parted_edges(gear(7, 0, true).tagged_at_random(level, 1)), 20);
  EXPECT_GT(parted_edges(seams_everywhere(icosahedron(), 0.5F, 4).tagged_at_random(level, 1)), 20);
}

// Three sheets and a duplicate with other normals on the same edge.
TEST_F(WeldedEdges, NonManifoldEdges) {
  std::mt19937 random(9);
  SplitMesh mesh;
  for (int sheet = 0; sheet < 70; ++sheet) {
    const GLfloat angle = 0.8F * static_cast<GLfloat>(sheet % 5);
    std::array<Vector, 3> normals;
    for (Vector& normal : normals) {
      for (GLfloat& value : normal) value = static_cast<GLfloat>(random() % 2001) / 1000 - 1;
    }
    mesh.add({{{-1, 0, 0.1F}, {1, 0, 0.2F}, {0.1F, std::cos(angle), std::sin(angle)}}}, normals);
  }
  expect_welded(mesh);
}

TEST_F(WeldedEdges, FlippedWindings) {
  SplitMesh mesh = seams_everywhere(icosahedron(), 0.3F, 6);
  for (std::size_t t = 0; t < mesh.triangles(); t += 2) {
    std::swap(mesh.vertices[3 * t], mesh.vertices[3 * t + 1]);
    std::swap(mesh.vertices[3 * t].weights, mesh.vertices[3 * t + 1].weights);
    for (std::size_t k = 0; k < 3; ++k) {
      for (GLfloat& value : mesh.vertices[3 * t + k].normal) value = -value;
    }
  }
  expect_welded(mesh);
}

TEST_F(WeldedEdges, DegenerateAndRepeatedTriangles) {
  SplitMesh mesh = seams_everywhere(icosahedron(), 0.5F, 7);
  const std::vector<CurvedVertex> all = mesh.vertices;
  const auto corner = [&](std::size_t i) { return all[i].position; };
  for (std::size_t t = 0; t < 12; ++t) {
    const std::size_t i = 3 * t;
    mesh.add({corner(i), corner(i + 1), corner(i)}, {all[i + 1].normal, all[i].normal, all[i + 2].normal});
    mesh.add({corner(i), corner(i), corner(i)}, {all[i].normal, all[i + 1].normal, all[i + 2].normal});
    mesh.add({corner(i), corner(i + 1), corner(i + 2)}, {all[i].normal, all[i + 1].normal, all[i + 2].normal});
  }
  expect_welded(mesh);
}

// A triangle that stitches strips together, between a face and a wall.
TEST_F(WeldedEdges, ATriangleOfTwoPlacesCoversNothing) {
  const Vector a{-1, 0.25F, 0};
  const Vector b{1, 0.5F, 0.5F};
  SplitMesh mesh;
  mesh.add({a, a, b}, {Vector{0, 0, 1}, Vector{0, 0.7F, 0.7F}, Vector{1, 0, 0.5F}});
  mesh.add({a, b, b}, {Vector{0, 1, 0}, Vector{-1, 0, 1}, Vector{0, 0, 1}});
  mesh.add({b, a, b}, {Vector{0, 1, 0}, Vector{-1, 0, 1}, Vector{0, 0, 1}});
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, level);
  for (const GLint weld : {GL_FALSE, GL_TRUE}) {
    glARKParameteriARK(GL_WELD_ARK, weld);
    const std::vector<RefinedVertex> refined = refine(mesh);
    ASSERT_GE(refined.size(), 9U << (2 * level));
    for (std::size_t t = 0; t + 2 < refined.size(); t += 3) {
      const auto along = [&](std::size_t corner, std::size_t k) {
        return refined[t + corner].position[k] - refined[t].position[k];
      };
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t l = (k + 1) % 3;
        EXPECT_NEAR(along(1, k) * along(2, l), along(1, l) * along(2, k), 1e-6F) << "weld " << weld;
      }
    }
  }
}

// -0 equals 0. Normals may be zero, not finite, or of extreme length.
TEST_F(WeldedEdges, SignsOfZeroAndStrangeNormals) {
  SplitMesh mesh = flat_shaded(cube());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    for (GLfloat& value : mesh.vertices[i].position) value = value < 0 ? (i % 2 == 0 ? -0.0F : 0.0F) : value;
    if (i % 5 == 0) mesh.vertices[i].normal = {0, 0, 0};
    if (i % 7 == 0) mesh.vertices[i].normal = {0, std::nanf(""), 1};
    if (i % 11 == 0) mesh.vertices[i].normal = {INFINITY, 0, 1};
    if (i % 13 == 0) mesh.vertices[i].normal = {1e-38F, 3e38F, 1e30F};
  }
  expect_welded(mesh);
  for (const RefinedVertex& vertex : refine(mesh.tagged_at_random(level, 1))) {
    for (const GLfloat value : vertex.position) ASSERT_TRUE(std::isfinite(value));
  }
}

TEST_F(WeldedEdges, TagsThatDifferTakeTheGreatest) {
  SplitMesh mesh = seams_everywhere(icosahedron(), 0.5F, 8);
  std::mt19937 random(8);
  for (CurvedVertex& vertex : mesh.vertices) vertex.tag = static_cast<GLubyte>(random() % (level + 1));
  EXPECT_EQ(parted_edges(mesh), 0);
  for (const GLenum linear : {GL_LINEAR_INPUTS_ARK, GL_LINEAR_OUTPUTS_ARK}) {
    glARKParameteriARK(GL_REFINEMENT_ARK, static_cast<GLint>(linear));
    EXPECT_EQ(parted_edges(mesh), 0);
    glARKParameteriARK(GL_WELD_ARK, GL_FALSE);
    EXPECT_GT(parted_edges(mesh), 5);
    glARKParameteriARK(GL_WELD_ARK, GL_TRUE);
  }
}

// Draws do not keep the order of their triangles, so the key is the coarse triangle and the weights.
using Surface = std::map<std::array<GLfloat, 4>, std::array<GLfloat, 4>>;

Surface surface_of(const std::vector<RefinedVertex>& refined) {
  Surface surface;
  for (const RefinedVertex& vertex : refined) {
    surface[{vertex.triangle, vertex.weights[0], vertex.weights[1], vertex.weights[2]}] = vertex.position;
  }
  return surface;
}

float furthest_between(const Surface& a, const Surface& b) {
  float furthest = a.size() == b.size() ? 0 : INFINITY;
  for (const auto& [place, position] : a) {
    const auto other = b.find(place);
    if (other == b.end()) return INFINITY;
    for (std::size_t i = 0; i < 4; ++i) furthest = std::max(furthest, std::abs(position[i] - other->second[i]));
  }
  return furthest;
}

// Sets the tension of all vertices.
void set_tension(GLfloat tension) {
  GLint attribute = 0;
  glGetIntegerv(GL_SCALAR_TAG_ATTRIBUTE_ARK, &attribute);
  glVertexAttrib3f(static_cast<GLuint>(attribute), 0, tension, 0);
}

TEST_F(WeldedEdges, TenseEdges) {
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_SCALAR_TAGGED_PN_ARK);
  for (const GLfloat tension : {-0.5F, 0.0F, 0.5F}) {
    set_tension(tension);
    expect_welded(flat_shaded(cube()));
    expect_welded(gear(7, 0, true));
    expect_welded(seams_everywhere(icosahedron(), 0.5F, 4));
  }
  glARKParameteriARK(GL_WELD_ARK, GL_FALSE);
  EXPECT_GT(parted_edges(seams_everywhere(icosahedron(), 0.5F, 4).tagged_at_random(level, 1)), 20);
}

// The surface that displacement starts from. Here displacement adds nothing to it.
TEST_F(WeldedEdges, DisplacedPatches) {
  glARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, 0);
  glARKParameteriARK(GL_DISPLACEMENT_COORDINATE_ARK, 0);
  glARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, 0);
  expect_welded(gear(7, 0, true));
  expect_welded(seams_everywhere(icosahedron(), 0.5F, 4));
}

TEST_F(WeldedEdges, WithoutTagsAsPlainPn) {
  const SplitMesh mesh = seams_everywhere(icosahedron(), 0.5F, 15).tagged_at_random(level, 1);
  const Surface plain = surface_of(refine(mesh));
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_SCALAR_TAGGED_PN_ARK);
  EXPECT_EQ(plain, surface_of(refine(mesh)));
}

// Tension draws an edge towards its chord as it does without welding.
TEST_F(WeldedEdges, TensionIsThatOfUnweldedEdges) {
  const SplitMesh mesh = seams_everywhere(icosahedron(), 0, 16).tagged_at_random(level, 1);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_SCALAR_TAGGED_PN_ARK);
  const Surface loose = surface_of(refine(mesh));
  set_tension(0.5F);
  const Surface welded = surface_of(refine(mesh));
  glARKParameteriARK(GL_WELD_ARK, GL_FALSE);
  EXPECT_LT(furthest_between(welded, surface_of(refine(mesh))), 1e-6F);
  EXPECT_GT(furthest_between(welded, loose), 0.02F);
}

// A tagged corner determines the shape of its edges by itself, welded or not.
TEST_F(WeldedEdges, TaggedCornersAreAsWithoutWeld) {
  const SplitMesh mesh = seams_everywhere(icosahedron(), 0, 17).tagged_at_random(level, 1);
  GLint attribute = 0;
  glGetIntegerv(GL_DISCONTINUITY_ATTRIBUTE_ARK, &attribute);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_SCALAR_TAGGED_PN_ARK);
  const Surface untagged = surface_of(refine(mesh));
  glVertexAttrib4f(static_cast<GLuint>(attribute), 0.3F, 0.1F, -0.2F, 1);
  glGetIntegerv(GL_SCALAR_TAG_ATTRIBUTE_ARK, &attribute);
  glVertexAttrib3f(static_cast<GLuint>(attribute), 0.7F, 0.2F, 0.4F);
  const Surface tagged = surface_of(refine(mesh));
  glARKParameteriARK(GL_WELD_ARK, GL_FALSE);
  EXPECT_EQ(tagged, surface_of(refine(mesh)));
  EXPECT_GT(furthest_between(tagged, untagged), 0.02F);
}

// An edge takes its depth from the side whose normals turn most.
class WeldMeasured : public WeldedEdges {
 protected:
  WeldMeasured() {
    glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK);
    glARKParameteriARK(GL_EDGE_PIXELS_ARK, 0);
    glARKParameteriARK(GL_EDGE_DEGREES_ARK, 3);
  }
};

TEST_F(WeldMeasured, EdgesMatch) {
  const Mesh sphere = icosahedron();
  for (const GLint geomorph : {GL_FALSE, GL_TRUE}) {
    glARKParameteriARK(GL_GEOMORPH_ARK, geomorph);
    for (const GLenum refinement : {GL_CURVED_PN_ARK, GL_LINEAR_INPUTS_ARK, GL_LINEAR_OUTPUTS_ARK}) {
      glARKParameteriARK(GL_REFINEMENT_ARK, static_cast<GLint>(refinement));
      for (const SplitMesh& mesh : {flat_shaded(cube()), gear(7, 0, true), gear(60, 0.3F, true), gear(5, 0.4F, false),
                                    seams_everywhere(cube(), 0.2F, 18), seams_everywhere(sphere, 0.5F, 19)}) {
        EXPECT_EQ(parted_edges(mesh), 0) << mesh.triangles() << " triangles, refinement " << refinement;
      }
    }
  }
  EXPECT_EQ(pending_errors(), "");
}

TEST_F(WeldMeasured, DepthsPartWithoutWeld) {
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_LINEAR_INPUTS_ARK);
  glARKParameteriARK(GL_WELD_ARK, GL_FALSE);
  EXPECT_GT(parted_edges(gear(7, 0, true)), 20);
  EXPECT_GT(parted_edges(seams_everywhere(icosahedron(), 0.5F, 19)), 10);
}

// Two triangles share an edge, in either order and with more flat sides. The edge has 8 segments, because the normals
// of one side turn by 90 degrees.
TEST_F(WeldMeasured, TheGreaterTurnCounts) {
  glARKParameteriARK(GL_EDGE_DEGREES_ARK, 12);
  const Vector a{0, 0, 0};
  const Vector b{1, 0, 0};
  const Vector up{0, 0, 1};
  const std::array<Vector, 3> flat{up, up, up};
  const std::array<Vector, 3> turning{up, Vector{1, 0, 0}, up};
  for (const std::size_t first : {0U, 1U, 2U}) {
    SplitMesh mesh;
    for (std::size_t i = 0; i < 3; ++i) {
      mesh.add({{a, b, {0.5F, i == first ? 1.0F : -1.0F, 0.1F}}}, i == first ? turning : flat);
    }
    for (const auto& [ends, sides] : sides_of_edges(mesh, refine(mesh))) {
      if (sides.size() != 3) continue;
      for (const Points& side : sides) EXPECT_EQ(side.size(), 9U);
    }
  }
}

// Where all sides turn alike, welding does not change depths.
TEST_F(WeldMeasured, SmoothMeshIsAsBefore) {
  const SplitMesh mesh = seams_everywhere(icosahedron(), 0, 20);
  const Surface welded = surface_of(refine(mesh));
  glARKParameteriARK(GL_WELD_ARK, GL_FALSE);
  EXPECT_EQ(welded, surface_of(refine(mesh)));
  EXPECT_GT(welded.size(), 1000U);
}

// There are more triangles than one work group takes.
TEST_F(WeldedEdges, LargeMesh) {
  const SplitMesh mesh = gear(60, 0.3F, true);
  ASSERT_GT(mesh.triangles(), 900U);
  expect_welded(mesh);
}

// The surface does not depend on the order of triangles and corners.
TEST_F(WeldedEdges, OrderDoesNotMatter) {
  const SplitMesh mesh = seams_everywhere(icosahedron(), 0.5F, 10).tagged_at_random(3, 1);
  std::mt19937 random(10);
  std::vector<std::size_t> order(mesh.triangles());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::shuffle(order.begin(), order.end(), random);
  SplitMesh other;
  for (const std::size_t t : order) {
    const auto first = mesh.vertices.begin() + static_cast<std::ptrdiff_t>(3 * t);
    std::array<CurvedVertex, 3> corners{first[0], first[1], first[2]};
    std::rotate(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(t % 3), corners.end());
    other.vertices.insert(other.vertices.end(), corners.begin(), corners.end());
  }
  const auto points = [](const std::vector<RefinedVertex>& refined) {
    std::multiset<PositionBits> result;
    for (const RefinedVertex& vertex : refined) {
      const bool edge = vertex.weights[0] == 0 || vertex.weights[1] == 0 || vertex.weights[2] == 0;
      if (edge) result.insert(test::bits_of(vertex));
    }
    return result;
  };
  EXPECT_EQ(points(refine(mesh)), points(refine(other)));
}

// Where normals agree, welding does not change the surface.
TEST_F(WeldedEdges, SmoothMeshIsAsBefore) {
  const SplitMesh mesh = seams_everywhere(icosahedron(), 0, 11).tagged_at_random(level, 1);
  const auto points = [](const std::vector<RefinedVertex>& refined) {
    std::multiset<PositionBits> result;
    for (const RefinedVertex& vertex : refined) result.insert(test::bits_of(vertex));
    return result;
  };
  const auto welded = points(refine(mesh));
  glARKParameteriARK(GL_WELD_ARK, GL_FALSE);
  EXPECT_EQ(welded, points(refine(mesh)));
}

class WeldModel : public WeldedEdges, public testing::WithParamInterface<const char*> {};

TEST_P(WeldModel, EdgesMatch) {
  const auto mesh = coarse_model(GetParam(), 24);
  if (!mesh) GTEST_SKIP() << GetParam() << " is not in " GLARK_MODELS ", or zstd is missing";
  const SplitMesh hard = creased(*mesh, 0.8F).tagged_at_random(3, 1);
  EXPECT_EQ(parted_edges(hard), 0);
  EXPECT_EQ(parted_edges(seams_everywhere(*mesh, 0.3F, 14).tagged_at_random(3, 2)), 0);
  glARKParameteriARK(GL_WELD_ARK, GL_FALSE);
  EXPECT_GT(parted_edges(hard), 100) << "the model has no hard edges";
}

INSTANTIATE_TEST_SUITE_P(All, WeldModel, testing::Values("armadillo", "bunny", "horse", "igea", "nefertiti"),
                         [](const auto& model) { return std::string(model.param); });

TEST_F(WeldedEdges, CubeStaysACube) {
  for (const RefinedVertex& vertex : refine(flat_shaded(cube()).tagged_at_random(level, 1))) {
    const auto [x, y, z, w] = vertex.position;
    EXPECT_EQ(std::max({std::abs(x), std::abs(y), std::abs(z)}), 1.0F);
  }
}

// The rim of a cylinder is as round as its wall, and the lid stays flat.
TEST_F(WeldedEdges, RimOfACylinderIsRound) {
  const SplitMesh mesh = gear(3, 0, true).tagged_at_random(0, 1);
  SplitMesh fine = mesh;
  for (CurvedVertex& vertex : fine.vertices) vertex.tag = level;
  double least = 9;
  for (const RefinedVertex& vertex : refine(fine)) {
    if (std::abs(vertex.position[2]) == 0.5F && vertex.triangle >= 0) {
      const auto t = static_cast<std::size_t>(vertex.triangle);
      const bool wall = fine.vertices[3 * t].normal[2] == 0;
      if (wall) least = std::min(least, std::hypot(double{vertex.position[0]}, double{vertex.position[1]}));
    } else {
      const auto t = static_cast<std::size_t>(vertex.triangle);
      EXPECT_EQ(fine.vertices[3 * t].normal[2], 0) << "the lid has left its plane";
    }
  }
  EXPECT_GT(least, 1.49);  // the chords are at 1.449
}

}  // namespace
}  // namespace glark::core::test
