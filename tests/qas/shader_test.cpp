// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Reads the refinement shader under OSMesa back through transform feedback, and compares it with the evaluation on the
// CPU, and bit by bit along shared edges.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/core/support/meshes/closed_mesh.h"
#include "tests/core/support/osmesa_context.h"
#include "tests/qas/meshes.h"

namespace glark::qas::test {
using core::test::RefinedVertex;

struct Language {
  std::string name, head;
  core::test::Profile profile;
};

inline std::ostream& operator<<(std::ostream& out, const Language& language) { return out << language.name; }

namespace {

constexpr GLuint level = 4;

const Language core_language = {"core",
                                "#version 450 core\nin mat2x3 point; in mat2x3 normal; in vec3 weights; in float "
                                "number;\nout vec3 passed_weights; out "
                                "float passed_number;\n",
                                core::test::Profile::core};
const Language old_language = {"glsl120",
                               "#version 120\nattribute mat2x3 point; attribute mat2x3 normal; attribute vec3 weights; "
                               "attribute float number;\nvarying vec3 passed_weights; varying float passed_number;\n",
                               core::test::Profile::compatibility};

GLuint link(const Language& language, const std::string& result) {
  const GLuint program = core::test::link_program({.vertex = language.head + "void main() { gl_Position = " + result +
                                                             "; passed_weights = weights; passed_number = number; }\n",
                                                   .varyings = {"gl_Position", "passed_weights", "passed_number"},
                                                   .attributes = {"point", "", "normal", "", "weights", "number"}});
  ShaderInputs inputs;
  if (result.find("normal") == std::string::npos) inputs.normal = "";
  const std::string source = refinement_shader(inputs);
  const char* const text = source.c_str();
  glUseProgram(program);
  glRefinementShaderSourceARK(program, 1, &text, nullptr);
  GLint built = GL_FALSE;
  std::array<char, 4096> log{};
  glGetRefinementivARK(program, GL_REFINEMENT_STATUS_ARK, &built);
  glGetRefinementInfoLogARK(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
  EXPECT_EQ(built, GL_TRUE) << log.data();
  return program;
}

struct Vertex {
  Corner corner;
  std::array<GLfloat, 3> weights;  // 1 at the corner itself
  GLfloat patch;
  GLubyte tag;
};

// torn: a number that is added to one edge of one patch.
void upload(const Surface& surface, const std::vector<GLubyte>& tags, float torn) {
  std::vector<Corner> corners(surface.corner_count());
  surface.write_corners(corners);
  std::vector<Vertex> vertices;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto [a, b] = surface.corner_vertices()[i];
    const std::size_t patch = i / 3;
    vertices.push_back({corners[i], {}, static_cast<GLfloat>(patch), static_cast<GLubyte>((tags[a] + tags[b]) / 2)});
    vertices.back().weights[i % 3] = 1;
  }
  vertices.front().corner.edge_position[0] += torn;
  core::test::make_buffer(GL_ARRAY_BUFFER, vertices);
  const std::array<std::size_t, 6> offsets = {offsetof(Corner, position), offsetof(Corner, edge_position),
                                              offsetof(Corner, normal),   offsetof(Corner, edge_normal),
                                              offsetof(Vertex, weights),  offsetof(Vertex, patch)};
  for (GLuint i = 0; i < 6; ++i) {
    glVertexAttribPointer(i, i == 5 ? 1 : 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), core::test::byte_offset(offsets[i]));
    glEnableVertexAttribArray(i);
  }
  glDepthTagPointerARK(GL_UNSIGNED_BYTE, sizeof(Vertex), core::test::byte_offset(offsetof(Vertex, tag)));
  glEnable(GL_DEPTH_TAG_ARRAY_ARK);
}

// Returns the output `result` at every refined vertex. tags: one for each coarse vertex.
std::vector<RefinedVertex> refined(const Surface& surface, const Language& language, const std::string& result,
                                   const std::vector<GLubyte>& tags, float torn = 0) {
  GLuint array = 0;
  glGenVertexArrays(1, &array);
  glBindVertexArray(array);
  glARKinit(level);
  glARKParameteriARK(GL_DEPTH_TAG_ATTRIBUTE_ARK, 7);
  upload(surface, tags, torn);
  link(language, result);
  glEnable(GL_ARK);
  auto vertices = core::test::capture_refined((surface.patches().size() << (2 * level)) + 1, [&] {
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(surface.corner_count()));
  });
  EXPECT_EQ(core::test::pending_errors(), "");
  return vertices;
}

