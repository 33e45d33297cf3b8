// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// WELD_ARK (11.R.15): instances, creases, and one angle for all sides of an edge.
#include <fmt/core.h>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "conformance/cases/cases.h"
#include "conformance/support/refined_draw.h"
#include "conformance/support/surface.h"

namespace glark::conformance {
namespace {

// Instances of one triangle. Each has its own tag: 0, 2 and 1.
void check_instances(Test& t, bool by_attribute) {
  gl.UseProgram(build_program(
      t, {.vertex = std::string("layout(location = 0) in vec4 position; layout(location = 7) in vec4 shift;\n"
                                "out vec4 colour; void main() { colour = vec4(1.0); gl_Position = position + ") +
                    (by_attribute ? "shift" : "vec4(0.1 * float(gl_InstanceID), 0.0, 0.0, 0.0)") + "; }\n",
          .captured = {"gl_Position"}}));
  upload(one_triangle(), false);
  const float tags[] = {0, 2, 1};
  const float shifts[] = {0, 0.1F, 0.2F};
  GLint tag = 0;
  gl.GetIntegerv(GL_DEPTH_TAG_ATTRIBUTE_ARK, &tag);
  for (const auto& [index, values] : {std::pair<GLuint, const float*>{static_cast<GLuint>(tag), tags}, {7, shifts}}) {
    GLuint buffer = 0;
    gl.GenBuffers(1, &buffer);
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
    gl.BufferData(GL_ARRAY_BUFFER, sizeof(tags), values, GL_STATIC_DRAW);
    gl.VertexAttribPointer(index, 1, GL_FLOAT, GL_FALSE, 0, nullptr);
    gl.EnableVertexAttribArray(index);
    gl.VertexAttribDivisor(index, 1);
  }
  refine_by_tags(3);
  gl.ARKParameteriARK(GL_WELD_ARK, GL_TRUE);
  const auto vertices = capture_as<Vec4>(t, 1000, [] { gl.DrawArraysInstanced(GL_TRIANGLES, 0, 3, 3); });
  t.expect_equal(vertices.size() / 3, std::size_t{1 + 16 + 4}, "triangles of instances with the tags 0, 2 and 1");
}

// The words of the attributes of one instance: vec4, ivec4, uvec2, mat3x2, further vec4 at all locations that are left, and
// dvec2 unless in OpenGL ES.
constexpr std::size_t float_words = 4;
constexpr std::size_t integer_words = 6;
constexpr std::size_t matrix_words = 6;
constexpr std::array<GLuint, 6> further_locations = {1, 2, 3, 7, 14, 15};
constexpr std::size_t further_words = 4 * further_locations.size();
constexpr std::size_t double_words = 4;
using InstanceWords = std::array<GLuint, float_words + integer_words + matrix_words + further_words + double_words>;

// The gl_Position of an instance depends on none of them, so that positions cannot tell instances apart. The vertex
// stage reads them all.
GLuint program_of_instances(Test& t) {
  const bool has_doubles = !t.is_gles();
  std::string further, sum;
  for (const GLuint location : further_locations) {
    further += fmt::format("layout(location = {0}) in vec4 further{0};\n", location);
    sum += fmt::format(" + further{}", location);
  }
  return build_program(
      t, {.vertex = std::string("layout(location = 0) in vec4 position; layout(location = 4) in vec4 floats;\n"
                                "layout(location = 5) in ivec4 integers; layout(location = 6) in uvec2 naturals;\n"
                                "layout(location = 8) in mat3x2 matrix;\n") +
                    further + (has_doubles ? "layout(location = 11) in dvec2 doubles;\n" : "") +
                    "out vec4 colour; out vec4 instance;\n"
                    "void main() { gl_Position = position; colour = vec4(1.0);\n"
                    "  instance = floats + vec4(integers) + vec4(naturals, matrix[0] + matrix[1] + matrix[2])" +
                    sum + (has_doubles ? " + vec4(doubles.xyxy)" : "") + "; }\n",
          .captured = {"gl_Position", "instance"}});
}

void upload_instances(Test& t, const std::array<InstanceWords, 2>& instances) {
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, sizeof(instances), instances.data(), GL_STATIC_DRAW);
  constexpr GLsizei stride = sizeof(InstanceWords);
  const auto at = [](std::size_t word) { return reinterpret_cast<const void*>(word * sizeof(GLuint)); };
  gl.VertexAttribPointer(4, 4, GL_FLOAT, GL_FALSE, stride, at(0));
  gl.VertexAttribIPointer(5, 4, GL_INT, stride, at(float_words));
  gl.VertexAttribIPointer(6, 2, GL_UNSIGNED_INT, stride, at(float_words + 4));
  for (GLuint column = 0; column < 3; ++column)
    gl.VertexAttribPointer(8 + column, 2, GL_FLOAT, GL_FALSE, stride,
                           at(float_words + integer_words + std::size_t{2} * column));
  std::vector<GLuint> locations{4, 5, 6, 8, 9, 10};
  std::size_t word = float_words + integer_words + matrix_words;
  for (const GLuint location : further_locations) {
    gl.VertexAttribPointer(location, 4, GL_FLOAT, GL_FALSE, stride, at(word));
    locations.push_back(location);
    word += 4;
  }
  if (!t.is_gles()) {
    gl.VertexAttribLPointer(11, 2, GL_DOUBLE, stride, at(word));
    locations.push_back(11);
  }
  for (const GLuint location : locations) {
    gl.EnableVertexAttribArray(location);
    gl.VertexAttribDivisor(location, 1);
  }
}

// Two instances with the same positions have tags 0 and 3, and differ in one word of what the vertex stage reads.
void check_instance_words(Test& t) {
  gl.UseProgram(program_of_instances(t));
  upload(one_triangle(), false);
  const float tags[] = {0, 3};
  gl.ARKParameteriARK(GL_DEPTH_TAG_ATTRIBUTE_ARK, 13);
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, sizeof(tags), tags, GL_STATIC_DRAW);
  gl.VertexAttribPointer(13, 1, GL_FLOAT, GL_FALSE, 0, nullptr);
  gl.EnableVertexAttribArray(13);
  gl.VertexAttribDivisor(13, 1);
  refine_by_tags(3);
  gl.ARKParameteriARK(GL_WELD_ARK, GL_TRUE);
  const auto count = [&t] {
    return capture_as<std::array<Vec4, 2>>(t, 1000, [] { gl.DrawArraysInstanced(GL_TRIANGLES, 0, 3, 2); }).size() / 3;
  };
  InstanceWords same{};
  for (std::size_t i = 0; i < same.size(); ++i) same[i] = std::bit_cast<GLuint>(1 + 0.25F * static_cast<float>(i));
  for (std::size_t i = 0; i < same.size() - (t.is_gles() ? double_words : 0); ++i) {
    InstanceWords other = same;
    other[i] ^= 0x8000U;
    upload_instances(t, {same, other});
    t.expect_equal(count(), std::size_t{1 + 64}, fmt::format("triangles of instances that differ in word {}", i));
  }
  t.expect_no_error("the draws");
}

