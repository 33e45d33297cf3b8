// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Two coarse triangles with a common edge have the same refined vertices along it, bit for bit (11.R.8, 11.R.4).
#include <fmt/core.h>
#include <algorithm>
#include <set>
#include <utility>

#include "conformance/cases/cases.h"
#include "conformance/support/refined_draw.h"

namespace glark::conformance {
namespace {

struct EdgeVertex {
  Vec4 position;  // gl_Position
  Vec3 place;     // inputs
  Vec3 normal;
  Vec4 colour;
  Vec3 along;  // (1, 0, 0) and (0, 1, 0) at the ends of the shared edge
  float pair;
};
using Values = std::array<float, sizeof(EdgeVertex) / sizeof(float)>;
constexpr std::size_t along_index = 14;
constexpr std::size_t pair_index = 17;

enum class Extra { none, refinement_shader, displacement, scalar_tags, other_colours };

struct Variant {
  const char* name;
  GLenum refinement;
  Extra extra;
  std::vector<std::string> clauses;
};

const char vertex_stage[] =
    "layout(location = 0) in vec4 position; layout(location = 1) in vec3 normal;\n"
    "layout(location = 2) in vec3 along; layout(location = 3) in vec4 vertex_colour;\n"
    "layout(location = 4) in vec2 texcoord; layout(location = 6) in float pair;\n"
    "uniform mat4 turn;\n"
    "out vec3 place; out vec3 normal_out; out vec4 colour; out vec3 along_out; out float pair_out;\n"
    "void main() { place = position.xyz; normal_out = normal; colour = vertex_colour + texcoord.xyxy * 0.125;\n"
    "  along_out = along; pair_out = pair; vec4 p = turn * position;\n"
    "  gl_Position = p + vec4(0.1 * sin(3.0 * p.y), 0.1 * p.x * p.z, p.x * p.y, 0.25 * p.z + 0.3); }\n";

GLuint edge_program(Test& t, const Variant& variant) {
  const GLuint program = build_program(
      t,
      {.vertex = vertex_stage, .captured = {"gl_Position", "place", "normal_out", "colour", "along_out", "pair_out"}});
  gl.UseProgram(program);
  const GLfloat turn[16] = {0.7F,  0.3F,  -0.2F, 0.1F, -0.31F, 0.9F, 0.11F, 0,
                            0.21F, -0.1F, 0.8F,  0.2F, 0.1F,   0,    0.3F,  1};
  gl.UniformMatrix4fv(gl.GetUniformLocation(program, "turn"), 1, GL_FALSE, turn);
  if (variant.extra == Extra::refinement_shader)
    set_refinement_shader(t, program,
                          "void refine() { position.xyz += 0.3 * sin(7.0 * position.yzx) * normal;\n"
                          "  vertex_colour = vertex_colour.zyxw + position * 0.1; }\n");
  return program;
}

MeshVertex random_vertex(Test& t, int tag, float pair) {
  MeshVertex vertex;
  for (std::size_t i = 0; i < 3; ++i) vertex.position[i] = t.random_float(-0.9F, 0.9F);
  vertex.normal = {t.random_float(-0.5F, 0.5F), t.random_float(-0.5F, 0.5F), t.random_float(0.3F, 1.2F)};
  for (float& value : vertex.colour) value = t.random_float(0, 1);
  for (float& value : vertex.texture) value = t.random_float(0, 1);
  vertex.weights = {0, 0, 1};
  vertex.tag = static_cast<float>(tag);
  vertex.triangle = pair;
  return vertex;
}

void add_triangle(Mesh& mesh, const std::array<MeshVertex, 3>& corners, std::size_t first) {
  for (std::size_t i = 0; i < 3; ++i) mesh.push_back(corners[(first + i) % 3]);
}

struct Pairs {
  Mesh here;
  Mesh there;
  std::vector<int> depths;  // of each shared edge
};

// All pairs of tags at the ends, every rotation of the corners of both triangles, and the ends in either order.
Pairs random_pairs(Test& t, int level, const Variant& variant) {
  Pairs pairs;
  for (int a = 0; a <= level; ++a)
    for (int b = 0; b <= level; ++b)
      for (std::size_t turn = 0; turn < 3; ++turn) {
        const auto pair = static_cast<float>(pairs.depths.size());
        MeshVertex first = random_vertex(t, a, pair);
        MeshVertex second = random_vertex(t, b, pair);
        first.weights = {1, 0, 0};
        second.weights = {0, 1, 0};
        add_triangle(pairs.here, {first, second, random_vertex(t, t.random_int(0, level), pair)}, turn);
        if (variant.extra == Extra::other_colours) {
          first.colour = {1, 0, 1, 0};
          second.texture = {0.5F, 0.25F};
        }
        std::array<MeshVertex, 3> other = {second, first, random_vertex(t, t.random_int(0, level), pair)};
        if ((a + b) % 2 != 0)
          std::swap(other[0], other[1]);  // the ends in the same order, so that the orientation in space is reversed
        add_triangle(pairs.there, other, static_cast<std::size_t>(t.random_int(0, 2)));
        pairs.depths.push_back(reference::edge_depth(a, b));
      }
  return pairs;
}

// The vertices along the shared edge of each pair.
std::vector<std::set<Values>> edges_of(const std::vector<Values>& vertices, std::size_t count, bool positions_only) {
  std::vector<std::set<Values>> edges(count);
  for (Values values : vertices) {
    if (values[along_index] + values[along_index + 1] != 1.0F) continue;
    const auto pair = static_cast<std::size_t>(values[pair_index] + 0.5F);
    for (float& value : values) value += 0.0F;  // makes -0 equal to 0
    if (positions_only) std::fill(values.begin() + 4, values.begin() + along_index, 0.0F);
    values[pair_index] = 0;  // other values at the third corner matter only if there is a difference anyway
    if (pair < count) edges[pair].insert(values);
  }
  return edges;
}

void set_displacement() {
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  std::vector<GLubyte> texels(4 * 16 * 16);
  for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = static_cast<GLubyte>(i * 37 + i / 7);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.ARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, 0);
  gl.ARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, 0.3F);
}

