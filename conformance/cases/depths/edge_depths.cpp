// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The depths of edges (11.R.4): uniform depths, and depths measured in pixels and degrees.
#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <utility>

#include "conformance/cases/cases.h"
#include "conformance/support/counted.h"
#include "conformance/support/refined_draw.h"

namespace glark::conformance {
namespace {

using reference::Depths;

constexpr GLuint pool = 6;

// The corners are given in window coordinates, in pixels.
Mesh triangle_in_pixels(const std::array<Vec2, 3>& places, std::array<float, 3> tags = {6, 6, 6}) {
  Mesh mesh = one_triangle(tags);
  const float scale = 2.0F / static_cast<float>(surface_size);
  for (std::size_t i = 0; i < 3; ++i) {
    mesh[i].position = {places[i][0] * scale - 1, places[i][1] * scale - 1, 0, 1};
    mesh[i].normal = {0, 0, 1};
  }
  return mesh;
}

GLuint measured_program(Test& t, const char* position) {
  return build_program(t, {.vertex = std::string("layout(location = 0) in vec4 position;\n"
                                                 "layout(location = 1) in vec3 normal;\n"
                                                 "layout(location = 2) in vec3 weights;\n"
                                                 "layout(location = 6) in float triangle;\n"
                                                 "uniform float scale;\n"
                                                 "out vec3 weights_out; out float triangle_out; out vec4 colour;\n"
                                                 "void main() { weights_out = weights; triangle_out = triangle;\n"
                                                 "  colour = vec4(abs(normal), 1.0); gl_Position = ") +
                                     position + "; }\n",
                           .captured = {"gl_Position", "weights_out", "triangle_out", "colour"}});
}

struct Captured {
  CapturedVertex vertex;
  Vec4 colour;
};

Depths measured(Test& t, const Mesh& mesh) {
  upload(mesh);
  std::vector<CapturedVertex> vertices;
  for (const Captured& each : capture_as<Captured>(t, 60000, [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); }))
    vertices.push_back(each.vertex);
  return reference::depths_found(weights_of(t, vertices));
}

void expect_measured(Test& t, const Mesh& mesh, const Depths& expected, const std::string& what) {
  const Depths found = measured(t, mesh);
  t.expect(found == expected, what + ": depths " + text_of(found) + ", not " + text_of(expected));
}

void measure_by(GLint pixels, GLint degrees) {
  refine_by_tags(pool);
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK);
  gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, pixels);
  gl.ARKParameteriARK(GL_EDGE_DEGREES_ARK, degrees);
  gl.Viewport(0, 0, surface_size, surface_size);
}

int depth_of(double length, double greatest) {
  int depth = 0;
  while (depth < static_cast<int>(pool) && length > greatest * std::exp2(depth)) ++depth;
  return depth;
}

// Edges of 60, 80 and 100 pixels: each lies between two steps of every measure that the cases try.
const std::array<Vec2, 3> right_angle = {{{10, 20}, {70, 20}, {70, 100}}};

Depths right_angle_depths(double pixels) { return {depth_of(60, pixels), depth_of(80, pixels), depth_of(100, pixels)}; }

void check_pixels(Test& t) {
  gl.UseProgram(measured_program(t, "position"));
  for (const GLint pixels : {1, 3, 7, 12, 27, 55, 90, 200}) {
    measure_by(pixels, 0);
    expect_measured(t, triangle_in_pixels(right_angle), right_angle_depths(pixels), fmt::format("{} pixels", pixels));
  }
}

// The vertex stage's output gives the ends of an edge; w is not 1.
void check_ends(Test& t) {
  const GLuint program = measured_program(t, "vec4(position.xy * scale * 1.5, 0.3, 1.5)");
  gl.UseProgram(program);
  for (const float scale : {1.0F, 0.5F, 0.25F}) {
    gl.Uniform1f(gl.GetUniformLocation(program, "scale"), scale);
    measure_by(7, 0);
    expect_measured(t, triangle_in_pixels(right_angle), right_angle_depths(7 / static_cast<double>(scale)),
                    "scaled by " + as_text(scale));
  }
}