// The attribute advances once an instance: two instances have these values.
void upload_two(GLuint index, const std::array<Vec3, 2>& values) {
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, sizeof(values), values.data(), GL_STATIC_DRAW);
  gl.VertexAttribPointer(index, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  gl.EnableVertexAttribArray(index);
  gl.VertexAttribDivisor(index, 1);
}

// Two instances of one mesh differ only in their normals: each is drawn as if the other did not exist.
void expect_normals_apart(Test& t, const std::array<Vec3, 2>& normals, const std::string& what) {
  upload_two(at_normal, normals);
  std::array<std::vector<SurfaceVertex>, 2> both;
  for (const bool is_welded : {false, true}) {
    gl.ARKParameteriARK(GL_WELD_ARK, is_welded ? GL_TRUE : GL_FALSE);
    both[is_welded ? 1 : 0] =
        capture_as<SurfaceVertex>(t, 20000, [] { gl.DrawArraysInstanced(GL_TRIANGLES, 0, 3, 2); });
  }
  t.expect_equal(both[0].size(), std::size_t{2 * 3 * 64}, "vertices of two instances");
  t.require(both[0].size() == both[1].size(), "as many with WELD_ARK");
  double bulge = 0;
  for (std::size_t i = 0; i < both[0].size(); ++i) {
    bulge = std::max(bulge, static_cast<double>(std::abs(both[0][i].position[2])));
    for (std::size_t k = 0; k < 3; ++k)
      if (!t.expect_near(both[1][i].position[k], both[0][i].position[k], 2e-6,
                         what + ": instances that differ in an attribute are not welded to each other"))
        return;
  }
  t.expect(bulge > 0.01, "the normals bend the triangle");
}

