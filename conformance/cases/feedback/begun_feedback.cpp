// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Transform feedback between its beginning and the first refined draw: what counts is the state at the draw, what GL
// refuses begins nothing, and what is not refined is captured as it is.
#include <fmt/core.h>

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "conformance/cases/cases.h"
#include "conformance/support/surface.h"

namespace glark::conformance {
namespace {

struct FeedbackVertex {
  Vec4 position;
  Vec4 colour;
  bool operator==(const FeedbackVertex&) const = default;
};

// Its colour is that of the provoking corner.
GLuint feedback_program(Test& t, const std::vector<const char*>& captured = {"gl_Position", "colour"}) {
  return build_program(
      t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 1) in vec3 normal;\n"
                    "layout(location = 3) in vec4 vertex_colour; flat out vec4 colour;\n"
                    "void main() { colour = vertex_colour + 0.001 * normal.x; gl_Position = position; }\n",
          .fragment = "flat in vec4 colour; out vec4 pixel; void main() { pixel = colour; }\n",
          .captured = captured});
}

void draw_mesh() { gl.DrawArrays(GL_TRIANGLES, 0, 6); }

Mesh coloured_mesh() {
  Mesh mesh = bent_mesh();
  for (std::size_t i = 0; i < mesh.size(); ++i)
    mesh[i].colour = {0.1F * static_cast<float>(i), 1.0F - 0.1F * static_cast<float>(i), 0.3F, 1};
  return mesh;
}

GLuint set_up_feedback(Test& t) {
  const GLuint program = feedback_program(t);
  gl.UseProgram(program);
  upload(coloured_mesh(), false);
  refine_uniformly(2);
  return program;
}

using Vertices = std::vector<FeedbackVertex>;
Vertices captured(Test& t, const std::function<void()>& draw) { return capture_as<FeedbackVertex>(t, 4000, draw); }

void expect_vertices(Test& t, const Vertices& found, const Vertices& expected, const std::string& what) {
  t.expect_equal(found.size() / 3, expected.size() / 3, what + ": triangles");
  t.expect(found == expected, what + ": the vertices");
}

// Something that changes after BeginTransformFeedback, before the first draw.
struct LateChange {
  const char* leaf;
  void (*change)();
  void (*before)() = [] {};  // the state at BeginTransformFeedback
};

const LateChange late_changes[] = {
    {"outputs", [] { gl.ARKParameteriARK(GL_REFINEMENT_ARK, GL_LINEAR_OUTPUTS_ARK); }},
    {"curved", [] { gl.ARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK); }},
    {"scalar_tagged", [] { gl.ARKParameteriARK(GL_REFINEMENT_ARK, GL_SCALAR_TAGGED_PN_ARK); }},
    {"phong", [] { gl.ARKParameteriARK(GL_REFINEMENT_ARK, GL_PHONG_ARK); }},
    {"inputs_of_curved", [] { gl.ARKParameteriARK(GL_REFINEMENT_ARK, GL_LINEAR_INPUTS_ARK); },
     [] { gl.ARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK); }},
    {"level", [] { gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 3); }},
    {"deep_level", [] { gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 2); },
     [] { gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 0); }},
    {"level_0", [] { gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 0); }},
    {"tags", [] { gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_DEPTH_TAG_ARK); }},
    {"uniform", [] { gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK); },
     [] { gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_DEPTH_TAG_ARK); }},
    {"welded",
     [] {
       gl.ARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);
       gl.ARKParameteriARK(GL_WELD_ARK, GL_TRUE);
     }},
    {"geomorph", [] { gl.ARKParameteriARK(GL_GEOMORPH_ARK, GL_TRUE); }},
    {"enabled", [] { gl.Enable(GL_ARK); }, [] { gl.Disable(GL_ARK); }},
    {"disabled", [] { gl.Disable(GL_ARK); }},
    {"tag_attribute", [] { gl.ARKParameteriARK(GL_DEPTH_TAG_ATTRIBUTE_ARK, 9); }},
};

void check_late(Test& t, const LateChange& late) {
  set_up_feedback(t);
  gl.ARKinit(4);
  gl.DepthTag1i(1);
  late.before();
  const Vertices found = captured(t, [&] {
    late.change();
    draw_mesh();
    draw_mesh();
  });
  const Vertices expected = captured(t, [&] {
    draw_mesh();
    draw_mesh();
  });
  expect_vertices(t, found, expected, late.leaf);
}