void check_viewport(Test& t) {
  gl.UseProgram(measured_program(t, "position"));
  measure_by(7, 0);
  gl.Viewport(0, 0, surface_size / 2, surface_size / 2);
  expect_measured(t, triangle_in_pixels(right_angle), right_angle_depths(14), "half a viewport");
  gl.Viewport(0, 0, surface_size / 4, surface_size);
  expect_measured(t, triangle_in_pixels(right_angle),
                  {depth_of(15, 7), depth_of(80, 7), depth_of(std::hypot(15, 80), 7)}, "a quarter of the width");
}

// Tries every command that sets viewport 0, and one that sets another viewport, right before the draw.
void check_indexed_viewports(Test& t) {
  gl.UseProgram(measured_program(t, "position"));
  upload(triangle_in_pixels(right_angle));
  measure_by(7, 0);
  const auto expect_pixels = [&](double pixels, const char* what, const std::function<void()>& set) {
    const GLuint count = count_generated([&] {
      set();
      gl.DrawArrays(GL_TRIANGLES, 0, 3);
    });
    t.expect_equal(std::int64_t{count}, reference::minimum_triangles(right_angle_depths(pixels)), what);
  };
  const auto half = static_cast<GLfloat>(surface_size) / 2;
  const GLfloat whole_and_half[] = {0, 0, 2 * half, 2 * half, 0, 0, half, half};
  for (int round = 0; round < 2; ++round) {
    expect_pixels(7, "Viewport", [] { gl.Viewport(0, 0, surface_size, surface_size); });
    expect_pixels(14, "ViewportIndexedf", [&] { gl.ViewportIndexedf(0, 0, 0, half, half); });
    expect_pixels(7, "ViewportIndexedfv", [&] { gl.ViewportIndexedfv(0, whole_and_half); });
    expect_pixels(14, "ViewportArrayv", [&] { gl.ViewportArrayv(0, 1, whole_and_half + 4); });
    expect_pixels(7, "ViewportArrayv of two", [&] { gl.ViewportArrayv(0, 2, whole_and_half); });
    expect_pixels(7, "the viewport with index 1", [&] { gl.ViewportIndexedf(1, 0, 0, half / 2, half / 2); });
  }
  t.expect_no_error("the draws");
}

// An implementation may measure few triangles and many of them in different ways.
void check_many(Test& t) {
  gl.UseProgram(measured_program(t, "position"));
  const Mesh one = triangle_in_pixels(right_angle);
  Mesh mesh;
  for (int i = 0; i < 600; ++i) mesh.insert(mesh.end(), one.begin(), one.end());
  upload(mesh);
  measure_by(7, 0);
  constexpr double whole = surface_size;
  for (const auto& [width, height] : {std::pair<GLsizei, GLsizei>{128, 128}, {64, 8}, {8, 64}, {128, 32}}) {
    gl.Viewport(0, 0, width, height);
    const auto length = [w = width / whole, h = height / whole](double x, double y) {
      return depth_of(std::hypot(w * x, h * y), 7);
    };
    const std::int64_t each = reference::minimum_triangles({length(60, 0), length(0, 80), length(60, 80)});
    for (const GLsizei copies : {1, 2, 63, 64, 65, 127, 128, 129, 256, 257, 600}) {
      const GLuint count = count_generated([&] { gl.DrawArrays(GL_TRIANGLES, 0, 3 * copies); });
      t.expect_equal(std::int64_t{count}, each * copies,
                     fmt::format("triangles of {} copies in a viewport of {} x {}", copies, width, height));
    }
  }
  t.expect_no_error("the draws");
}

Vec3 turned(double degrees) {
  const double angle = degrees * std::acos(-1.0) / 180;
  return {static_cast<float>(2 * std::sin(angle)), 0, static_cast<float>(2 * std::cos(angle))};  // not of unit length
}