std::vector<GLubyte> random_tags(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<GLubyte> tags(count);
  for (GLubyte& tag : tags) tag = static_cast<GLubyte>(random() % (level + 1));
  return tags;
}

Surface surface_of(const ControlMesh& mesh, unsigned splits = 0) {
  Surface surface(mesh.view(), {.splits = splits});
  surface.update(mesh.positions);
  return surface;
}

class RefinementShader : public testing::TestWithParam<Language> {
 protected:
  core::test::OsmesaContext context_{GetParam().profile};
};

TEST_P(RefinementShader, GivesWhatTheCpuEvaluates) {
  const ControlMesh mesh = shaken(sheet(4), 0.02);
  const Surface surface = surface_of(mesh);
  const std::vector<GLubyte> tags = random_tags(mesh.vertex_count(), 1);
  const auto positions = refined(surface, GetParam(), "vec4(point[0], normal[0].x)", tags);
  const auto normals = refined(surface, GetParam(), "vec4(normal[0], point[0].x)", tags);
  ASSERT_EQ(positions.size(), normals.size());
  ASSERT_GT(positions.size(), mesh.triangles.size());
  double farthest = 0;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const auto patch = static_cast<std::size_t>(positions[i].triangle);
    const Sample sample = surface.evaluate(patch, positions[i].weights);
    for (std::size_t k = 0; k < 3; ++k) {
      farthest = std::max<double>(farthest, std::fabs(sample.position[k] - positions[i].position[k]));
      farthest = std::max<double>(farthest, std::fabs(sample.normal[k] - normals[i].position[k]));
    }
  }
  EXPECT_LE(farthest, 1e-6);
}

TEST_P(RefinementShader, LeavesNoEdgeOpenUnderRandomTags) {
  for (const unsigned splits : {0U, 1U}) {
    for (const ControlMesh& mesh : {shaken(icosahedron(), 0.05), blocks(), drum(7)}) {
      const Surface surface = surface_of(mesh, splits);
      for (const unsigned seed : {1U, 2U, 3U}) {
        const auto vertices =
            refined(surface, GetParam(), "vec4(point[0], 1.0)", random_tags(mesh.vertex_count(), seed));
        EXPECT_GT(vertices.size(), surface.corner_count());
        EXPECT_EQ(core::test::open_edges(vertices), 0) << mesh.name << " seed " << seed << " splits " << splits;
      }
    }
  }
}

// The control is an edge with different midpoints on its two sides.
TEST_P(RefinementShader, ADifferentMiddleOpensTheEdge) {
  const ControlMesh mesh = icosahedron();
  const std::vector<GLubyte> tags(mesh.vertex_count(), 2);
  EXPECT_EQ(core::test::open_edges(refined(surface_of(mesh), GetParam(), "vec4(point[0], 1.0)", tags)), 0);
  const auto vertices = refined(surface_of(mesh), GetParam(), "vec4(point[0], 1.0)", tags, 1e-6F);
  EXPECT_GT(core::test::open_edges(vertices), 0);
}

INSTANTIATE_TEST_SUITE_P(Languages, RefinementShader, testing::Values(core_language, old_language),
                         [](const auto& parameter) { return parameter.param.name; });

}  // namespace
}  // namespace glark::qas::test
