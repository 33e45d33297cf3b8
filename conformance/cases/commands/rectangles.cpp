// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Rect* in each of its forms, alone, in lists and between refined draws: it is drawn as without the extension, and
// draws around it are refined.
#include <fmt/core.h>

#include <array>

#include "conformance/cases/cases.h"
#include "conformance/cases/commands/as_plain.h"

namespace glark::conformance {
namespace {

constexpr GLuint rectangle_list = 41;

struct RectangleCommand {
  const char* leaf;
  void (*draw)(int x1, int y1, int x2, int y2);  // in eighths of the viewport, by the matrix of use_eighths()
};

template <typename Number>
struct RectangleCorners {
  std::array<Number, 2> first;
  std::array<Number, 2> second;
};
template <typename Number>
RectangleCorners<Number> corners_as(int x1, int y1, int x2, int y2) {
  return {{static_cast<Number>(x1), static_cast<Number>(y1)}, {static_cast<Number>(x2), static_cast<Number>(y2)}};
}

constexpr RectangleCommand rectangle_commands[] = {
    {"Rectd", [](int x1, int y1, int x2, int y2) { gl.Rectd(x1, y1, x2, y2); }},
    {"Rectdv",
     [](int x1, int y1, int x2, int y2) {
       const auto at = corners_as<GLdouble>(x1, y1, x2, y2);
       gl.Rectdv(at.first.data(), at.second.data());
     }},
    {"Rectf",
     [](int x1, int y1, int x2, int y2) {
       const auto at = corners_as<GLfloat>(x1, y1, x2, y2);
       gl.Rectf(at.first[0], at.first[1], at.second[0], at.second[1]);
     }},
    {"Rectfv",
     [](int x1, int y1, int x2, int y2) {
       const auto at = corners_as<GLfloat>(x1, y1, x2, y2);
       gl.Rectfv(at.first.data(), at.second.data());
     }},
    {"Recti", [](int x1, int y1, int x2, int y2) { gl.Recti(x1, y1, x2, y2); }},
    {"Rectiv",
     [](int x1, int y1, int x2, int y2) {
       const auto at = corners_as<GLint>(x1, y1, x2, y2);
       gl.Rectiv(at.first.data(), at.second.data());
     }},
    {"Rects",
     [](int x1, int y1, int x2, int y2) {
       const auto at = corners_as<GLshort>(x1, y1, x2, y2);
       gl.Rects(at.first[0], at.first[1], at.second[0], at.second[1]);
     }},
    {"Rectsv",
     [](int x1, int y1, int x2, int y2) {
       const auto at = corners_as<GLshort>(x1, y1, x2, y2);
       gl.Rectsv(at.first.data(), at.second.data());
     }},
};

void use_eighths() {
  gl.MatrixMode(GL_MODELVIEW);
  gl.LoadIdentity();
  gl.Scalef(0.125F, 0.125F, 1);
}

// Moves all points between corners, so that refinement shows.
GLuint bending_program(Test& t) {
  return build_program(t, {.vertex = "out vec4 colour; void main() { colour = gl_Color;\n"
                                     "  vec4 p = gl_ModelViewProjectionMatrix * gl_Vertex;\n"
                                     "  gl_Position = vec4(p.x + 0.2 * cos(4.0 * p.y), p.y + 0.2 * cos(3.0 * p.x), "
                                     "0.0, 1.0); }\n"});
}

void triangle_at(float x) {
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 3; ++i) {
    gl.Color3f(i == 0 ? 0.9F : 0.2F, i == 1 ? 0.8F : 0.1F, 0.3F);
    gl.Vertex2f(x + (i == 1 ? 4.0F : 0.0F), i == 2 ? 6.0F : -5.0F);
  }
  gl.End();
}

constexpr GLfloat array_corners[] = {-7, 5, -3, 5.5F, -6, 7.5F};

void use_array() {
  gl.VertexPointer(2, GL_FLOAT, 0, array_corners);
  gl.EnableClientState(GL_VERTEX_ARRAY);
}

std::array<GLfloat, 4> current_colour() {
  std::array<GLfloat, 4> colour{};
  gl.GetFloatv(GL_CURRENT_COLOR, colour.data());
  return colour;
}

void compile_rectangle(const std::function<void()>& commands) {
  gl.NewList(rectangle_list, GL_COMPILE);
  commands();
  gl.EndList();
}

void call_rectangle() { gl.CallList(rectangle_list); }

// Rectangles alone: every bit is that of the unrefined draw. Corners in each order face the front or the back.
void expect_left(Test& t, const RectangleCommand& command) {
  gl.UseProgram(bending_program(t));
  const auto draw = [&command] {
    gl.Color3f(0.9F, 0.4F, 0.2F);
    command.draw(-6, -5, -1, 4);
    gl.Color3f(0.2F, 0.4F, 0.8F);
    command.draw(6, -3, 2, 5);
  };
  compile_rectangle(draw);
  for (const bool is_list : {false, true})
    for (const GLenum culled : {GL_NONE, GL_BACK, GL_FRONT}) {
      culled == GL_NONE ? gl.Disable(GL_CULL_FACE) : gl.Enable(GL_CULL_FACE);
      if (culled != GL_NONE) gl.CullFace(culled);
      const std::function<void()> drawn = is_list ? std::function<void()>(call_rectangle) : draw;
      const PlainDraw plain = plain_draw(drawn);
      const std::string what = fmt::format("{}, culled 0x{:x}", is_list ? "a list" : "direct", culled);
      expect_as_plain(t, plain, drawn, what, {.level = 0, .is_often = true});
      t.expect_same_picture(picture_of(drawn), plain.picture, what + ", by bits");
    }
  gl.Disable(GL_CULL_FACE);
  gl.UseProgram(0);
}

// Refined draws before and after a rectangle: in one frame, as a list, and by arrays that are kept.
void expect_between(Test& t, const RectangleCommand& command) {
  const auto draw = [&command] {
    triangle_at(-7);
    command.draw(-2, -5, 1, 4);
    triangle_at(2);
    command.draw(7, 6, 2, 2);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
  };
  const auto in_list = [&command] {
    triangle_at(-7);
    command.draw(-2, -5, 1, 4);
    triangle_at(2);
  };
  compile_rectangle(in_list);
  GLuint rectangles = 0;
  gl.Disable(GL_ARK);
  rectangles = count_generated([&command] { command.draw(-2, -5, 1, 4); });
  gl.Enable(GL_ARK);
  gl.Color3f(0.3F, 0.9F, 0.4F);
  expect_as_plain(t, plain_draw(draw), draw, "between draws", {.left = 2 * rectangles, .is_often = true});
  // A list that cannot be taken apart is drawn unrefined (10.R.2-4): only its picture is known.
  const PlainDraw plain = plain_draw(call_rectangle);
  for (int again = 0; again < 3; ++again) {
    t.expect_same_picture(picture_of(call_rectangle), plain.picture, "in a list with triangles", 4, 40);
    repeat_often(call_rectangle);
  }
  t.expect_no_error("rectangles between draws");
}

// A rectangle sets no current value, and the capture of a later draw has no rectangle.
void expect_nothing_left(Test& t, const RectangleCommand& command) {
  const auto draw = [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); };
  compile_rectangle([&command] { command.draw(-2, -5, 1, 4); });
  for (int turn = 0; turn < 4; ++turn) {
    const std::array<GLfloat, 4> colour = {0.125F * static_cast<float>(turn), 0.75F, 0.5F, 1};
    gl.Color4fv(colour.data());
    const PlainDraw plain = plain_draw(draw);
    turn % 2 == 0 ? command.draw(-2, -5, 1, 4) : call_rectangle();
    t.expect(current_colour() == colour, "the current colour after a rectangle");
    expect_as_plain(t, plain, draw, "a draw after a rectangle");
  }
  gl.UseProgram(build_program(t, {.vertex = "out vec4 colour; out vec4 place;\n"
                                            "void main() { colour = gl_Color; place = gl_Vertex;\n"
                                            "  gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }\n",
                                  .captured = {"place"}}));
  for (int again = 0; again < 3; ++again) {
    command.draw(-2, -5, 1, 4);
    t.expect_equal(capture_bytes(t, sizeof(Vec4), 3, 1000, GL_TRIANGLES, draw).size() / (3 * sizeof(Vec4)),
                   std::size_t{16}, "triangles captured after a rectangle");
  }
  gl.UseProgram(0);
}