// Angles of 20, 50 and 70 degrees.
Mesh bent_triangle() {
  Mesh mesh = triangle_in_pixels(right_angle);
  mesh[0].normal = turned(-10);
  mesh[1].normal = turned(10);
  mesh[2].normal = turned(60);
  return mesh;
}

Depths bent_depths(double degrees) { return {depth_of(20, degrees), depth_of(50, degrees), depth_of(70, degrees)}; }

void check_degrees(Test& t) {
  gl.UseProgram(measured_program(t, "position"));
  for (const GLint degrees : {1, 3, 6, 11, 30, 60, 90, 180}) {
    measure_by(0, degrees);
    expect_measured(t, bent_triangle(), bent_depths(degrees), fmt::format("{} degrees", degrees));
  }
}

void check_lesser(Test& t) {
  gl.UseProgram(measured_program(t, "position"));
  for (const auto& [pixels, degrees] : {std::pair<GLint, GLint>{7, 11}, {12, 3}, {3, 30}, {27, 27}}) {
    measure_by(pixels, degrees);
    const Depths a = right_angle_depths(pixels);
    const Depths b = bent_depths(degrees);
    expect_measured(t, bent_triangle(), {std::min(a[0], b[0]), std::min(a[1], b[1]), std::min(a[2], b[2])},
                    fmt::format("{} pixels, {} degrees", pixels, degrees));
  }
}

void check_pool_level(Test& t) {
  gl.UseProgram(measured_program(t, "position"));
  measure_by(1, 0);
  gl.ARKinit(3);
  expect_measured(t, triangle_in_pixels(right_angle), {3, 3, 3}, "a pool of level 3");
}

void check_tags_ignored(Test& t) {
  gl.UseProgram(measured_program(t, "position"));
  measure_by(12, 0);
  expect_measured(t, triangle_in_pixels(right_angle, {0, 1, 6}), right_angle_depths(12), "measured, with tags");
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  for (const int level : {0, 2, 4}) {
    gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, level);
    expect_measured(t, triangle_in_pixels(right_angle, {0, 1, 6}), {level, level, level}, "uniform, with tags");
  }
}

void check_neither(Test& t) {
  gl.UseProgram(measured_program(t, "position"));
  for (const int level : {0, 1, 3}) {
    measure_by(0, 0);
    gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, level);
    expect_measured(t, bent_triangle(), {level, level, level}, "without a measure");
  }
  // There is no normal, so EDGE_DEGREES_ARK does not apply.
  gl.UseProgram(capture_program(t));
  measure_by(0, 10);
  gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 2);
  upload(bent_triangle());
  const auto found = reference::depths_found(weights_of(t, capture(t, [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); })));
  t.expect(found == Depths{2, 2, 2}, "degrees without a normal: depths " + text_of(found));
}

// EDGE_PIXELS_ARK does not apply if there is a geometry shader; EDGE_DEGREES_ARK does.
void check_geometry_shader(Test& t) {
  gl.UseProgram(build_program(
      t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 1) in vec3 normal; out vec4 between;\n"
                    "void main() { between = vec4(abs(normal), 1.0); gl_Position = position; }\n",
          .geometry = "layout(triangles) in; layout(triangle_strip, max_vertices = 3) out;\n"
                      "in vec4 between[]; out vec4 colour;\n"
                      "void main() { for (int i = 0; i < 3; ++i) { gl_Position = gl_in[i].gl_Position;\n"
                      "  colour = between[i]; EmitVertex(); } EndPrimitive(); }\n"}));
  upload(bent_triangle());
  const auto draw = [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); };
  for (const GLint level : {0, 1, 3}) {
    measure_by(7, 0);
    gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, level);
    t.expect_equal(count_generated(draw), GLuint{1} << (2 * level), "triangles where no measure applies");
  }
  measure_by(1, 180);
  t.expect_equal(count_generated(draw), 1U, "triangles where only degrees apply");
}

