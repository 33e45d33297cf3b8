// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// How a draw is split into coarse triangles (11.R.3): the order of corners, the provoking corner, the split at
// centroids.
#include <fmt/core.h>
#include <functional>
#include <numeric>
#include <utility>

#include "conformance/cases/cases.h"
#include "conformance/cases/triangle_modes.h"
#include "conformance/support/refined_draw.h"

namespace glark::conformance {
namespace {

// A convex polygon, counter-clockwise about the origin. Coordinates are sixteenths.
Mesh polygon() {
  const Vec2 places[] = {{-0.875F, -0.25F}, {-0.5F, -0.75F}, {0.125F, -0.875F}, {0.625F, -0.625F},
                         {0.875F, 0.0F},    {0.75F, 0.5F},   {0.25F, 0.8125F},  {-0.5F, 0.625F}};
  Mesh mesh(8);
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    mesh[i].position = {places[i][0], places[i][1], 0, 1};
    mesh[i].colour = {static_cast<float>(i) / 8, 1 - static_cast<float>(i) / 16, static_cast<float>(i % 3) / 2, 1};
    mesh[i].tag = static_cast<float>((i * 3 + 1) % 5);
  }
  return mesh;
}

// Two rows of vertices, for strips.
Mesh ladder() {
  Mesh mesh = polygon();
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const std::size_t pair = i / 2;
    const auto n = static_cast<float>(pair);
    mesh[i].position = {-0.75F + 0.5F * n + (i % 2 == 0 ? 0.0F : 0.0625F), i % 2 == 0 ? 0.5F + n / 16 : -0.5F - n / 8,
                        0, 1};
  }
  return mesh;
}

Mesh mesh_for(GLenum mode) { return mode == GL_TRIANGLE_STRIP || mode == GL_QUAD_STRIP ? ladder() : polygon(); }

// Sums of these values are rounded, so another order of corners gives other bits.
void check_corner_order(Test& t, GLenum mode) {
  use_readable_tags();
  gl.UseProgram(draw_program(t));
  Mesh mesh = mesh_for(mode);
  for (MeshVertex& vertex : mesh) {
    for (float& value : vertex.position) value += t.random_float(-0.05F, 0.05F);
    for (float& value : vertex.colour) value = t.random_float(0, 1);
  }
  upload(mesh);
  refine_uniformly(3);
  const auto draw = [mode] { gl.DrawArrays(mode, 0, 8); };
  expect_refined(t, {.uniform_level = 3}, draw, "uniform depth 3");
  refine_by_tags(4);
  expect_refined(t, {.pool_level = 4}, draw, "tags");
}

Picture flat_picture(GLenum mode) {
  clear_surface();
  gl.DrawArrays(mode, 0, 8);
  return read_picture(surface_size, surface_size);
}

GLuint flat_program(Test& t) {
  return build_program(t,
                       {.vertex = "layout(location = 0) in vec4 position; layout(location = 3) in vec4 vertex_colour;\n"
                                  "flat out vec4 colour;\n"
                                  "void main() { colour = vertex_colour; gl_Position = position; }\n",
                        .fragment = "flat in vec4 colour; out vec4 pixel; void main() { pixel = colour; }"});
}

void set_convention(const Test& t, bool is_first) {
  if (!t.is_gles()) gl.ProvokingVertex(is_first ? GL_FIRST_VERTEX_CONVENTION : GL_LAST_VERTEX_CONVENTION);
}

void check_provoking(Test& t, GLenum mode, bool is_first) {
  gl.UseProgram(flat_program(t));
  upload(mesh_for(mode));
  set_convention(t, is_first);
  const Picture plain = flat_picture(mode);
  refine_uniformly(2);
  t.expect_same_picture(flat_picture(mode), plain, "flat colours at uniform depth 2", 1, 60);
  refine_by_tags(4);
  t.expect_same_picture(flat_picture(mode), plain, "flat colours by tags", 1, 60);
}

