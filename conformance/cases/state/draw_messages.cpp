// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Messages about draws (chapter 20), for every way of drawing: message 2 of a draw that is left unrefined, for each of
// several reasons, and the messages of program 0, the fixed function.
#include <array>

#include "conformance/cases/cases.h"
#include "conformance/cases/programs/refinement_source.h"
#include "conformance/cases/state/listener.h"
#include "conformance/support/capture.h"

namespace glark::conformance {
namespace {

struct ToldWay {
  const char* leaf;
  void (*draw)();
  Apis apis = every_api;
};

constexpr GLsizei told_vertices = 3;

void told_begin() {
  gl.Begin(GL_TRIANGLES);
  for (const MeshVertex& vertex : one_triangle()) {
    gl.VertexAttrib4fv(at_colour, vertex.colour.data());
    gl.VertexAttrib4fv(at_position, vertex.position.data());
  }
  gl.End();
}

// Elements, commands and lists are those of prepare_ways().
constexpr ToldWay told_ways[] = {
    {"draw_arrays", [] { gl.DrawArrays(GL_TRIANGLES, 0, told_vertices); }},
    {"draw_elements", [] { gl.DrawElements(GL_TRIANGLES, told_vertices, GL_UNSIGNED_SHORT, nullptr); }},
    {"draw_range_elements",
     [] { gl.DrawRangeElements(GL_TRIANGLES, 0, 2, told_vertices, GL_UNSIGNED_SHORT, nullptr); }},
    {"draw_elements_base_vertex",
     [] { gl.DrawElementsBaseVertex(GL_TRIANGLES, told_vertices, GL_UNSIGNED_SHORT, nullptr, 0); }},
    {"draw_arrays_instanced", [] { gl.DrawArraysInstanced(GL_TRIANGLES, 0, told_vertices, 2); }},
    {"draw_elements_instanced",
     [] { gl.DrawElementsInstanced(GL_TRIANGLES, told_vertices, GL_UNSIGNED_SHORT, nullptr, 2); }},
    {"draw_arrays_indirect", [] { gl.DrawArraysIndirect(GL_TRIANGLES, nullptr); }},
    {"draw_elements_indirect", [] { gl.DrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_SHORT, nullptr); }},
    {"draw_arp", [] { gl.DrawARP(GL_TRIANGLES, 0, told_vertices); }},
    {"draw_arp_elements", [] { gl.DrawARPElementsARK(GL_TRIANGLES, told_vertices, GL_UNSIGNED_SHORT, nullptr); }},
    {"multi_draw_arrays",
     [] {
       constexpr GLint first = 0;
       gl.MultiDrawArrays(GL_TRIANGLES, &first, &told_vertices, 1);
     },
     desktop_apis},
    {"multi_draw_elements",
     [] {
       const void* const offset = nullptr;
       gl.MultiDrawElements(GL_TRIANGLES, &told_vertices, GL_UNSIGNED_SHORT, &offset, 1);
     },
     desktop_apis},
    {"multi_draw_arrays_indirect", [] { gl.MultiDrawArraysIndirect(GL_TRIANGLES, nullptr, 1, 0); }, desktop_apis},
    {"draw_arrays_instanced_base_instance",
     [] { gl.DrawArraysInstancedBaseInstance(GL_TRIANGLES, 0, told_vertices, 1, 0); }, desktop_apis},
    {"begin", told_begin, compat_only},
    {"begin_fan",
     [] {
       gl.Begin(GL_TRIANGLE_FAN);
       for (const MeshVertex& vertex : one_triangle()) gl.VertexAttrib4fv(at_position, vertex.position.data());
       gl.End();
     },
     compat_only},
    {"array_elements",
     [] {
       gl.Begin(GL_TRIANGLES);
       for (GLint i = 0; i < told_vertices; ++i) gl.ArrayElement(i);
       gl.End();
     },
     compat_only},
    {"call_list", [] { gl.CallList(1); }, compat_only},
    {"call_lists",
     [] {
       constexpr GLubyte one = 1;
       gl.CallLists(1, GL_UNSIGNED_BYTE, &one);
     },
     compat_only},
};

void prepare_ways(Test& t) {
  refine_uniformly(1);
  upload(one_triangle());
  constexpr GLushort indices[] = {0, 1, 2};
  constexpr GLuint command[] = {3, 1, 0, 0, 0};  // of arrays and of elements
  std::array<GLuint, 2> buffers{};
  gl.GenBuffers(2, buffers.data());
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[0]);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof(indices), indices, GL_STATIC_DRAW);
  gl.BindBuffer(GL_DRAW_INDIRECT_BUFFER, buffers[1]);
  gl.BufferData(GL_DRAW_INDIRECT_BUFFER, sizeof(command), command, GL_STATIC_DRAW);
  if (!t.is_compat()) return;
  gl.NewList(1, GL_COMPILE);
  told_begin();
  gl.EndList();
}