// The same with the geometry shader in a program of its own.
void check_geometry_program(Test& t) {
  const Pipeline pipeline = bind_pipeline(
      t,
      "layout(location = 0) in vec4 position; layout(location = 0) out vec4 between;\n"
      "void main() { between = vec4(1.0); gl_Position = position; }\n",
      "layout(location = 0) in vec4 colour; layout(location = 0) out vec4 pixel; void main() { pixel = colour; }\n");
  const GLuint geometry =
      separable_program(t, GL_GEOMETRY_SHADER,
                        "layout(triangles) in; layout(triangle_strip, max_vertices = 3) out;\n"
                        "in gl_PerVertex { vec4 gl_Position; } gl_in[]; out gl_PerVertex { vec4 gl_Position; };\n"
                        "layout(location = 0) in vec4 between[]; layout(location = 0) out vec4 colour;\n"
                        "void main() { for (int i = 0; i < 3; ++i) { gl_Position = gl_in[i].gl_Position;\n"
                        "  colour = between[i]; EmitVertex(); } EndPrimitive(); }\n");
  upload(bent_triangle());
  const auto draw = [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); };
  measure_by(7, 0);
  gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 2);
  const GLuint measured = count_generated(draw);
  if (measured <= 1) t.not_supported("program pipelines are not refined");
  t.expect(measured > 16, "pixels are measured without a geometry shader");
  gl.UseProgramStages(pipeline.name, GL_GEOMETRY_SHADER_BIT, geometry);
  for (const GLint level : {1, 2}) {
    gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, level);
    t.expect_equal(count_generated(draw), GLuint{1} << (2 * level), "triangles where no measure applies");
  }
  gl.UseProgramStages(pipeline.name, GL_GEOMETRY_SHADER_BIT, 0);
  t.expect_equal(count_generated(draw), measured, "triangles without the geometry shader again");
  t.expect_no_error("the pipelines");
}

GLuint triangles_in_a_frame(Test& t, const Mesh& mesh) {
  GLuint query = 0;
  GLuint count = 0;
  gl.GenQueries(1, &query);
  gl.BeginQuery(GL_PRIMITIVES_GENERATED, query);
  gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(mesh.size()));
  gl.EndQuery(GL_PRIMITIVES_GENERATED);
  gl.GetQueryObjectuiv(query, GL_QUERY_RESULT, &count);
  gl.DeleteQueries(1, &query);
  t.context().end_frame();
  return count;
}

// Draws `coarse` triangles at once. Without a budget their measured depths give some thousand triangles.
void check_budget(Test& t, GLint budget, GLuint coarse) {
  gl.UseProgram(colour_program(t));
  Mesh mesh;
  for (GLuint i = 0; i < coarse; ++i) {
    const Mesh one = one_triangle();
    mesh.insert(mesh.end(), one.begin(), one.end());
  }
  upload(mesh);
  measure_by(9, 0);
  const GLuint coarser = triangles_in_a_frame(t, mesh);
  measure_by(4, 0);
  const GLuint free = triangles_in_a_frame(t, mesh);
  t.require(free > 4000, "without a budget there are many triangles");
  gl.ARKParameteriARK(GL_TRIANGLE_BUDGET_ARK, budget);
  const auto draw = [&] { gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(mesh.size())); };
  for (int frame = 0; frame < 6; ++frame) {
    const GLuint first = count_generated(draw);
    for (int again = 0; again < 3; ++again)
      t.expect_equal(count_generated(draw), first, "triangles of the same draw later in the frame");
    t.context().end_frame();
  }
  GLuint last = triangles_in_a_frame(t, mesh);
  for (int frame = 0; frame < 40; ++frame) last = triangles_in_a_frame(t, mesh);
  const auto most = static_cast<GLuint>(budget);
  t.expect(last <= std::max(most, coarse), fmt::format("{} triangles with a budget of {}", last, most));
  t.expect(last >= std::min(most / 4, free), fmt::format("{} triangles are at least a quarter of the budget", last));
  gl.ARKParameteriARK(GL_TRIANGLE_BUDGET_ARK, 0);
  t.expect_equal(triangles_in_a_frame(t, mesh), free, "triangles once the budget is set to none");
  gl.ARKParameteriARK(GL_TRIANGLE_BUDGET_ARK, budget);
  for (int frame = 0; frame < 20; ++frame) triangles_in_a_frame(t, mesh);
  gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, 9);
  t.expect_equal(triangles_in_a_frame(t, mesh), coarser, "triangles of the frame after a measure changes");
}