// Without refinement the two conventions differ, so pictures can tell them apart.
void control_provoking(Test& t) {
  if (t.is_gles()) return t.expect(true, "one convention"), void();
  gl.UseProgram(flat_program(t));
  upload(polygon(), false);
  set_convention(t, true);
  const Picture first = flat_picture(GL_TRIANGLE_FAN);
  set_convention(t, false);
  t.expect(count_different(first, flat_picture(GL_TRIANGLE_FAN), 4) > 1000, "the conventions differ");
}

// The vertices of each primitive, in the order of its boundary.
std::vector<std::vector<std::size_t>> boundaries(GLenum mode, std::size_t count) {
  std::vector<std::vector<std::size_t>> all;
  if (mode == GL_POLYGON) {
    all.emplace_back(count);
    std::iota(all[0].begin(), all[0].end(), 0);
  }
  for (std::size_t i = 0; mode == GL_QUADS && i + 3 < count; i += 4) all.push_back({i, i + 1, i + 2, i + 3});
  for (std::size_t i = 0; mode == GL_QUAD_STRIP && i + 3 < count; i += 2) all.push_back({i, i + 1, i + 3, i + 2});
  return all;
}

DrawVertex draw_vertex(const MeshVertex& from) { return {from.position, from.colour, from.tag, 0}; }

using Divide = std::function<float(float, float)>;

float exact_quotient(float sum, float count) { return sum / count; }

DrawVertex centroid_of(const Mesh& mesh, const std::vector<std::size_t>& boundary, const Divide& divide) {
  std::array<float, sizeof(DrawVertex) / sizeof(float)> sum{};
  for (const std::size_t i : boundary) {
    const DrawVertex vertex = draw_vertex(mesh[i]);
    std::array<float, sum.size()> values{};
    std::memcpy(values.data(), &vertex, sizeof(vertex));
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += values[k];
  }
  for (float& value : sum) value = divide(value, static_cast<float>(boundary.size()));
  DrawVertex centroid{};
  std::memcpy(&centroid, sum.data(), sizeof(centroid));
  return centroid;
}

// n triangles about each centroid. The edges that meet there have the mean depth, rounded down.
std::vector<CoarseTriangle> split(const Mesh& mesh, GLenum mode, std::size_t count, int pool_level,
                                  const Divide& divide = exact_quotient) {
  std::vector<CoarseTriangle> triangles;
  for (const auto& boundary : boundaries(mode, count)) {
    std::vector<int> depths;
    for (std::size_t k = 0; k < boundary.size(); ++k)
      depths.push_back(
          reference::edge_depth(reference::depth_tag(mesh[boundary[k]].tag, pool_level),
                                reference::depth_tag(mesh[boundary[(k + 1) % boundary.size()]].tag, pool_level)));
    const int face = std::accumulate(depths.begin(), depths.end(), 0) / static_cast<int>(boundary.size());
    const DrawVertex centroid = centroid_of(mesh, boundary, divide);
    for (std::size_t k = 0; k < boundary.size(); ++k)
      triangles.push_back(
          {{draw_vertex(mesh[boundary[k]]), draw_vertex(mesh[boundary[(k + 1) % boundary.size()]]), centroid},
           {depths[k], face, face}});
  }
  return triangles;
}

void split_at_centroids(GLuint pool_level) {
  refine_by_tags(pool_level);
  gl.ARKParameteriARK(GL_POLYGON_SPLIT_ARK, GL_POLYGON_CENTROID_ARK);
}

void check_centroid(Test& t, GLenum mode) {
  use_readable_tags();
  gl.UseProgram(draw_program(t));
  Mesh mesh = mesh_for(mode);
  upload(mesh);
  split_at_centroids(4);
  expect_triangles(
      t, split(mesh, mode, 8, 4), [mode] { gl.DrawArrays(mode, 0, 8); }, "eight vertices, by tags");
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 1);
  auto uniform = split(mesh, mode, 8, 4);
  for (CoarseTriangle& triangle : uniform) triangle.depths = {1, 1, 1};
  expect_triangles(
      t, uniform, [mode] { gl.DrawArrays(mode, 0, 8); }, "eight vertices, uniformly");
}