// What makes GL refuse BeginTransformFeedback.
struct Refusal {
  const char* leaf;
  void (*refuse)(Test&);
};

const Refusal refusals_of_begin[] = {
    {"no_buffer", [](Test&) { gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0); }},
    {"no_varyings", [](Test& t) { gl.UseProgram(feedback_program(t, {})); }},
    {"no_program", [](Test&) { gl.UseProgram(0); }},
};

void check_refused_begin(Test& t, const Refusal& refusal) {
  const GLuint program = set_up_feedback(t);
  const GLuint other = feedback_program(t);
  const Vertices expected = captured(t, draw_mesh);
  GLuint own = 0;
  gl.GenBuffers(1, &own);
  gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, own);
  gl.BufferData(GL_TRANSFORM_FEEDBACK_BUFFER, 4096, nullptr, GL_STREAM_READ);
  refusal.refuse(t);
  gl.BeginTransformFeedback(GL_TRIANGLES);
  t.expect_error(GL_INVALID_OPERATION, "BeginTransformFeedback");
  GLint active = 7;
  gl.GetIntegerv(GL_TRANSFORM_FEEDBACK_ACTIVE, &active);
  t.expect_equal(active, 0, "TRANSFORM_FEEDBACK_ACTIVE");
  draw_mesh();
  gl.UseProgram(other);
  gl.UseProgram(program);
  gl.LinkProgram(program);
  t.expect_no_error("a draw, UseProgram and LinkProgram after the refusal");
  gl.PauseTransformFeedback();
  t.expect_error(GL_INVALID_OPERATION, "PauseTransformFeedback");
  gl.EndTransformFeedback();
  t.expect_error(GL_INVALID_OPERATION, "EndTransformFeedback");
  expect_vertices(t, captured(t, draw_mesh), expected, "the next feedback");
}

void check_other_program(Test& t, bool has_drawn) {
  const GLuint program = set_up_feedback(t);
  const GLuint other = feedback_program(t);
  const auto draw_before = [&] {
    if (has_drawn) draw_mesh();
  };
  const Vertices expected = captured(t, [&] {
    draw_before();
    draw_mesh();
  });
  const Vertices found = captured(t, [&] {
    draw_before();
    gl.PauseTransformFeedback();
    gl.UseProgram(other);
    draw_mesh();
    for (const GLuint wrong : {other, 0U}) {
      gl.UseProgram(wrong);
      gl.ResumeTransformFeedback();
      t.expect_error(GL_INVALID_OPERATION, "ResumeTransformFeedback with another program");
      GLint paused = 7;
      gl.GetIntegerv(GL_TRANSFORM_FEEDBACK_PAUSED, &paused);
      t.expect_equal(paused, 1, "TRANSFORM_FEEDBACK_PAUSED");
    }
    gl.UseProgram(program);
    gl.ResumeTransformFeedback();
    t.expect_no_error("ResumeTransformFeedback with the first program");
    draw_mesh();
  });
  expect_vertices(t, found, expected, "what was captured");
}

void plain(const std::function<void()>& draw) {
  gl.Disable(GL_ARK);
  draw();
  gl.Enable(GL_ARK);
}

// Draws that are never refined. Those of adjacency need no geometry shader.
struct CoarseDraw {
  const char* leaf;
  void (*draw)();
  Apis apis;
};

void draw_indirectly(GLenum mode, GLuint vertices, bool is_indexed) {
  const std::array<GLuint, 5> command{vertices, 1, 0, 0, 0};
  const std::array<GLubyte, 6> order{0, 1, 2, 3, 4, 5};
  GLuint buffers[2] = {};
  gl.GenBuffers(2, buffers);
  gl.BindBuffer(GL_DRAW_INDIRECT_BUFFER, buffers[0]);
  gl.BufferData(GL_DRAW_INDIRECT_BUFFER, sizeof command, command.data(), GL_STATIC_DRAW);
  if (is_indexed) {
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
    gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof order, order.data(), GL_STATIC_DRAW);
    gl.DrawElementsIndirect(mode, GL_UNSIGNED_BYTE, nullptr);
  } else {
    gl.DrawArraysIndirect(mode, nullptr);
  }
  gl.BindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
}

