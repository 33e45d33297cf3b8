// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Lists with many vertices, called between Begin and End: more than an implementation may collect at once.
#include <string>
#include <vector>

#include "conformance/cases/cases.h"
#include "conformance/support/counted.h"
#include "conformance/support/refined_draw.h"

namespace glark::conformance {
namespace {

constexpr int wide_inputs = 12;

// All inputs count: the colour is their sum.
GLuint wide_program(Test& t) {
  std::string inputs = "in vec4 position;";
  std::string sum;
  for (int i = 1; i <= wide_inputs; ++i) {
    inputs += " in vec4 wide" + as_text(i) + ";";
    sum += (i > 1 ? " + wide" : "wide") + as_text(i);
  }
  const GLuint program =
      build_program(t, {.vertex = inputs + "out vec4 colour; void main() { gl_Position = position; colour = vec4((" +
                                  sum + ").rgb / 12.0, 1.0); }"});
  gl.BindAttribLocation(program, 0, "position");
  for (int i = 1; i <= wide_inputs; ++i)
    gl.BindAttribLocation(program, static_cast<GLuint>(i), ("wide" + as_text(i)).c_str());
  gl.LinkProgram(program);
  return program;
}

// The last primitive is large, all others lie in a corner.
GLuint compile_many(GLenum mode, GLuint triangles) {
  const GLuint list = gl.GenLists(1);
  gl.NewList(list, GL_COMPILE);
  const GLuint corners = mode == GL_QUADS ? 4 : 3;
  const GLuint primitives = mode == GL_QUADS ? triangles / 2 : triangles;
  constexpr GLfloat places[4][2] = {{-0.9F, -0.9F}, {0.9F, -0.9F}, {0.9F, 0.9F}, {-0.9F, 0.9F}};
  for (GLuint i = 0; i < primitives; ++i)
    for (GLuint corner = 0; corner < corners; ++corner) {
      const GLfloat size = i + 1 == primitives ? 1 : 0;
      gl.Vertex2f(places[corner][0] * size, places[corner][1] * size);
    }
  gl.EndList();
  return list;
}

// 60000 triangles have about 37 MB of inputs; the three lists, half of that.
struct LargeCall {
  const char* leaf;
  GLenum mode;
  int primitives_before;
  int lists;
  GLuint triangles;  // of each list
  bool is_one_call;
};
constexpr LargeCall large_calls[] = {{"triangles.first", GL_TRIANGLES, 0, 1, 60000, false},
                                     {"triangles.lists_in_one_call", GL_TRIANGLES, 1, 3, 10000, true},
                                     {"quads.after_others", GL_QUADS, 2, 1, 30000, false},
                                     {"quads.several_calls", GL_QUADS, 1, 3, 10000, false}};

void draw_large(const LargeCall& call, GLuint list) {
  gl.Begin(call.mode);
  for (int i = 0; i < call.primitives_before * (call.mode == GL_QUADS ? 4 : 3); ++i) gl.Vertex2f(0, 0);
  const std::vector<GLuint> lists(static_cast<std::size_t>(call.lists), list);
  if (call.is_one_call) {
    gl.CallLists(call.lists, GL_UNSIGNED_INT, lists.data());
  } else {
    for (const GLuint each : lists) gl.CallList(each);
  }
  gl.End();
}

void check_large(Test& t, const LargeCall& call) {
  gl.UseProgram(wide_program(t));
  for (GLuint i = 1; i <= wide_inputs; ++i) gl.VertexAttrib4f(i, 1, 0.5F, 0.25F, 1);
  const GLuint list = compile_many(call.mode, call.triangles);
  const auto draw = [&] { draw_large(call, list); };
  const Picture plain = picture_of(draw);
  const GLuint before = static_cast<GLuint>(call.primitives_before) * (call.mode == GL_QUADS ? 2 : 1);
  const GLuint coarse = before + static_cast<GLuint>(call.lists) * call.triangles;
  refine_uniformly(1);
  for (int again = 0; again < 2; ++again) {
    t.expect_equal(count_generated(draw), 4 * coarse, "refined triangles, drawn for time " + as_text(again));
    t.expect_same_picture(picture_of(draw), plain, "the picture, drawn for time " + as_text(again), 3, 40);
  }
  t.expect_no_error("the draws");
}

}  // namespace

Cases large_called_lists_cases() {
  Cases cases;
  for (const LargeCall& call : large_calls)
    cases.push_back({.name = std::string("ark.list.large.") + call.leaf,
                     .clauses = {"chapter-21-4", "10.R.2-1"},
                     .plan = "Call lists with many vertices between Begin and End. All triangles are refined, and the "
                             "last one is in the picture.",
                     .wrong = "What does not fit a buffer of fixed size is lost, the first time or always.",
                     .apis = compat_only,
                     .check = [&call](Test& t) { check_large(t, call); }});
  return cases;
}

}  // namespace glark::conformance
