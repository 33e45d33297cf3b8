// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Each message about draws is generated once for each program, or for each reason, whatever else changes; but only while
// DEBUG_OUTPUT is enabled.
#include <string>
#include <vector>

#include "conformance/cases/cases.h"
#include "conformance/cases/programs/refinement_source.h"
#include "conformance/cases/state/listener.h"
#include "conformance/support/capture.h"

namespace glark::conformance {
namespace {

void draw_once() { gl.DrawArrays(GL_TRIANGLES, 0, 3); }

GLuint program_without_normal(Test& t, const std::string& position = "position") {
  return build_program(t, {.vertex = "layout(location = 0) in vec4 position; uniform float shift; out vec4 colour;\n"
                                     "void main() { colour = vec4(1.0); gl_Position = " +
                                     position + " + vec4(shift, 0.0, 0.0, 0.0); }\n"});
}

struct ChangeBetween {
  const char* leaf;
  void (*change)();
};

const ChangeBetween changes_of_program[] = {
    {"tag_attribute", [] { gl.ARKParameteriARK(GL_DEPTH_TAG_ATTRIBUTE_ARK, 5); }},
    {"depth_source", [] { gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_DEPTH_TAG_ARK); }},
    {"level", [] { gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 0); }},
    {"refinement", [] { gl.ARKParameteriARK(GL_REFINEMENT_ARK, GL_PHONG_ARK); }},
    {"weld", [] { gl.ARKParameteriARK(GL_WELD_ARK, GL_TRUE); }},
    {"geomorph", [] { gl.ARKParameteriARK(GL_GEOMORPH_ARK, GL_TRUE); }},
    {"pool", [] { gl.ARKinit(3); }},
    {"enable",
     [] {
       gl.Disable(GL_ARK);
       draw_once();
       gl.Enable(GL_ARK);
     }},
    {"uniform", [] { gl.Uniform1f(0, 0.5F); }},
    {"arrays",
     [] {
       upload(one_triangle({1, 1, 1}));
     }},
    {"state",
     [] {
       gl.Enable(GL_DEPTH_TEST);
       gl.Enable(GL_BLEND);
       gl.Enable(GL_CULL_FACE);
     }},
};

const ChangeBetween changes_of_fixed_function[] = {
    {"tag_attribute", [] { gl.ARKParameteriARK(GL_DEPTH_TAG_ATTRIBUTE_ARK, 5); }},
    {"fog", [] { gl.Enable(GL_FOG); }},
    {"shade_model", [] { gl.ShadeModel(GL_FLAT); }},
    {"color_sum", [] { gl.Enable(GL_COLOR_SUM); }},
    {"clip_plane", [] { gl.Enable(GL_CLIP_PLANE0); }},
    {"texture", [] { gl.Enable(GL_TEXTURE_2D); }},
    {"matrix",
     [] {
       gl.MatrixMode(GL_MODELVIEW);
       gl.Scalef(0.5F, 0.5F, 0.5F);
     }},
    {"lighting",
     [] {
       gl.Enable(GL_LIGHTING);
       draw_once();
       gl.Disable(GL_LIGHTING);
     }},
    {"point_size", [] { gl.Enable(GL_VERTEX_PROGRAM_POINT_SIZE); }},
    {"normalize", [] { gl.Enable(GL_NORMALIZE); }},
};

// One message 3 at the first draw, and none after the change.
void expect_one(Test& t, const ChangeBetween& between) {
  Listener listener;
  draw_once();
  expect_message(t, listener.take(3), false, "the first draw");
  between.change();
  for (int again = 0; again < 2; ++again) draw_once();
  t.expect_equal(listener.take(3).size(), std::size_t{0}, "messages after the change");
  t.expect_no_error("the draws");
}

void check_program(Test& t, const ChangeBetween& between) {
  gl.UseProgram(program_without_normal(t));
  upload(one_triangle());
  refine_uniformly(1, GL_CURVED_PN_ARK);
  expect_one(t, between);
}

