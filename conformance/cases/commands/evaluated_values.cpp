// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Evaluators (GL 4.6 compatibility profile, 23.1): vertices with evaluated colours, normals and coordinates between
// Begin and End, and evaluator meshes between draws that are refined. An evaluated value is no current value.
#include <fmt/core.h>

#include <array>

#include "conformance/cases/cases.h"
#include "conformance/cases/commands/as_plain.h"

namespace glark::conformance {
namespace {

constexpr GLuint evaluated_list = 43;
constexpr int evaluated_columns = 4;  // of the strip; each has two vertices

struct EvaluatedCommand {
  const char* leaf;
  bool has_two;                           // dimensions
  void (*evaluate)(int column, int row);  // row: 0 or 1
};

constexpr float u_of(int column) { return static_cast<float>(column) / (evaluated_columns - 1); }

constexpr EvaluatedCommand evaluated_commands[] = {
    {"EvalCoord1f", false, [](int column, int row) { gl.EvalCoord1f((u_of(column) + static_cast<float>(row)) / 2); }},
    {"EvalCoord1fv", false,
     [](int column, int row) {
       const GLfloat u = (u_of(column) + static_cast<float>(row)) / 2;
       gl.EvalCoord1fv(&u);
     }},
    {"EvalCoord1d", false, [](int column, int row) { gl.EvalCoord1d((u_of(column) + static_cast<float>(row)) / 2); }},
    {"EvalCoord1dv", false,
     [](int column, int row) {
       const GLdouble u = (u_of(column) + static_cast<float>(row)) / 2;
       gl.EvalCoord1dv(&u);
     }},
    {"EvalPoint1", false, [](int column, int row) { gl.EvalPoint1(column + 3 * row); }},
    {"EvalCoord2f", true, [](int column, int row) { gl.EvalCoord2f(u_of(column), static_cast<float>(row)); }},
    {"EvalCoord2fv", true,
     [](int column, int row) {
       const GLfloat at[] = {u_of(column), static_cast<float>(row)};
       gl.EvalCoord2fv(at);
     }},
    {"EvalCoord2d", true, [](int column, int row) { gl.EvalCoord2d(u_of(column), row); }},
    {"EvalCoord2dv", true,
     [](int column, int row) {
       const GLdouble at[] = {u_of(column), static_cast<double>(row)};
       gl.EvalCoord2dv(at);
     }},
    {"EvalPoint2", true, [](int column, int row) { gl.EvalPoint2(column, 2 * row); }},
};

// What a map gives each vertex.
struct MapOf {
  const char* name;
  GLenum one;
  GLenum two;
  int components;
  const char* value;  // in the vertex stage; of positions: the current colour
};
constexpr MapOf maps_of[] = {
    {"VERTEX_3", GL_MAP1_VERTEX_3, GL_MAP2_VERTEX_3, 3, "gl_Color"},
    {"VERTEX_4", GL_MAP1_VERTEX_4, GL_MAP2_VERTEX_4, 4, "gl_Color"},
    {"COLOR_4", GL_MAP1_COLOR_4, GL_MAP2_COLOR_4, 4, "gl_Color"},
    {"NORMAL", GL_MAP1_NORMAL, GL_MAP2_NORMAL, 3, "vec4(gl_Normal, 1.0)"},
    {"TEXTURE_COORD_1", GL_MAP1_TEXTURE_COORD_1, GL_MAP2_TEXTURE_COORD_1, 1, "gl_MultiTexCoord0"},
    {"TEXTURE_COORD_2", GL_MAP1_TEXTURE_COORD_2, GL_MAP2_TEXTURE_COORD_2, 2, "gl_MultiTexCoord0"},
    {"TEXTURE_COORD_3", GL_MAP1_TEXTURE_COORD_3, GL_MAP2_TEXTURE_COORD_3, 3, "gl_MultiTexCoord0"},
    {"TEXTURE_COORD_4", GL_MAP1_TEXTURE_COORD_4, GL_MAP2_TEXTURE_COORD_4, 4, "gl_MultiTexCoord0"},
};

using ControlPoints = std::array<std::array<GLfloat, 4>, 4>;

ControlPoints control_points(bool is_position, bool is_two, int salt) {
  const float shift = 0.1F * static_cast<float>(salt);
  if (is_position && is_two)
    return {{{-0.9F, -0.8F, 0, 1}, {-0.7F, 0.6F, 0, 1}, {0.8F, -0.6F + shift, 0, 1}, {0.7F, 0.9F, 0, 1}}};
  if (is_position)
    return {{{-0.9F, -0.8F + shift, 0, 1}, {-0.5F, 0.9F, 0, 1}, {0.6F, 0.8F, 0, 1}, {0.9F, -0.7F, 0, 1}}};
  return {{{0.1F + shift, 0.9F, 0.3F, 1}, {0.6F, 0.2F, 0.9F, 1}, {0.3F, 0.5F + shift, 0.1F, 1}, {0.9F, 0.1F, 0.6F, 1}}};
}

// One-dimensional maps have four control points, others two by two.
void set_map(const MapOf& map, bool is_two, int salt, bool is_double) {
  const ControlPoints points = control_points(map.one == GL_MAP1_VERTEX_3 || map.one == GL_MAP1_VERTEX_4, is_two, salt);
  std::array<GLdouble, 16> doubles{};
  for (std::size_t i = 0; i < 16; ++i) doubles[i] = points[i / 4][i % 4];
  if (is_two && is_double) gl.Map2d(map.two, 0, 1, 8, 2, 0, 1, 4, 2, doubles.data());
  if (is_two && !is_double) gl.Map2f(map.two, 0, 1, 8, 2, 0, 1, 4, 2, points[0].data());
  if (!is_two && is_double) gl.Map1d(map.one, 0, 1, 4, 4, doubles.data());
  if (!is_two && !is_double) gl.Map1f(map.one, 0, 1, 4, 4, points[0].data());
  gl.Enable(is_two ? map.two : map.one);
}

void set_grid(bool is_two, bool is_double) {
  if (is_two) is_double ? gl.MapGrid2d(3, 0, 1, 2, 0, 1) : gl.MapGrid2f(3, 0, 1, 2, 0, 1);
  if (!is_two) is_double ? gl.MapGrid1d(6, 0, 1) : gl.MapGrid1f(6, 0, 1);
}

bool is_position_map(const MapOf& map) { return map.one == GL_MAP1_VERTEX_3 || map.one == GL_MAP1_VERTEX_4; }

void set_evaluator(const MapOf& map, bool is_two, int salt, bool is_double) {
  if (!is_position_map(map)) set_map(maps_of[0], is_two, 0, is_double);
  set_map(map, is_two, salt, is_double);
  set_grid(is_two, is_double);
}

void disable_maps() {
  for (const MapOf& map : maps_of) {
    gl.Disable(map.one);
    gl.Disable(map.two);
  }
}

void evaluated_currents() {
  gl.Color4f(0.3F, 0.9F, 0.5F, 1);
  gl.Normal3f(0.5F, 0.25F, 0.75F);
  gl.TexCoord4f(0.125F, 0.5F, 0.875F, 1);
}

std::array<GLfloat, 12> read_currents() {
  std::array<GLfloat, 12> values{};
  gl.GetFloatv(GL_CURRENT_COLOR, values.data());
  gl.GetFloatv(GL_CURRENT_NORMAL, values.data() + 4);
  gl.GetFloatv(GL_CURRENT_TEXTURE_COORDS, values.data() + 8);
  return values;
}

GLuint evaluated_program(Test& t, const char* value) {
  return build_program(t, {.vertex = std::string("out vec4 colour; void main() { gl_Position = gl_Vertex;\n"
                                                 "  colour = vec4(abs(") +
                                     value + ").rgb, 1.0); }\n"});
}

void compile_evaluated(const std::function<void()>& commands) {
  gl.NewList(evaluated_list, GL_COMPILE);
  commands();
  gl.EndList();
}

void call_evaluated() { gl.CallList(evaluated_list); }

// Draws before and after a change of the map, directly and by a list that was compiled before both.
void expect_evaluated(Test& t, const MapOf& map, bool is_two, const std::function<void()>& draw,
                      const std::function<void()>& compiled, const std::string& what, const AsPlain& how) {
  compile_evaluated(compiled);
  for (int salt = 0; salt < 2; ++salt) {
    set_evaluator(map, is_two, 3 * salt, salt == 1);
    for (const bool is_list : {false, true}) {
      const std::function<void()> drawn = is_list ? std::function<void()>(call_evaluated) : draw;
      const std::string turn = fmt::format("{}, {}, map {}", what, is_list ? "a list" : "direct", salt);
      evaluated_currents();
      const PlainDraw plain = plain_draw(drawn);
      const auto left = read_currents();
      evaluated_currents();
      // Mesa 22 draws nothing of the first strip that a list evaluates.
      AsPlain of_drawn = how;
      of_drawn.has_pixels = !is_list;
      expect_as_plain(t, plain, drawn, turn, of_drawn);
      // Mesa 22 leaves one of the evaluated sets of four coordinates current.
      if (map.one != GL_MAP1_TEXTURE_COORD_4) t.expect(read_currents() == left, turn + ": current values");
    }
  }
  disable_maps();
}

// A vertex of another kind before and after: the evaluated values must not reach it.
void check_evaluated(Test& t, const EvaluatedCommand& command) {
  refine_uniformly(2, GL_LINEAR_OUTPUTS_ARK);
  for (const MapOf& map : maps_of) {
    gl.UseProgram(evaluated_program(t, map.value));
    for (const GLenum mode : {GL_TRIANGLE_STRIP, GL_TRIANGLES}) {
      // Mesa 25 crashes when a list is compiled in which another vertex comes before the evaluated ones.
      const auto draw_with = [&command, mode](bool has_first) {
        evaluated_currents();
        gl.Begin(mode);
        if (has_first) gl.Vertex2f(-0.95F, 0.1F);
        for (int column = 0; column < evaluated_columns; ++column)
          for (int row = 0; row < 2; ++row) command.evaluate(column, row);
        gl.Vertex2f(0.95F, 0.2F);
        gl.Vertex2f(0.2F, 0.95F);
        gl.Vertex2f(0.9F, 0.9F);
        gl.End();
      };
      expect_evaluated(
          t, map, command.has_two, [&] { draw_with(true); }, [&] { draw_with(false); },
          fmt::format("{}, mode {}", map.name, mode), {.is_often = true});
    }
  }
  t.expect_no_error("the evaluated vertices");
}

struct EvaluatedMesh {
  const char* leaf;
  bool has_two;
  void (*draw)();
};
constexpr EvaluatedMesh evaluated_meshes[] = {
    {"EvalMesh1.points", false, [] { gl.EvalMesh1(GL_POINT, 0, 6); }},
    {"EvalMesh1.lines", false, [] { gl.EvalMesh1(GL_LINE, 1, 6); }},
    {"EvalMesh2.points", true, [] { gl.EvalMesh2(GL_POINT, 0, 3, 0, 2); }},
    {"EvalMesh2.lines", true, [] { gl.EvalMesh2(GL_LINE, 0, 3, 0, 2); }},
    {"EvalMesh2.fill", true, [] { gl.EvalMesh2(GL_FILL, 0, 3, 0, 2); }},
};

// A mesh beside triangles that are refined: it is drawn as without the extension, and they are not lost.
void check_evaluated_mesh(Test& t, const EvaluatedMesh& mesh) {
  const GLfloat places[] = {-0.9F, 0.4F, -0.3F, 0.5F, -0.8F, 0.9F};
  const auto triangle = [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); };
  gl.VertexPointer(2, GL_FLOAT, 0, places);
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.PointSize(5);
  refine_uniformly(2, GL_LINEAR_OUTPUTS_ARK);
  for (const MapOf& map : maps_of) {
    gl.UseProgram(evaluated_program(t, map.value));
    set_evaluator(map, mesh.has_two, 0, false);
    gl.Disable(GL_ARK);
    const GLuint left = count_generated(mesh.draw);
    gl.Enable(GL_ARK);
    expect_evaluated(t, map, mesh.has_two, mesh.draw, mesh.draw, map.name, {.level = 0, .is_often = true});
    set_evaluator(map, mesh.has_two, 1, false);
    evaluated_currents();
    // Mesa 22 leaves components that a map of fewer coordinates lacks in the values of the next array draw.
    const auto beside = [&] {
      evaluated_currents();
      triangle();
      mesh.draw();
      evaluated_currents();
      triangle();
    };
    expect_as_plain(t, plain_draw(beside), beside, fmt::format("{}, between draws", map.name),
                    {.left = left, .is_often = true});
    disable_maps();
  }
  t.expect_no_error("the evaluator meshes");
}

}  // namespace