struct LeftReason {
  const char* leaf;
  std::vector<std::string> clauses;
  void (*enter)(GLuint program);
  void (*leave)();
  Apis apis = every_api;
};

void nothing() {}

void enable_assembly(GLuint) {
  const std::string text =
      "!!ARBvp1.0\nMOV result.position, vertex.attrib[0];\nMOV result.color, vertex.attrib[3];\nEND\n";
  GLuint name = 0;
  gl.GenProgramsARB(1, &name);
  gl.BindProgramARB(GL_VERTEX_PROGRAM_ARB, name);
  gl.ProgramStringARB(GL_VERTEX_PROGRAM_ARB, GL_PROGRAM_FORMAT_ASCII_ARB, static_cast<GLsizei>(text.size()),
                      text.c_str());
  gl.UseProgram(0);
  gl.Enable(GL_VERTEX_PROGRAM_ARB);
}

std::array<GLfloat, 4096> feedback_values;
std::array<GLuint, 64> selected_names;

const std::vector<LeftReason>& left_reasons() {
  static const std::vector<LeftReason> all = {
      {"shader_error",
       {"chapter-20-5", "chapter-20-22", "chapter-20-15"},
       [](GLuint program) { give(program, "void refine() { position.x += not_declared; }"); },
       nothing},
      {"assembly",
       {"chapter-20-5", "chapter-20-22"},
       enable_assembly,
       [] { gl.Disable(GL_VERTEX_PROGRAM_ARB); },
       compat_only},
      {"feedback",
       {"chapter-20-5", "chapter-20-22"},
       [](GLuint) {
         gl.FeedbackBuffer(static_cast<GLsizei>(feedback_values.size()), GL_2D, feedback_values.data());
         gl.RenderMode(GL_FEEDBACK);
       },
       [] { gl.RenderMode(GL_RENDER); },
       compat_only},
      {"select",
       {"chapter-20-5", "chapter-20-22"},
       [](GLuint) {
         gl.SelectBuffer(static_cast<GLsizei>(selected_names.size()), selected_names.data());
         gl.RenderMode(GL_SELECT);
       },
       [] { gl.RenderMode(GL_RENDER); },
       compat_only},
  };
  return all;
}

// Each way has a context of its own, so that its draw is the first.
void check_left(Test& t, const LeftReason& reason) {
  for (const ToldWay& way : told_ways) {
    if (!way.apis.contains(t.api())) continue;
    const std::unique_ptr<Context> context = t.create_context();
    const std::string what = way.leaf;
    prepare_ways(t);
    Listener listener;
    const GLuint program = colour_program(t);
    gl.UseProgram(program);
    way.draw();
    t.expect_equal(listener.take(2).size(), 0U, what + ": messages about a refined draw");
    reason.enter(program);
    gl.Disable(GL_ARK);
    if (!what.starts_with("draw_arp")) way.draw();
    t.expect_equal(listener.take(2).size(), 0U, what + ": messages while ARK is disabled");
    gl.Enable(GL_ARK);
    way.draw();
    const Messages messages = listener.take(2);
    if (t.expect_equal(messages.size(), 1U, what + ": messages of the first draw")) {
      expect_message(t, messages, false, what);
      if (std::string(reason.leaf) == "shader_error")
        t.expect(has(messages[0].text, "not_declared"), what + ": the message includes the log");
    }
    way.draw();
    t.expect_equal(listener.take(2).size(), 0U, what + ": messages of the second draw");
    reason.leave();
    t.expect_no_error(what);
  }
}

// The stages after the fixed function's vertex stage.
struct BesideFixed {
  const char* leaf;
  void (*use)(Test&);
};

GLuint fragment_alone(Test& t) {
  std::string log;
  const GLuint shader = gl.CreateShader(GL_FRAGMENT_SHADER);
  const char* const text = "#version 120\nvoid main() { gl_FragColor = gl_Color; }\n";
  gl.ShaderSource(shader, 1, &text, nullptr);
  gl.CompileShader(shader);
  const GLuint program = gl.CreateProgram();
  gl.AttachShader(program, shader);
  gl.LinkProgram(program);
  GLint is_linked = 0;
  gl.GetProgramiv(program, GL_LINK_STATUS, &is_linked);
  if (is_linked == 0) t.internal_error("a program of a fragment shader does not link");
  return program;
}