void check_fixed_function(Test& t, const ChangeBetween& between) {
  const float places[] = {-0.5F, -0.5F, 0.5F, -0.5F, 0, 0.5F};
  gl.VertexPointer(2, GL_FLOAT, 0, places);
  gl.EnableClientState(GL_VERTEX_ARRAY);
  refine_uniformly(1, GL_CURVED_PN_ARK);
  expect_one(t, between);
}

// The reason for a message, with what makes it.
struct LateMessage {
  const char* leaf;
  GLuint id;
  void (*prepare)(Test&);
  std::vector<std::string> clauses;
};

void prepare_numbered(Test& t, const char* shader) {
  const GLuint program = program_without_normal(t, "position + vec4(0.001 * float(gl_VertexID))");
  if (shader != nullptr) give(program, shader);
  gl.UseProgram(program);
}

const LateMessage late_messages[] = {
    {"unrefined",
     2,
     [](Test& t) {
       const GLuint program = program_without_normal(t);
       give(program, "void refine() { undeclared = 1.0; }");
       gl.UseProgram(program);
     },
     {"chapter-20-2", "chapter-20-22"}},
    {"other_refinement",
     3,
     [](Test& t) {
       gl.UseProgram(program_without_normal(t));
       gl.ARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);
     },
     {"chapter-20-2", "chapter-20-20"}},
    {"ignored_shader",
     4,
     [](Test& t) { prepare_numbered(t, "void refine() { position.x += 0.1; }"); },
     {"chapter-20-2", "chapter-20-20"}},
    {"not_displaced",
     5,
     [](Test& t) {
       gl.UseProgram(program_without_normal(t));
       gl.ARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, 0);
     },
     {"chapter-20-2", "chapter-20-20"}},
};

// Draws while DEBUG_OUTPUT is disabled use up no message.
void check_enabled_late(Test& t, const LateMessage& late) {
  upload(one_triangle());
  refine_uniformly(1);
  late.prepare(t);
  Listener listener;
  gl.Disable(GL_DEBUG_OUTPUT);
  for (int again = 0; again < 2; ++again) draw_once();
  t.expect_equal(listener.take_all().size(), std::size_t{0}, "messages while DEBUG_OUTPUT is disabled");
  gl.Enable(GL_DEBUG_OUTPUT);
  draw_once();
  expect_message(t, listener.take(late.id), false, "the first draw with DEBUG_OUTPUT");
  draw_once();
  t.expect_equal(listener.take(late.id).size(), std::size_t{0}, "messages of the second draw");
}

}  // namespace

Cases messages_once_cases() {
  Cases cases;
  for (const ChangeBetween& between : changes_of_program)
    cases.push_back({.name = std::string("ark.message.once.program.") + between.leaf,
                     .clauses = {"chapter-20-20", "chapter-20-21"},
                     .plan = "Draw curved triangles without a normal, change something else, and draw again.",
                     .wrong = "The program is told of again.",
                     .check = [&between](Test& t) { check_program(t, between); }});
  for (const ChangeBetween& between : changes_of_fixed_function)
    cases.push_back({.name = std::string("ark.message.once.fixed.") + between.leaf,
                     .clauses = {"chapter-20-20", "chapter-20-21"},
                     .plan = "The same with the fixed function and its states.",
                     .wrong = "Each state of the fixed function is told of as a program of its own.",
                     .apis = compat_only,
                     .check = [&between](Test& t) { check_fixed_function(t, between); }});
  for (const LateMessage& late : late_messages)
    cases.push_back({.name = std::string("ark.message.late.") + late.leaf,
                     .clauses = late.clauses,
                     .plan = "Draw while DEBUG_OUTPUT is disabled; then enable it and draw twice.",
                     .wrong = "The first draw used up the message.",
                     .check = [&late](Test& t) { check_enabled_late(t, late); }});
  return cases;
}

}  // namespace glark::conformance