void check_instanced_normals(Test& t) {
  gl.UseProgram(surface_program(t));
  upload(one_triangle());
  refine_uniformly(3, GL_CURVED_PN_ARK);
  const Vec3 normal = {0.8F, 0.1F, 0.6F};
  expect_normals_apart(t, {normal, Vec3{-0.5F, 0.7F, 0.4F}}, "all components");
  for (std::size_t k = 0; k < 3; ++k) {
    Vec3 other = normal;
    other[k] = -0.5F;
    expect_normals_apart(t, {normal, other}, fmt::format("component {}", k));
  }
}

// A sharp edge with two tagged ends has the control points that it has without WELD_ARK.
void check_crease(Test& t) {
  const Mesh mesh = bent_mesh();
  ShapeTags tags;
  tags.discontinuities.assign(6, Vec4{0, 0, 0, 1});
  tags.scalars.assign(6, Vec3{0.75F, 0.25F, 0.5F});
  tags.discontinuities[0] = tags.discontinuities[5] = {0.25F, -0.5F, 0.125F, 3};
  tags.discontinuities[2] = tags.discontinuities[3] = {-0.125F, 0.25F, 0.5F, 3};
  gl.UseProgram(surface_program(t));
  upload(mesh);
  upload_shape_tags(tags);
  refine_uniformly(3, GL_SCALAR_TAGGED_PN_ARK);
  gl.ARKParameteriARK(GL_WELD_ARK, GL_TRUE);
  const auto vertices = capture_surface(t, mesh);
  expect_surface(t, vertices, mesh, tags, reference::scalar_tagged_pn, 5e-6);
  std::array<std::vector<Vec4>, 2> sides = {std::vector<Vec4>(9), std::vector<Vec4>(9)};
  for (const SurfaceVertex& vertex : vertices) {
    const bool is_second = vertex.triangle >= 1;
    if (vertex.weights[1] == 0)
      sides[is_second ? 1 : 0][static_cast<std::size_t>(std::lround(8 * vertex.weights[is_second ? 0 : 2]))] =
          vertex.position;
  }
  for (std::size_t i = 0; i < 9; ++i)
    t.expect(same_position(sides[0][i], sides[1][i]), "both sides of a crease are the same, by bits");
}

constexpr std::size_t many_pairs = 150;

// Pairs of triangles with a common edge: vertices 0 and 5 are at one place, and so are 2 and 3. Different pairs have no
// place in common.
Mesh pairs() {
  Mesh mesh;
  for (std::size_t pair = 0; pair < many_pairs; ++pair)
    for (MeshVertex vertex : bent_mesh()) {
      vertex.position[0] += static_cast<float>(2 * pair);
      mesh.push_back(vertex);
    }
  number_triangles(mesh);
  return mesh;
}