// A division by the GL: the shading language lets quotients differ in their last bits.
Divide quotient_of_gl(Test& t) {
  constexpr GLuint at_sum = 1;
  constexpr GLuint at_count = 2;
  const GLuint program = build_program(
      t, {.vertex = "layout(location = 1) in float sum; layout(location = 2) in float count; out float quotient;\n"
                    "out vec4 colour;\n"
                    "void main() { quotient = sum / count; colour = vec4(quotient); gl_Position = vec4(0.0); }\n",
          .captured = {"quotient"}});
  GLuint array = 0;
  gl.GenVertexArrays(1, &array);
  return [&t, program, array](float sum, float count) {
    gl.UseProgram(program);
    gl.BindVertexArray(array);
    gl.VertexAttrib1f(at_sum, sum);
    gl.VertexAttrib1f(at_count, count);
    const auto captured = capture_as<float>(
        t, 2, [] { gl.DrawArrays(GL_POINTS, 0, 1); }, GL_POINTS);
    t.require(captured.size() == 1, "the quotient is captured");
    return captured[0];
  };
}

// No sum or quotient of these values is exact. The last bits show the order of the sum, the division, and the place of
// the centroid among the corners.
void check_centroid_bits(Test& t, GLenum mode, std::size_t count) {
  use_readable_tags();
  const Divide divide = quotient_of_gl(t);
  const GLuint program = draw_program(t);
  for (int round = 0; round < 4; ++round) {
    Mesh mesh = mode == GL_POLYGON ? polygon() : mesh_for(mode);
    for (MeshVertex& vertex : mesh) {
      for (std::size_t k = 0; k < 2; ++k) vertex.position[k] += t.random_float(-0.02F, 0.02F);
      vertex.position[2] = t.random_float(-0.9F, 0.9F);
      for (float& channel : vertex.colour) channel = t.random_float(0, 1);
      vertex.tag = static_cast<float>(t.random_int(0, 3));
    }
    const auto expected = split(mesh, mode, count, 4, divide);
    gl.UseProgram(program);
    upload(mesh);
    split_at_centroids(4);
    expect_triangles(
        t, expected, [=] { gl.DrawArrays(mode, 0, static_cast<GLsizei>(count)); }, fmt::format("{} vertices", count));
  }
}

// Edges that differ much from the face depth: triples that vertex tags alone do not give.
void check_steep_depths(Test& t) {
  use_readable_tags();
  gl.UseProgram(draw_program(t));
  Mesh mesh = polygon();
  const float tags[] = {6, 6, 0, 0, 0, 0, 0, 1};
  for (std::size_t i = 0; i < 8; ++i) mesh[i].tag = tags[i];
  upload(mesh);
  split_at_centroids(6);
  expect_triangles(
      t, split(mesh, GL_POLYGON, 8, 6), [] { gl.DrawArrays(GL_POLYGON, 0, 8); }, "one deep edge");
  expect_triangles(
      t, split(mesh, GL_QUADS, 8, 6), [] { gl.DrawArrays(GL_QUADS, 0, 8); }, "two quadrilaterals");
}

// How many triangles `draw` has at uniform depth 1, with a program that may not be split: 4 for each coarse triangle.
std::size_t count_at_one(Test& t, const std::function<void()>& draw) {
  refine_uniformly(1);
  gl.ARKParameteriARK(GL_POLYGON_SPLIT_ARK, GL_POLYGON_CENTROID_ARK);
  return capture_bytes(t, 16, 3, 1000, GL_TRIANGLES, draw).size() / (3 * 16 * 4);
}

void check_program(Test& t, const char* declarations, const char* body, bool is_split) {
  const GLuint program = build_program(
      t, {.vertex = std::string("layout(location = 0) in vec4 position; out vec4 colour; ") + declarations +
                    "\nvoid main() { colour = vec4(1.0); gl_Position = position; " + body + " }\n",
          .captured = {"gl_Position"}});
  gl.UseProgram(program);
  upload(polygon());
  const std::size_t count = count_at_one(t, [] { gl.DrawArrays(GL_QUADS, 0, 8); });
  t.expect_equal(count, is_split ? 8U : 4U, "coarse triangles of two quadrilaterals");
}