void draw_evaluated() {
  const float points[] = {-0.9F, -0.9F, 0.2F, 0.8F, -0.7F, 0.1F, -0.6F, 0.9F, -0.3F, 0.7F, 0.6F, 0.4F};
  gl.Map2f(GL_MAP2_VERTEX_3, 0, 1, 3, 2, 0, 1, 6, 2, points);
  gl.Enable(GL_MAP2_VERTEX_3);
  gl.MapGrid2f(2, 0, 1, 2, 0, 1);
  gl.EvalMesh2(GL_FILL, 0, 2, 0, 2);
  gl.Disable(GL_MAP2_VERTEX_3);
}

void draw_listed() {
  gl.NewList(9, GL_COMPILE);
  gl.Rectf(-0.5F, -0.5F, 0.25F, 0.75F);
  gl.EndList();
  gl.CallList(9);
}

constexpr Apis desktop = {Api::gl_compat, Api::gl_core};
const CoarseDraw coarse_draws[] = {
    {"rect_d", [] { gl.Rectd(-0.5, -0.5, 0.5, 0.25); }, compat_only},
    {"rect_f", [] { gl.Rectf(-0.5F, -0.5F, 0.5F, 0.25F); }, compat_only},
    {"rect_i", [] { gl.Recti(-1, -1, 1, 0); }, compat_only},
    {"rect_s", [] { gl.Rects(-1, -1, 1, 0); }, compat_only},
    {"rect_in_list", draw_listed, compat_only},
    {"mesh", draw_evaluated, compat_only},
    {"adjacent_triangles", [] { gl.DrawArrays(GL_TRIANGLES_ADJACENCY, 0, 6); }, desktop},
    {"adjacent_strip", [] { gl.DrawArrays(GL_TRIANGLE_STRIP_ADJACENCY, 0, 6); }, desktop},
    {"adjacent_indirect", [] { draw_indirectly(GL_TRIANGLES_ADJACENCY, 6, false); }, desktop},
    {"adjacent_indirect_elements", [] { draw_indirectly(GL_TRIANGLES_ADJACENCY, 6, true); }, desktop},
};

void check_coarse(Test& t, const CoarseDraw& coarse) {
  set_up_feedback(t);
  Vertices expected;
  plain([&] { expected = captured(t, coarse.draw); });
  t.expect(!expected.empty(), "the control: GL captures the draw without ARK");
  expect_vertices(t, captured(t, coarse.draw), expected, "the draw alone");
  t.expect_no_error("the draw alone");
  // After a refined draw it need not be captured.
  const Vertices refined = captured(t, draw_mesh);
  Vertices mixed = captured(t, [&] {
    draw_mesh();
    coarse.draw();
  });
  t.expect_no_error("the draw after a refined one");
  t.expect(mixed.size() >= refined.size(), "the refined draw is captured");
  mixed.resize(refined.size());
  expect_vertices(t, mixed, refined, "the refined draw");
  // What follows it need not be refined.
  Vertices first = captured(t, [&] {
    coarse.draw();
    draw_mesh();
  });
  t.expect(first.size() >= expected.size() + 6, "the draw that follows is captured");
  first.resize(expected.size());
  expect_vertices(t, first, expected, "the draw before another one");
}

// A draw without ARK stays captured if DrawARP follows.
void check_plain_first(Test& t) {
  set_up_feedback(t);
  gl.Disable(GL_ARK);
  const Vertices expected = captured(t, draw_mesh);
  Vertices found = captured(t, [] {
    draw_mesh();
    gl.DrawARP(GL_TRIANGLES, 0, 6);
  });
  t.expect(found.size() >= 2 * expected.size(), "both draws are captured");
  found.resize(expected.size());
  expect_vertices(t, found, expected, "the plain draw");
}

// GL refuses these modes while triangles are captured, and is then not between Begin and End.
void check_refused_modes(Test& t, bool has_drawn) {
  set_up_feedback(t);
  const auto draw_before = [&] {
    if (has_drawn) draw_mesh();
  };
  const Vertices expected = captured(t, [&] {
    draw_before();
    draw_mesh();
  });
  const Vertices found = captured(t, [&] {
    draw_before();
    for (const GLenum mode : {GL_POINTS, GL_LINES, GL_LINE_LOOP, GL_LINE_STRIP}) {
      gl.Begin(mode);
      t.expect_error(GL_INVALID_OPERATION, fmt::format("Begin of mode {}", mode));
      gl.End();
      t.expect_error(GL_INVALID_OPERATION, fmt::format("End of mode {}", mode));
      gl.DrawArrays(mode, 0, 6);
      t.expect_error(GL_INVALID_OPERATION, fmt::format("DrawArrays of mode {}", mode));
    }
    draw_mesh();
  });
  expect_vertices(t, found, expected, "what was captured");
}