constexpr std::array<std::size_t, 6> same_place = {5, 1, 3, 2, 4, 0};

void check_many_tags(Test& t) {
  gl.UseProgram(capture_program(t));
  Mesh mesh = pairs();
  for (MeshVertex& vertex : mesh) vertex.tag = static_cast<float>(t.random_int(0, 4));
  upload(mesh);
  refine_by_tags(4);
  gl.ARKParameteriARK(GL_WELD_ARK, GL_TRUE);
  const auto count = static_cast<GLsizei>(mesh.size());
  const auto found = depths_of(t, 2 * many_pairs, [count] { gl.DrawArrays(GL_TRIANGLES, 0, count); });
  t.require(found.size() == 2 * many_pairs, "all triangles are drawn");
  for (std::size_t triangle = 0; triangle < found.size(); ++triangle) {
    std::array<int, 3> tags{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t first = triangle / 2 * 6;
      const std::size_t vertex = triangle % 2 * 3 + k;
      const float greatest = std::max(mesh[first + vertex].tag, mesh[first + same_place[vertex]].tag);
      tags[k] = static_cast<int>(greatest);
    }
    const reference::Depths expected = reference::edge_depths(tags);
    if (!t.expect(found[triangle] == expected, fmt::format("triangle {} has depths {}, not {}", triangle,
                                                           text_of(found[triangle]), text_of(expected))))
      return;
  }
}

// Every other pair has different normals on the second side of its ridge.
void check_many_ridges(Test& t) {
  gl.UseProgram(surface_program(t));
  Mesh mesh = pairs();
  for (std::size_t pair = 0; pair < many_pairs; pair += 2) {
    mesh[6 * pair + 5].normal = {-0.9F, 0.4F, 0.3F};
    mesh[6 * pair + 3].normal = {0.2F, -0.9F, 0.7F};
  }
  upload(mesh);
  refine_uniformly(2, GL_CURVED_PN_ARK);
  gl.ARKParameteriARK(GL_WELD_ARK, GL_TRUE);
  const auto count = static_cast<GLsizei>(mesh.size());
  const auto vertices = capture_as<SurfaceVertex>(t, 20000, [count] { gl.DrawArrays(GL_TRIANGLES, 0, count); });
  std::array<std::vector<std::array<Vec4, 5>>, 2> sides;
  for (auto& side : sides) side.resize(many_pairs);
  for (const SurfaceVertex& vertex : vertices) {
    if (vertex.weights[1] != 0) continue;
    const auto triangle = static_cast<std::size_t>(std::lround(vertex.triangle));
    t.require(triangle < 2 * many_pairs, "every refined vertex belongs to a coarse triangle");
    const float along = vertex.weights[triangle % 2 == 1 ? 0 : 2];
    sides[triangle % 2][triangle / 2][static_cast<std::size_t>(std::lround(4 * along))] = vertex.position;
  }
  for (std::size_t pair = 0; pair < many_pairs; ++pair)
    for (std::size_t i = 0; i < 5; ++i)
      if (!t.expect(same_position(sides[0][pair][i], sides[1][pair][i]),
                    fmt::format("both sides of ridge {} are the same, by bits", pair)))
        return;
}

Vec3 turned(double degrees) {
  const double angle = degrees * std::acos(-1.0) / 180;
  return {static_cast<float>(std::sin(angle)), 0, static_cast<float>(std::cos(angle))};
}