void check_restart(Test& t) {
  gl.UseProgram(capture_program(t));
  upload(polygon());
  const GLubyte indices[] = {0, 1, 2, 3, 255, 3, 4, 5, 6, 7};
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof(indices), indices, GL_STATIC_DRAW);
  gl.Enable(GL_PRIMITIVE_RESTART);
  gl.PrimitiveRestartIndex(255);
  refine_uniformly(1);
  gl.ARKParameteriARK(GL_POLYGON_SPLIT_ARK, GL_POLYGON_CENTROID_ARK);
  const auto count = [&](GLenum mode, GLsizei first, GLsizei vertices) {
    return capture(t,
                   [=] {
                     gl.DrawElements(mode, vertices, GL_UNSIGNED_BYTE,
                                     reinterpret_cast<const void*>(std::intptr_t{first}));
                   })
               .size() /
           12;
  };
  t.expect_equal(count(GL_POLYGON, 0, 10), 5U, "coarse triangles of two polygons with restart");
  t.expect_equal(count(GL_POLYGON, 5, 5), 3U, "coarse triangles of one polygon while restart is enabled");
  t.expect_equal(count(GL_QUADS, 5, 4), 4U, "a quadrilateral is split while restart is enabled");
  gl.Disable(GL_PRIMITIVE_RESTART);
  t.expect_equal(count(GL_POLYGON, 5, 5), 5U, "coarse triangles of one polygon without restart");
}

void check_flat_shading(Test& t) {
  refine_uniformly(1);
  gl.ARKParameteriARK(GL_POLYGON_SPLIT_ARK, GL_POLYGON_CENTROID_ARK);
  for (const GLenum model : {GL_SMOOTH, GL_FLAT}) {
    gl.ShadeModel(model);
    GLuint query = 0;
    GLuint count = 0;
    gl.GenQueries(1, &query);
    gl.BeginQuery(GL_PRIMITIVES_GENERATED, query);
    gl.Begin(GL_QUADS);
    for (const MeshVertex& vertex : polygon()) gl.Vertex2f(vertex.position[0], vertex.position[1]);
    gl.End();
    gl.EndQuery(GL_PRIMITIVES_GENERATED);
    gl.GetQueryObjectuiv(query, GL_QUERY_RESULT, &count);
    gl.DeleteQueries(1, &query);
    t.expect_equal(count, model == GL_FLAT ? 16U : 32U, "refined triangles of two quadrilaterals");
  }
}

void check_triangles_stay(Test& t, GLenum mode) {
  use_readable_tags();
  gl.UseProgram(draw_program(t));
  upload(mesh_for(mode));
  split_at_centroids(4);
  expect_refined(
      t, {.pool_level = 4}, [mode] { gl.DrawArrays(mode, 0, 8); }, "POLYGON_CENTROID_ARK");
}

Cases exception_cases() {
  struct Exception {
    const char* leaf;
    const char* declarations;
    const char* body;
    bool is_split;
  };
  const Exception all[] = {
      {"integer_input", "layout(location = 6) in int number;", "gl_Position.z = float(number & 1);", false},
      {"vertex_id", "", "gl_Position.z = float(gl_VertexID & 1);", false},
      {"integer_output", "flat out int number;", "number = 3;", false},
      {"flat_output", "flat out vec2 value;", "value = vec2(1.0);", false},
      {"instance_id", "", "gl_Position.z = float(gl_InstanceID);", true},
      {"plain", "", "", true}};
  Cases cases;
  for (const Exception& each : all)
    cases.push_back({.name = std::string("ark.coarse.centroid.program.") + each.leaf,
                     .clauses = {"11.R.3-9", "11.R.3-12"},
                     .plan = "Count the triangles of two quadrilaterals with such a vertex stage at uniform depth 1.",
                     .wrong = "Twice as many triangles, or half as many.",
                     .apis = compat_only,
                     .check = [each](Test& t) { check_program(t, each.declarations, each.body, each.is_split); }});
  return cases;
}

}  // namespace