// GL refuses a rectangle between Begin and End; the vertices around it are drawn.
void expect_refused_within(Test& t, const RectangleCommand& command) {
  const auto draw = [&command] {
    gl.Color3f(0.8F, 0.6F, 0.1F);
    gl.Begin(GL_TRIANGLES);
    gl.Vertex2f(-5, -5);
    gl.Vertex2f(5, -4);
    command.draw(-6, -6, 6, 6);
    gl.Vertex2f(1, 6);
    gl.End();
  };
  const PlainDraw plain = plain_draw(draw);
  t.expect_equal(plain.error, GLenum{GL_INVALID_OPERATION}, "the unrefined error between Begin and End");
  expect_as_plain(t, plain, draw, "between Begin and End");
}

void check_rectangles(Test& t, const RectangleCommand& command) {
  use_eighths();
  refine_uniformly(2, GL_LINEAR_OUTPUTS_ARK);
  use_array();
  expect_left(t, command);
  expect_between(t, command);
  expect_nothing_left(t, command);
  expect_refused_within(t, command);
  t.expect_no_error("the rectangles");
}

}  // namespace

Cases rectangles_cases() {
  Cases cases;
  for (const RectangleCommand& command : rectangle_commands)
    cases.push_back({.name = fmt::format("ark.command.rectangle.{}", leaf_of_command(command.leaf)),
                     .clauses = {"10.R.2-4", "10.R.2-1"},
                     .plan =
                         "Draw rectangles alone, in lists, between refined draws, and between Begin and End. Compare "
                         "pictures, counts and errors with the unrefined ones, and capture a later draw.",
                     .wrong = "A rectangle is refined, refused or lost; a draw after it has its vertices.",
                     .apis = compat_only,
                     .check = [&command](Test& t) { check_rectangles(t, command); }});
  return cases;
}

}  // namespace glark::conformance