// One side turns by 5 degrees, the other by 35. At 10 degrees a level, the depths are 0 and 2.
void check_turns(Test& t, GLenum refinement) {
  gl.UseProgram(surface_program(t));
  Mesh mesh = bent_mesh();
  for (MeshVertex& vertex : mesh) vertex.normal = turned(0);
  mesh[2].normal = turned(5);
  mesh[3].normal = turned(35);
  upload(mesh);
  refine_by_tags(4, refinement);
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK);
  gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, 0);
  gl.ARKParameteriARK(GL_EDGE_DEGREES_ARK, 10);
  for (const bool is_welded : {false, true}) {
    gl.ARKParameteriARK(GL_WELD_ARK, is_welded ? GL_TRUE : GL_FALSE);
    std::array<std::set<float>, 2> sides;
    for (const SurfaceVertex& vertex : capture_surface(t, mesh))
      if (vertex.weights[1] == 0) sides[vertex.triangle >= 1 ? 1 : 0].insert(vertex.weights[0]);
    const std::string what = is_welded ? "welded, vertices on the side that turns by " : "vertices on the side of ";
    t.expect_equal(sides[0].size(), is_welded ? 5U : 2U, what + "5 degrees");
    t.expect_equal(sides[1].size(), 5U, what + "35 degrees");
  }
}

}  // namespace

Cases welded_sides_cases() {
  Cases cases;
  for (const bool by_attribute : {false, true})
    cases.push_back({.name = std::string("ark.weld.instances.") + (by_attribute ? "attribute" : "number"),
                     .clauses = {"11.R.15-5"},
                     .plan = "Three instances of one triangle, each with its own tag.",
                     .wrong = "The greatest tag of all instances, as if they were at one place.",
                     .check = [by_attribute](Test& t) { check_instances(t, by_attribute); }});
  cases.push_back({.name = "ark.weld.instances.words",
                   .clauses = {"11.R.15-5"},
                   .plan =
                       "Two instances with tags of 0 and 3 differ in one word of one attribute: floats, integers, a "
                       "matrix, doubles.",
                   .wrong = "Only the first component of an attribute, or the first attribute, tells instances apart.",
                   .check = check_instance_words});
  cases.push_back({.name = "ark.weld.instances.normals",
                   .clauses = {"11.R.15-5"},
                   .plan = "Two instances of one triangle, whose normals differ in all components or in one: WELD_ARK "
                           "changes nothing.",
                   .wrong = "The edges of one instance have the other's normals as a second side.",
                   .check = check_instanced_normals});
  cases.push_back({.name = "ark.weld.many.tags",
                   .clauses = {"11.R.15-6"},
                   .plan = "Three hundred triangles in pairs, with random tags: the greatest tag of each place counts.",
                   .wrong = "Only the first triangles of a large draw are welded.",
                   .check = check_many_tags});
  cases.push_back({.name = "ark.weld.many.ridges",
                   .clauses = {"11.R.15-7", "11.R.15-9"},
                   .plan = "A hundred and fifty pairs of triangles; every other pair has a hard edge in common.",
                   .wrong = "Only the first triangles of a large draw are welded: the others crack.",
                   .check = check_many_ridges});
  cases.push_back({.name = "ark.weld.tagged.crease",
                   .clauses = {"11.R.15-16"},
                   .plan = "Two triangles along a crease: their surfaces are those without WELD_ARK, and are the same "
                           "along it by bits.",
                   .wrong = "Tagged corners are welded too, and lose their crease.",
                   .check = check_crease});
  for (const auto& [leaf, refinement] : {std::pair<const char*, GLenum>{"linear", GL_LINEAR_INPUTS_ARK},
                                         {"outputs", GL_LINEAR_OUTPUTS_ARK},
                                         {"curved", GL_CURVED_PN_ARK},
                                         {"tagged", GL_SCALAR_TAGGED_PN_ARK}})
    cases.push_back({.name = std::string("ark.weld.measured_turns.") + leaf,
                     .clauses = {"11.R.15-37", "11.R.15-18"},
                     .plan = "Two sides of an edge whose normals turn by 5 and by 35 degrees have the greater depth.",
                     .wrong = "Each side has its own depth: a T-junction; the lesser depth.",
                     .check = [mode = refinement](Test& t) { check_turns(t, mode); }});
  return cases;
}

}  // namespace glark::conformance