struct BudgetChange {
  const char* what;
  void (*make)();
};
constexpr BudgetChange budget_changes[] = {
    {"a greater budget", [] { gl.ARKParameteriARK(GL_TRIANGLE_BUDGET_ARK, 601); }},
    {"a much greater budget", [] { gl.ARKParameteriARK(GL_TRIANGLE_BUDGET_ARK, 1000000); }},
    {"a lesser budget", [] { gl.ARKParameteriARK(GL_TRIANGLE_BUDGET_ARK, 200); }},
    {"no budget", [] { gl.ARKParameteriARK(GL_TRIANGLE_BUDGET_ARK, 0); }},
    {"more pixels", [] { gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, 6); }},
    {"fewer pixels", [] { gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, 2); }},
    {"no pixels", [] { gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, 0); }},
    {"other degrees", [] { gl.ARKParameteriARK(GL_EDGE_DEGREES_ARK, 3); }},
    {"no degrees", [] { gl.ARKParameteriARK(GL_EDGE_DEGREES_ARK, 0); }},
    {"another error", [] { gl.ARKParameterfARK(GL_SCREEN_ERROR_ARK, 0.01F); }},
    {"no error", [] { gl.ARKParameterfARK(GL_SCREEN_ERROR_ARK, 0); }},
    {"other pixels, and the same as before", [] {
       gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, 2);
       gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, 3);
     }}};

// With c = 1, triangles are those of the same measures without a budget. Each change has new buffers.
void check_budget_changes(Test& t) {
  gl.UseProgram(measured_program(t, "position"));
  Mesh mesh;
  for (int i = 0; i < 16; ++i) {
    const Mesh bent = bent_triangle();
    mesh.insert(mesh.end(), bent.begin(), bent.end());
  }
  constexpr GLuint budget = 600;
  const auto set_measures = [] {
    measure_by(3, 1);
    gl.ARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);
    gl.ARKParameterfARK(GL_SCREEN_ERROR_ARK, 0.0005F);
  };
  set_measures();
  gl.ARKParameteriARK(GL_TRIANGLE_BUDGET_ARK, 0);
  upload(mesh);
  for (int frame = 0; frame < 60; ++frame) triangles_in_a_frame(t, mesh);
  gl.ARKParameteriARK(GL_TRIANGLE_BUDGET_ARK, budget);
  for (int frame = 0; frame < 20; ++frame) triangles_in_a_frame(t, mesh);
  t.expect(triangles_in_a_frame(t, mesh) <= budget, "a budget for a draw that repeated without one");
  for (const BudgetChange& change : budget_changes) {
    set_measures();
    change.make();
    gl.ARKParameteriARK(GL_TRIANGLE_BUDGET_ARK, 0);
    upload(mesh);
    const GLuint free = triangles_in_a_frame(t, mesh);
    set_measures();
    gl.ARKParameteriARK(GL_TRIANGLE_BUDGET_ARK, budget);
    for (int frame = 0; frame < 20; ++frame) triangles_in_a_frame(t, mesh);
    gl.ARKParameteriARK(GL_TRIANGLE_BUDGET_ARK, budget);  // no other value
    const GLuint within = triangles_in_a_frame(t, mesh);
    t.expect(within <= budget, fmt::format("{} triangles with a budget of {}, before {}", within, budget, change.what));
    t.expect(free != within, fmt::format("{} shows", change.what));
    change.make();
    t.expect_equal(triangles_in_a_frame(t, mesh), free, std::string("triangles of the frame after ") + change.what);
  }
}