void set_extra(const Variant& variant) {
  if (variant.extra == Extra::displacement) set_displacement();
  if (variant.extra == Extra::scalar_tags) {
    GLint attribute = 0;
    gl.GetIntegerv(GL_SCALAR_TAG_ATTRIBUTE_ARK, &attribute);
    gl.VertexAttrib4f(static_cast<GLuint>(attribute), 0.6F, 0.35F, -0.4F, 1);
  }
}

std::vector<Values> captured(Test& t, const Mesh& mesh) {
  upload(mesh);
  const auto count = static_cast<GLsizei>(mesh.size());
  return capture_as<Values>(t, 60000, [count] { gl.DrawArrays(GL_TRIANGLES, 0, count); });
}

void expect_same_edges(Test& t, const Pairs& pairs, const Variant& variant, bool has_tags, const std::string& what) {
  const bool positions_only = variant.extra == Extra::displacement || variant.extra == Extra::other_colours ||
                              variant.extra == Extra::scalar_tags;
  const auto here = edges_of(captured(t, pairs.here), pairs.depths.size(), positions_only);
  const auto there = edges_of(captured(t, pairs.there), pairs.depths.size(), positions_only);
  std::size_t different = 0;
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < here.size(); ++i) {
    different += here[i] == there[i] ? 0 : 1;
    wrong += !has_tags || here[i].size() == (std::size_t{1} << pairs.depths[i]) + 1 ? 0 : 1;
    if (!has_tags && here[i].size() < 2) ++wrong;
  }
  t.expect(different == 0,
           fmt::format("{}: {} of {} edges differ between their two triangles", what, different, here.size()));
  t.expect(wrong == 0, fmt::format("{}: {} edges have another number of vertices than 2^d + 1", what, wrong));
}

// One command for both triangles of each pair must give the same vertices as two commands.
void expect_one_command(Test& t, const Pairs& pairs, const Variant& variant) {
  if (variant.extra != Extra::none) return;
  Pairs joined = pairs;
  joined.here.clear();
  for (std::size_t i = 0; i < pairs.here.size(); i += 3) {
    const auto at = static_cast<std::ptrdiff_t>(i);
    joined.here.insert(joined.here.end(), pairs.here.begin() + at, pairs.here.begin() + at + 3);
    joined.here.insert(joined.here.end(), pairs.there.begin() + at, pairs.there.begin() + at + 3);
  }
  // If both triangles differed, an edge would have more vertices.
  expect_same_edges(t, joined, variant, true, "both triangles in one command");
}

void check_edges(Test& t, const Variant& variant, GLenum interior) {
  edge_program(t, variant);
  set_extra(variant);
  refine_by_tags(5, variant.refinement);
  gl.ARKParameteriARK(GL_PATTERN_INTERIOR_ARK, static_cast<GLint>(interior));
  const Pairs pairs = random_pairs(t, 5, variant);
  expect_same_edges(t, pairs, variant, true, "two commands");
  expect_one_command(t, pairs, variant);
}