Cases coarse_triangles_cases() {
  Cases cases = exception_cases();
  for (const TriangleMode& mode : triangle_modes) {
    const std::string name = mode.name;
    cases.push_back({.name = "ark.coarse.corners." + name,
                     .clauses = {"11.R.3-2"},
                     .plan = "Refine values whose sums are rounded, and compare all bits with those in the order of "
                             "transform feedback.",
                     .wrong = "Corners in another order: some vertices differ in the last bit.",
                     .apis = mode.is_legacy ? compat_only : desktop_apis,
                     .check = [mode](Test& t) { check_corner_order(t, mode.mode); }});
    for (const bool is_first : {false, true})
      cases.push_back({.name = "ark.coarse.provoking." + name + (is_first ? ".first" : ".last"),
                       .clauses = {"11.R.3-3"},
                       .plan = "Draw with flat colours, unrefined and refined: the pictures are the same.",
                       .wrong = "A triangle with the colour of another corner.",
                       .apis = mode.is_legacy ? compat_only
                               : is_first     ? desktop_apis
                                              : every_api,
                       .control = control_provoking,
                       .check = [mode, is_first](Test& t) { check_provoking(t, mode.mode, is_first); }});
    if (mode.is_legacy)
      cases.push_back({.name = "ark.coarse.centroid." + name,
                       .clauses = {"11.R.3-6", "11.R.3-7", "11.R.3-8", "11.R.4-16"},
                       .plan = "Capture primitives of eight vertices that are split at their centroids.",
                       .wrong = "The triangles of POLYGON_TRIANGLES_ARK; a centroid of other vertices; inner edges of "
                                "another depth; the boundary in the wrong order.",
                       .apis = compat_only,
                       .check = [mode](Test& t) { check_centroid(t, mode.mode); }});
    else
      cases.push_back({.name = "ark.coarse.centroid.not_of_" + name,
                       .clauses = {"11.R.3-10"},
                       .plan = "Refine triangles while POLYGON_CENTROID_ARK is set.",
                       .wrong = "Triangles are split in three.",
                       .check = [mode](Test& t) { check_triangles_stay(t, mode.mode); }});
  }
  for (const auto& [leaf, mode, count] : {std::tuple<const char*, GLenum, std::size_t>{"polygon_5", GL_POLYGON, 5},
                                          {"polygon_6", GL_POLYGON, 6},
                                          {"polygon_7", GL_POLYGON, 7},
                                          {"quads", GL_QUADS, 8},
                                          {"quad_strip", GL_QUAD_STRIP, 8}})
    cases.push_back({.name = std::string("ark.coarse.centroid.bits.") + leaf,
                     .clauses = {"11.R.3-7", "11.R.3-8"},
                     .plan = "Capture primitives of random vertices, split at the centroid: they are equal by bits.",
                     .wrong = "Summed from the last vertex, multiplied by 1 / n, or in another order of corners.",
                     .apis = compat_only,
                     .check = [mode = mode, count = count](Test& t) { check_centroid_bits(t, mode, count); }});
  cases.push_back({.name = "ark.coarse.centroid.steep",
                   .clauses = {"11.R.4-16", "11.R.5-1"},
                   .plan = "One edge of depth 6 among edges of depth 0: the inner edges have the mean.",
                   .wrong = "The depth of the centroid's mean tag; rounded up.",
                   .apis = compat_only,
                   .check = check_steep_depths});
  cases.push_back({.name = "ark.coarse.centroid.restart",
                   .clauses = {"11.R.3-9", "11.R.3-11"},
                   .plan = "Count the triangles of indexed polygons with and without primitive restart.",
                   .wrong = "A centroid of vertices of two polygons.",
                   .apis = compat_only,
                   .check = check_restart});
  cases.push_back({.name = "ark.coarse.centroid.flat_shading",
                   .clauses = {"11.R.3-9", "11.R.3-12"},
                   .plan = "Count the triangles of two fixed-function quadrilaterals with either ShadeModel.",
                   .wrong = "Split with FLAT.",
                   .apis = compat_only,
                   .check = check_flat_shading});
  return cases;
}

}  // namespace glark::conformance