constexpr Area depth_case{"ark.depth."};

}  // namespace

Cases edge_depths_cases() {
  Cases cases = {depth_case("measured.pixels", {"11.R.4-18", "11.R.4-4"},
                            "A triangle of 60, 80 and 100 pixels with eight measures.",
                            "One level more or less; half of the length, from clip coordinates.", check_pixels),
                 depth_case("measured.ends", {"11.R.4-5"}, "A vertex stage that scales by a uniform, with a w of 1.5.",
                            "The length of the input positions; no division by w.", check_ends),
                 depth_case("measured.viewport", {"11.R.4-5"}, "The same triangle in smaller viewports.",
                            "The size of the surface, or of the previous viewport.", check_viewport),
                 depth_case("measured.many", {"11.R.4-5", "11.R.4-18"},
                            "1 to 600 copies of the same triangle in viewports of several shapes, in one draw.",
                            "Few triangles and many of them have different depths.", check_many),
                 depth_case("measured.degrees", {"11.R.4-8", "11.R.4-9"},
                            "Normals 20, 50 and 70 degrees apart, not of unit length.",
                            "The angle at other corners; normals that are not normalized.", check_degrees),
                 depth_case("measured.lesser", {"11.R.4-18"}, "With both measures, each edge has the lesser depth.",
                            "The greater depth; one depth for the triangle.", check_lesser),
                 depth_case("measured.pool_level", {"11.R.4-18"}, "A measure that asks for more than the pool has.",
                            "No limit.", check_pool_level),
                 depth_case("tags_ignored", {"11.R.4-1", "11.R.4-18"},
                            "Uniform and measured depths with an enabled array of tags.", "Depths of the tags.",
                            check_tags_ignored),
                 depth_case("measured.geometry_shader", {"11.R.4-4", "11.R.4-26"},
                            "Pixels with a geometry shader do not apply: the uniform depth; degrees do.",
                            "Pixels are measured in spite of the geometry shader.", check_geometry_shader),
                 depth_case("measured.neither", {"11.R.4-26"}, "No measure, or degrees without a normal.",
                            "Depth 0; tags.", check_neither)};
  cases.push_back(optional(depth_case("measured.geometry_program", {"11.R.4-4", "11.R.4-26"},
                                      "The same in a program pipeline, with the geometry shader in its own program.",
                                      "Only the vertex program is asked for a geometry shader.", check_geometry_program,
                                      desktop_apis)));
  cases.push_back(depth_case("measured.indexed_viewports", {"11.R.4-5"},
                             "The same triangle after every command that sets one of several viewports.",
                             "Only Viewport is noticed; the viewport of another index counts.", check_indexed_viewports,
                             desktop_apis));
  cases.push_back(depth_case("budget.changes", {"11.R.4-17", "11.R.4-28"},
                             "Draw with a budget until c has settled; then change the budget or one of the measures.",
                             "c starts again only if a measure changes, or only if there was no budget before.",
                             check_budget_changes));
  for (const auto& [budget, coarse] : {std::pair<GLint, GLuint>{500, 16}, {2000, 16}, {9000, 300}})
    cases.push_back({.name = fmt::format("ark.depth.budget.{}", budget),
                     .clauses = {"11.R.4-28", "11.R.4-17"},
                     .plan = "Draw one scene for forty frames and count; then set the budget and a measure again.",
                     .wrong = "More triangles than the budget; far fewer; the draw stays coarse.",
                     .check = [budget = budget, coarse = coarse](Test& t) { check_budget(t, budget, coarse); }});
  return cases;
}

}  // namespace glark::conformance