constexpr BesideFixed beside_fixed[] = {
    {"alone", [](Test&) { gl.UseProgram(0); }},
    {"fragment_shader", [](Test& t) { gl.UseProgram(fragment_alone(t)); }},
    {"fragment_program",
     [](Test&) {
       const std::string text = "!!ARBfp1.0\nMOV result.color, fragment.color;\nEND\n";
       GLuint name = 0;
       gl.GenProgramsARB(1, &name);
       gl.BindProgramARB(GL_FRAGMENT_PROGRAM_ARB, name);
       gl.ProgramStringARB(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_FORMAT_ASCII_ARB, static_cast<GLsizei>(text.size()),
                           text.c_str());
       gl.Enable(GL_FRAGMENT_PROGRAM_ARB);
     }},
};

void draw_fixed_triangle() {
  gl.Begin(GL_TRIANGLES);
  for (const MeshVertex& vertex : one_triangle()) {
    gl.Color4fv(vertex.colour.data());
    gl.Vertex4fv(vertex.position.data());
  }
  gl.End();
}

void draw_fixed_arrays() {
  static Mesh mesh = one_triangle();
  gl.VertexPointer(4, GL_FLOAT, sizeof(MeshVertex), mesh[0].position.data());
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

// Whether the fixed function has a normal while lighting is disabled is left open: then there may be message 3 or not.
// Once it was generated, it is generated again after each RefinementShaderSourceARK of program 0, and only then.
void check_fixed_notes(Test& t, const BesideFixed& beside) {
  for (const auto draw : {draw_fixed_triangle, draw_fixed_arrays})
    for (const GLenum refinement : {GL_CURVED_PN_ARK, GL_SCALAR_TAGGED_PN_ARK, GL_PHONG_ARK}) {
      const std::unique_ptr<Context> context = t.create_context();
      beside.use(t);
      refine_uniformly(1, refinement);
      Listener listener;
      draw();
      const std::size_t first = listener.take(3).size();
      t.expect(first <= 1, "one message for a draw, there are " + as_text(first));
      draw();
      t.expect_equal(listener.take(3).size(), 0U, "messages of the second draw");
      for (const char* const source : {"void refine() { gl_Vertex.x += 0.0; }", "void refine() { }", ""}) {
        give(0, source);
        draw();
        t.expect_equal(listener.take(3).size(), first, "messages after RefinementShaderSourceARK");
        draw();
        t.expect_equal(listener.take(3).size(), 0U, "messages of the second draw after it");
      }
      t.expect_no_error("the draws");
    }
}

// The fixed function has all that displacement needs, and reads nothing that tells vertices apart.
void check_fixed_silence(Test& t, const BesideFixed& beside) {
  beside.use(t);
  refine_uniformly(1);
  Listener listener;
  gl.ARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, 0);
  give(0, "void refine() { gl_Vertex.x += 0.0; }");
  for (const GLenum refinement : {GL_LINEAR_INPUTS_ARK, GL_CURVED_PN_ARK, GL_PHONG_ARK})
    for (const auto draw : {draw_fixed_triangle, draw_fixed_arrays}) {
      gl.ARKParameteriARK(GL_REFINEMENT_ARK, static_cast<GLint>(refinement));
      draw();
      for (const Message& message : listener.take_all())
        t.expect(message.id != 2 && message.id != 4 && message.id != 5, "no message " + as_text(message.id));
    }
  t.expect_no_error("the draws");
}

}  // namespace

Cases draw_messages_cases() {
  Cases cases;
  for (const LeftReason& reason : left_reasons())
    cases.push_back({.name = std::string("ark.message.left.") + reason.leaf,
                     .clauses = reason.clauses,
                     .plan = "Draw in every way, in a context of its own: refined, while ARK is disabled, and left "
                             "unrefined for this reason, twice.",
                     .wrong = "One way of drawing is silent, or has a message for each draw.",
                     .apis = reason.apis,
                     .check = [&reason](Test& t) { check_left(t, reason); }});
  for (const BesideFixed& beside : beside_fixed) {
    cases.push_back({.name = std::string("ark.message.fixed.again.") + beside.leaf,
                     .clauses = {"chapter-20-20", "chapter-20-21"},
                     .plan = "Draw curved triangles of the fixed function, and change its refinement shader.",
                     .wrong = "Program 0 is told of once for all time, or at each draw.",
                     .apis = compat_only,
                     .check = [&beside](Test& t) { check_fixed_notes(t, beside); }});
    cases.push_back({.name = std::string("ark.message.fixed.silent.") + beside.leaf,
                     .clauses = {"11.R.7b-7", "chapter-20-17", "chapter-20-18"},
                     .plan = "Displace the fixed function, with a refinement shader.",
                     .wrong = "A message says that it is not displaced, or ignores its shader.",
                     .apis = compat_only,
                     .check = [&beside](Test& t) { check_fixed_silence(t, beside); }});
  }
  return cases;
}

}  // namespace glark::conformance