// The mode of a draw is no refinement parameter.
void check_mixed_modes(Test& t, GLenum convention) {
  gl.UseProgram(build_program(t, {.vertex = "layout(location = 0) in vec4 position; out vec4 colour;\n"
                                            "void main() { colour = position.yzxw; gl_Position = position; }\n",
                                  .fragment = "in vec4 colour; out vec4 pixel; void main() { pixel = colour; }\n",
                                  .captured = {"gl_Position", "colour"}}));
  upload(bent_mesh(), false);
  refine_uniformly(2);
  gl.ProvokingVertex(convention);
  const auto draw = [](GLenum mode) { return [mode] { gl.DrawArrays(mode, 0, mode == GL_QUADS ? 4 : 6); }; };
  std::vector<GLenum> modes = {GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN};
  if (t.is_compat())
    for (const GLenum mode : {GL_QUADS, GL_QUAD_STRIP, GL_POLYGON}) modes.push_back(mode);
  Vertices expected;
  for (int round = 0; round < 2; ++round) {
    for (const GLenum mode : modes) {
      const Vertices alone = captured(t, draw(mode));
      expected.insert(expected.end(), alone.begin(), alone.end());
    }
  }
  const Vertices found = captured(t, [&] {
    for (int round = 0; round < 2; ++round)
      for (const GLenum mode : modes) draw(mode)();
  });
  expect_vertices(t, found, expected, "all modes");
}

constexpr Area begun_case{"ark.after_vertex.begun."};

}  // namespace

Cases begun_feedback_cases() {
  Cases cases;
  for (const LateChange& late : late_changes)
    cases.push_back(begun_case(fmt::format("late.{}", late.leaf), {"chapter-14-5", "11.R.11-1"},
                               "A parameter changes between BeginTransformFeedback and two draws.",
                               "The draws are captured unrefined, or with the old parameter.",
                               [&late](Test& t) { check_late(t, late); }));
  for (const Refusal& refusal : refusals_of_begin)
    cases.push_back(begun_case(fmt::format("refused.{}", refusal.leaf), {"10.R.2-13", "chapter-14-6"},
                               "GL refuses BeginTransformFeedback; then the program draws and changes.",
                               "The feedback counts as active, and what follows raises errors.",
                               [&refusal](Test& t) { check_refused_begin(t, refusal); }));
  for (const bool has_drawn : {false, true})
    cases.push_back(begun_case(fmt::format("other_program.{}", has_drawn ? "after_draw" : "at_once"), {"10.R.2-13"},
                               "ResumeTransformFeedback while another program is in use, then with the first.",
                               "No error, or the first program cannot be used again.",
                               [has_drawn](Test& t) { check_other_program(t, has_drawn); }));
  for (const CoarseDraw& coarse : coarse_draws)
    cases.push_back(begun_case(
        fmt::format("coarse.{}", coarse.leaf), {"11.R.11-1", "10.R.2-13"},
        "Draws that are never refined, in feedback while ARK is enabled.", "An error, or nothing is captured.",
        [&coarse](Test& t) { check_coarse(t, coarse); }, coarse.apis));
  cases.push_back(begun_case("plain_first", {"chapter-14-5"}, "A draw without ARK, then DrawARP, in one feedback.",
                             "DrawARP begins the feedback again, and the first draw is lost.", check_plain_first));
  for (const bool has_drawn : {false, true})
    cases.push_back(begun_case(
        fmt::format("modes.{}", has_drawn ? "after_draw" : "at_once"), {"chapter-14-6"},
        "Begin and DrawArrays of points and lines while triangles are captured.",
        "No error, or the feedback is given up.", [has_drawn](Test& t) { check_refused_modes(t, has_drawn); },
        compat_only));
  for (const bool first : {false, true})
    cases.push_back(begun_case(
        fmt::format("mixed_modes.{}", first ? "first" : "last"), {"chapter-14-5"},
        "Draws of all modes of triangles in one feedback, with both conventions of the provoking vertex.",
        "What follows a draw of another mode is not captured, or unrefined.",
        [first](Test& t) { check_mixed_modes(t, first ? GL_FIRST_VERTEX_CONVENTION : GL_LAST_VERTEX_CONVENTION); },
        desktop));
  return cases;
}

}  // namespace glark::conformance
