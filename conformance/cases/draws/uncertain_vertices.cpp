// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Commands between Begin and End that give a vertex only if an array or a map of positions is enabled
// (GL 4.6 compatibility profile, 10.3.9 and 23.1).
#include <fmt/core.h>

#include "conformance/cases/cases.h"
#include "conformance/support/capture.h"
#include "conformance/support/counted.h"

namespace glark::conformance {
namespace {

// Two corners of a strip, for every n.
void two_vertices(int n) {
  const float y = -0.9F + 0.4F * static_cast<float>(n);
  gl.Color3f(0.9F - 0.15F * static_cast<float>(n), 0.2F, 0.1F + 0.15F * static_cast<float>(n));
  gl.Vertex3f(-0.8F, y, 0);
  gl.Vertex3f(0.8F, y + 0.1F, 0);
}

constexpr GLfloat element_places[] = {-0.9F, 0.2F, 0, 0.9F, 0.4F, 0, 0.1F, 0.9F, 0, -0.3F, -0.8F, 0};

// A command, and what makes it give a vertex.
struct VertexCommand {
  const char* leaf;
  void (*call)();
  void (*set)(bool is_enabled);
};

void set_array(bool is_enabled) {
  gl.VertexPointer(3, GL_FLOAT, 0, element_places);
  is_enabled ? gl.EnableClientState(GL_VERTEX_ARRAY) : gl.DisableClientState(GL_VERTEX_ARRAY);
}

void set_generic_array(bool is_enabled) {
  gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, element_places);
  is_enabled ? gl.EnableVertexAttribArray(0) : gl.DisableVertexAttribArray(0);
}

template <GLenum map>
void set_map1(bool is_enabled) {
  const GLfloat points[] = {-0.9F, 0.5F, 0, 1, 0.9F, 0.7F, 0, 1};
  gl.Map1f(map, 0, 1, 4, 2, points);
  gl.MapGrid1f(4, 0, 1);
  is_enabled ? gl.Enable(map) : gl.Disable(map);
}

template <GLenum map>
void set_map2(bool is_enabled) {
  const GLfloat points[] = {-0.9F, 0.5F, 0, 1, 0.9F, 0.7F, 0, 1, -0.5F, -0.5F, 0, 1, 0.9F, -0.7F, 0, 1};
  gl.Map2f(map, 0, 1, 4, 2, 0, 1, 8, 2, points);
  gl.MapGrid2f(4, 0, 1, 4, 0, 1);
  is_enabled ? gl.Enable(map) : gl.Disable(map);
}

constexpr VertexCommand vertex_commands[] = {
    {"ArrayElement", [] { gl.ArrayElement(1); }, set_array},
    {"ArrayElement of attribute 0", [] { gl.ArrayElement(1); }, set_generic_array},
    {"EvalCoord1f", [] { gl.EvalCoord1f(0.7F); }, set_map1<GL_MAP1_VERTEX_3>},
    {"EvalCoord1f of 4", [] { gl.EvalCoord1f(0.7F); }, set_map1<GL_MAP1_VERTEX_4>},
    {"EvalCoord1d", [] { gl.EvalCoord1d(0.7); }, set_map1<GL_MAP1_VERTEX_3>},
    {"EvalPoint1", [] { gl.EvalPoint1(3); }, set_map1<GL_MAP1_VERTEX_3>},
    {"EvalCoord2f", [] { gl.EvalCoord2f(0.7F, 0.4F); }, set_map2<GL_MAP2_VERTEX_3>},
    {"EvalCoord2f of 4", [] { gl.EvalCoord2f(0.7F, 0.4F); }, set_map2<GL_MAP2_VERTEX_4>},
    {"EvalCoord2d", [] { gl.EvalCoord2d(0.7, 0.4); }, set_map2<GL_MAP2_VERTEX_3>},
    {"EvalPoint2", [] { gl.EvalPoint2(3, 1); }, set_map2<GL_MAP2_VERTEX_3>},
};

constexpr std::size_t array_commands = 2;  // they come first in vertex_commands

struct CountedMode {
  const char* leaf;
  GLenum mode;
  GLuint (*triangles)(GLuint vertices);
};
constexpr CountedMode counted_modes[] = {
    {"triangles", GL_TRIANGLES, [](GLuint vertices) { return vertices / 3; }},
    {"triangle_strip", GL_TRIANGLE_STRIP, [](GLuint vertices) { return vertices - 2; }},
    {"triangle_fan", GL_TRIANGLE_FAN, [](GLuint vertices) { return vertices - 2; }},
    {"quads", GL_QUADS, [](GLuint vertices) { return vertices / 4 * 2; }},
    {"quad_strip", GL_QUAD_STRIP, [](GLuint vertices) { return vertices / 2 * 2 - 2; }},
    {"polygon", GL_POLYGON, [](GLuint vertices) { return vertices - 2; }}};

// Its triangles have linear colours, however the corners lie. Quads and polygons are no longer convex here.
bool is_flat(GLenum mode) { return mode == GL_TRIANGLES || mode == GL_TRIANGLE_STRIP || mode == GL_TRIANGLE_FAN; }

void draw_uncertain(GLenum mode, int position, void (*call)()) {
  gl.Begin(mode);
  for (int n = 0; n < 4; ++n) {
    if (n == position) call();
    two_vertices(n);
  }
  if (position == 4) call();
  gl.End();
}

enum class Compiled { direct, list, list_before };

// A list compiled before the array changes keeps its vertices. The maps are those of the time of the call.
void check_uncertain(Test& t, const CountedMode& mode, const VertexCommand& command, Compiled way) {
  for (const bool is_enabled : {false, true, false})
    for (const int position : {0, 1, 4}) {
      const auto plain = [&] { draw_uncertain(mode.mode, position, command.call); };
      command.set(way == Compiled::list_before ? !is_enabled : is_enabled);
      if (way != Compiled::direct) {
        gl.NewList(2, GL_COMPILE);
        plain();
        gl.EndList();
      }
      command.set(is_enabled);
      const bool is_array = &command - vertex_commands < static_cast<std::ptrdiff_t>(array_commands);
      const bool gives_vertex = is_array && way == Compiled::list_before ? !is_enabled : is_enabled;
      const auto draw = [&] {
        gl.Color3f(0.3F, 0.6F, 0.2F);
        way == Compiled::direct ? plain() : gl.CallList(2);
      };
      const std::string what =
          fmt::format("{}, {}, before vertex {}", command.leaf, is_enabled ? "enabled" : "disabled", 2 * position);
      GLuint refined_count = 0;
      gl.Disable(GL_ARK);
      command.set(gives_vertex);
      const GLuint direct_count = count_generated(plain);
      command.set(is_enabled);
      GLuint plain_count = 0;
      const Picture expected = picture_of([&] { plain_count = count_generated(draw); });
      gl.Enable(GL_ARK);
      // Mesa 25 draws twice what a list begins with a vertex before its first colour.
      if (mode.mode != GL_TRIANGLE_STRIP && plain_count != direct_count) continue;
      // Mesa 22 loses a triangle of a strip in a list whose colour is first set after its first vertex.
      const GLuint triangles = mode.mode == GL_TRIANGLE_STRIP ? plain_count : mode.triangles(gives_vertex ? 9 : 8);
      for (int again = 0; again < 2; ++again) {
        const Picture refined = picture_of([&] { refined_count = count_generated(draw); });
        if (is_flat(mode.mode)) t.expect_same_picture(refined, expected, what, 4, 80);
        t.expect_equal(refined_count, 16 * triangles, what + ": triangles");
      }
    }
  command.set(false);
}

void check_all_uncertain(Test& t, const CountedMode& mode, Compiled way) {
  refine_uniformly(2, GL_LINEAR_OUTPUTS_ARK);
  for (const VertexCommand& command : vertex_commands) check_uncertain(t, mode, command, way);
  t.expect_no_error("the draws");
}

const char* leaf_of_compiled(Compiled way) {
  return way == Compiled::direct ? "direct" : way == Compiled::list ? "list" : "list_before";
}

}  // namespace

Cases uncertain_vertices_cases() {
  Cases cases;
  for (const CountedMode& mode : counted_modes)
    for (const Compiled way : {Compiled::direct, Compiled::list, Compiled::list_before})
      cases.push_back({.name = fmt::format("ark.draw.uncertain.{}.{}", mode.leaf, leaf_of_compiled(way)),
                       .clauses = {"10.R.2-1", "10.R.2-2"},
                       .plan =
                           "ArrayElement, EvalCoord and EvalPoint at each end of a primitive and within it, with and "
                           "without what makes them give a vertex; count triangles and compare with the unrefined "
                           "picture.",
                       .wrong = "A command that gives no vertex is counted as one.",
                       .apis = compat_only,
                       .check = [&mode, way](Test& t) { check_all_uncertain(t, mode, way); }});
  return cases;
}

}  // namespace glark::conformance
