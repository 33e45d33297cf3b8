// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What is set on a program after it was linked holds from the next link on, for transform feedback and for pipelines.
#include <cstring>
#include <string>
#include <vector>

#include "conformance/cases/cases.h"
#include "conformance/support/refined_draw.h"

namespace glark::conformance {
namespace {

constexpr GLsizeiptr feedback_bytes = 64 * 1024;

struct LaterSetting {
  const char* leaf;
  void (*set)(GLuint program);
};

void set_varyings(GLuint program, const std::vector<const char*>& names, GLenum mode) {
  gl.TransformFeedbackVaryings(program, static_cast<GLsizei>(names.size()), names.data(), mode);
}

constexpr LaterSetting later_settings[] = {
    {"mode",
     [](GLuint p) {
       set_varyings(p, {"gl_Position", "weight", "shade"}, GL_SEPARATE_ATTRIBS);
     }},
    {"order",
     [](GLuint p) {
       set_varyings(p, {"shade", "gl_Position", "weight"}, GL_INTERLEAVED_ATTRIBS);
     }},
    {"fewer", [](GLuint p) { set_varyings(p, {"shade"}, GL_INTERLEAVED_ATTRIBS); }},
    {"none", [](GLuint p) { set_varyings(p, {}, GL_INTERLEAVED_ATTRIBS); }},
    {"unknown_name",
     [](GLuint p) {
       set_varyings(p, {"nothing", "shade"}, GL_SEPARATE_ATTRIBS);
     }},
    {"separable", [](GLuint p) { gl.ProgramParameteri(p, GL_PROGRAM_SEPARABLE, GL_TRUE); }},
    {"attribute",
     [](GLuint p) {
       gl.BindAttribLocation(p, at_colour, "position");
       gl.BindAttribLocation(p, at_position, "colour");
     }},
};

GLuint set_later_program(Test& t, GLenum mode) {
  const GLuint program = build_program(
      t,
      {.vertex = "in vec4 position; in vec4 colour; out vec3 weight; out vec2 shade; out vec4 hue;"
                 "void main() { gl_Position = position; weight = colour.xyz * 2.0; shade = colour.wx; hue = colour; }",
       .fragment = "in vec4 hue; out vec4 pixel; void main() { pixel = hue; }",
       .captured = {"gl_Position", "weight", "shade"}});
  gl.BindAttribLocation(program, at_position, "position");
  gl.BindAttribLocation(program, at_colour, "colour");
  set_varyings(program, {"gl_Position", "weight", "shade"}, mode);
  gl.LinkProgram(program);
  gl.UseProgram(program);
  return program;
}

// All bytes of three buffers, after the feedback of one draw.
std::vector<unsigned char> feedback_of_draw(Test& t, const std::vector<GLuint>& buffers) {
  const std::vector<unsigned char> empty(feedback_bytes, 0xCC);
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, static_cast<GLuint>(i), buffers[i]);
    gl.BufferData(GL_TRANSFORM_FEEDBACK_BUFFER, feedback_bytes, empty.data(), GL_DYNAMIC_READ);
  }
  gl.BeginTransformFeedback(GL_TRIANGLES);
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  gl.EndTransformFeedback();
  t.expect_no_error("the captured draw");
  std::vector<unsigned char> all;
  for (const GLuint buffer : buffers) {
    gl.BindBuffer(GL_COPY_READ_BUFFER, buffer);
    const auto* bytes =
        static_cast<const unsigned char*>(gl.MapBufferRange(GL_COPY_READ_BUFFER, 0, feedback_bytes, GL_MAP_READ_BIT));
    all.insert(all.end(), bytes, bytes + feedback_bytes);
    gl.UnmapBuffer(GL_COPY_READ_BUFFER);
  }
  return all;
}

// The first program keeps its settings. `is_drawn`: the other is drawn refined before they change, too.
void check_later_setting(Test& t, const LaterSetting& later, GLenum mode, bool is_drawn) {
  upload(one_triangle());
  std::vector<GLuint> buffers(mode == GL_SEPARATE_ATTRIBS ? 3 : 1);
  gl.GenBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());
  const auto draw = [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); };
  refine_uniformly(2);
  set_later_program(t, mode);
  const std::vector<unsigned char> expected = feedback_of_draw(t, buffers);
  const Picture picture = conformance::picture_of(draw);
  const GLuint changed = set_later_program(t, mode);
  if (is_drawn) feedback_of_draw(t, buffers);
  later.set(changed);
  t.expect_no_error("the setting");
  for (int again = 0; again < 2; ++again) {
    t.expect(feedback_of_draw(t, buffers) == expected, "what is captured is what the last link set");
    t.expect_same_picture(conformance::picture_of(draw), picture, "the draw", 0, 0);
    t.expect_no_error("the draw");
    set_refinement_shader(t, changed, again == 0 ? "void refine() {}\n" : "");  // other programs are derived
  }
}

}  // namespace

Cases settings_after_link_cases() {
  Cases cases;
  for (const LaterSetting& later : later_settings)
    for (const GLenum mode : {GL_INTERLEAVED_ATTRIBS, GL_SEPARATE_ATTRIBS})
      for (const bool is_drawn : {false, true})
        cases.push_back(
            {.name = std::string("ark.after_vertex.feedback.set_later.") + later.leaf +
                     (mode == GL_SEPARATE_ATTRIBS ? ".separate" : ".interleaved") +
                     (is_drawn ? ".drawn_before" : ".first_draw"),
             .clauses = {"chapter-14-5", "10.R.2-2"},
             .plan = "Set other varyings, or another parameter, on a linked program, and do not link it "
                     "again. Feedback and picture are those of a program whose settings stay.",
             .wrong = "An implementation that links programs of its own asks the program for its settings "
                      "when it draws, and gets those for the next link.",
             .check = [&later, mode, is_drawn](Test& t) { check_later_setting(t, later, mode, is_drawn); }});
  return cases;
}

}  // namespace glark::conformance