void check_measured(Test& t, const Variant& variant, GLint pixels, GLint degrees) {
  edge_program(t, variant);
  refine_by_tags(5, variant.refinement);
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK);
  gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, pixels);
  gl.ARKParameteriARK(GL_EDGE_DEGREES_ARK, degrees);
  expect_same_edges(t, random_pairs(t, 3, variant), variant, false, "measured depths");
}

void check_uniform(Test& t, const Variant& variant) {
  edge_program(t, variant);
  set_extra(variant);
  Pairs pairs = random_pairs(t, 3, variant);
  std::fill(pairs.depths.begin(), pairs.depths.end(), 3);
  refine_uniformly(3, variant.refinement);
  expect_same_edges(t, pairs, variant, true, "uniform depth 3");
}

const std::vector<Variant>& variants() {
  static const std::vector<Variant> all = {
      {"linear_inputs", GL_LINEAR_INPUTS_ARK, Extra::none, {"11.R.8-1", "11.R.8-2", "11.R.8-3", "11.R.8-4"}},
      {"linear_outputs", GL_LINEAR_OUTPUTS_ARK, Extra::none, {"11.R.8-1", "11.R.8-2", "11.R.8-3", "11.R.8-4"}},
      {"curved_pn", GL_CURVED_PN_ARK, Extra::none, {"11.R.8-3", "11.R.8-4"}},
      {"curved_pn_other_inputs", GL_CURVED_PN_ARK, Extra::other_colours, {"11.R.8-6"}},
      {"scalar_tagged_pn", GL_SCALAR_TAGGED_PN_ARK, Extra::scalar_tags, {"11.R.8-7"}},
      {"phong", GL_PHONG_ARK, Extra::none, {"11.R.8-3", "11.R.8-4"}},
      {"phong_other_inputs", GL_PHONG_ARK, Extra::other_colours, {"11.R.8-6"}},
      {"displaced_phong", GL_PHONG_ARK, Extra::displacement, {"11.R.8-10"}},
      {"displaced", GL_LINEAR_INPUTS_ARK, Extra::displacement, {"11.R.8-10"}},
      {"displaced_pn", GL_CURVED_PN_ARK, Extra::displacement, {"11.R.8-10"}},
      {"refinement_shader", GL_LINEAR_INPUTS_ARK, Extra::refinement_shader, {"11.R.8-9"}},
      {"refinement_shader_pn", GL_CURVED_PN_ARK, Extra::refinement_shader, {"11.R.8-9"}}};
  return all;
}

}  // namespace

Cases shared_edges_cases() {
  const std::string wrong =
      "Last bits differ because weights or products follow the order of the corners; another number of vertices.";
  Cases cases;
  for (const Variant& variant : variants()) {
    for (const GLenum interior : {GL_MINIMUM_INTERIOR_ARK, GL_SMOOTH_INTERIOR_ARK})
      cases.push_back({.name = std::string("ark.edges.") + variant.name +
                               (interior == GL_SMOOTH_INTERIOR_ARK ? ".smooth" : ".minimum"),
                       .clauses = variant.clauses,
                       .plan = "Capture 108 pairs of random triangles with a common edge, with all pairs of tags at "
                               "its ends and rotated corners; compare all bits along the edge.",
                       .wrong = wrong,
                       .check = [&variant, interior](Test& t) { check_edges(t, variant, interior); }});
    cases.push_back({.name = std::string("ark.edges.") + variant.name + ".uniform",
                     .clauses = variant.clauses,
                     .plan = "The same at uniform depth 3.",
                     .wrong = wrong,
                     .check = [&variant](Test& t) { check_uniform(t, variant); }});
  }
  struct Measure {
    const char* name;
    GLint pixels;
    GLint degrees;
  };
  for (const Measure& measure : {Measure{"pixels", 4, 0}, Measure{"degrees", 0, 3}, Measure{"both", 6, 2}})
    cases.push_back(
        {.name = std::string("ark.edges.measured.") + measure.name,
         .clauses = {"11.R.4-27", "11.R.8-3"},
         .plan = "The same with measured depths, the ends in either order and in two commands.",
         .wrong = "The depth depends on the order of the ends: another number of vertices.",
         .check = [measure](Test& t) { check_measured(t, variants()[0], measure.pixels, measure.degrees); }});
  return cases;
}

}  // namespace glark::conformance