Cases evaluated_values_cases() {
  Cases cases;
  for (const EvaluatedCommand& command : evaluated_commands)
    cases.push_back({.name = fmt::format("ark.command.evaluated.{}", leaf_of_command(command.leaf)),
                     .clauses = {"10.R.2-1", "10.R.2-2"},
                     .plan =
                         "Evaluate positions, colours, normals and coordinates for vertices of strips and triangles, "
                         "directly and in lists called often, with maps that change between calls.",
                     .wrong = "An evaluated vertex keeps the values of an earlier map; an evaluated value is current.",
                     .apis = compat_only,
                     .check = [&command](Test& t) { check_evaluated(t, command); }});
  for (const EvaluatedMesh& mesh : evaluated_meshes)
    cases.push_back({.name = fmt::format("ark.command.evaluated.{}", leaf_of_command(mesh.leaf)),
                     .clauses = {"10.R.2-4", "10.R.2-1"},
                     .plan = "Draw an evaluator mesh alone, in a list, and between array draws; change its maps.",
                     .wrong = "The mesh is refined or lost; current values change; draws beside it are not refined.",
                     .apis = compat_only,
                     .check = [&mesh](Test& t) { check_evaluated_mesh(t, mesh); }});
  return cases;
}

}  // namespace glark::conformance
