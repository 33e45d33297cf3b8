// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Refined draws together with conditional rendering, with several contexts and threads, and draws that go wrong.
#include <atomic>
#include <thread>
#include <utility>

#include "conformance/cases/cases.h"
#include "conformance/support/capture.h"
#include "conformance/support/state.h"

namespace glark::conformance {
namespace {

void draw_triangle() { gl.DrawArrays(GL_TRIANGLES, 0, 3); }

// A vertex stage that bends, so that refined and unrefined pictures differ.
const char bent_stage[] =
    "layout(location = 0) in vec4 position; layout(location = 3) in vec4 vertex_colour; out vec4 colour;\n"
    "void main() { colour = vertex_colour;\n"
    "  gl_Position = vec4(position.xy * (1.0 - 0.3 * dot(position.xy, position.xy)), 0.0, 1.0); }\n";

GLuint query_of_samples(bool has_samples) {
  GLuint query = 0;
  gl.GenQueries(1, &query);
  gl.BeginQuery(GL_SAMPLES_PASSED, query);
  if (has_samples) draw_triangle();
  gl.EndQuery(GL_SAMPLES_PASSED);
  return query;
}

void check_conditional(Test& t) {
  gl.UseProgram(build_program(t, {.vertex = bent_stage}));
  upload(one_triangle());
  refine_uniformly(3);
  const Picture drawn = picture_of(draw_triangle);
  const Picture black(surface_size, surface_size);
  t.expect(count_different(drawn, black, 0) > 1000, "the refined triangle is drawn");
  for (const GLenum mode : {GL_QUERY_WAIT, GL_QUERY_BY_REGION_WAIT})
    for (const bool has_samples : {false, true}) {
      const GLuint query = query_of_samples(has_samples);
      const Picture picture = picture_of([&] {
        gl.BeginConditionalRender(query, mode);
        draw_triangle();
        gl.EndConditionalRender();
      });
      t.expect_no_error("conditional rendering of a refined draw");
      t.expect_same_picture(picture, has_samples ? drawn : black,
                            has_samples ? "the query has samples: drawn" : "the query has none: not drawn");
      t.expect_same_picture(picture_of(draw_triangle), drawn, "drawn after conditional rendering");
    }
}

std::size_t count_refined(Test& t) { return capture(t, draw_triangle).size() / 3; }

// Contexts share objects, but not the state that the extension adds to a context.
void check_shared(Test& t) {
  const GLuint program = capture_program(t);
  gl.UseProgram(program);
  const MeshBuffers buffers = upload(one_triangle());
  refine_uniformly(1);
  t.expect_equal(count_refined(t), 4U, "triangles of the first context");
  const std::unique_ptr<Context> second = t.create_context(&t.context());
  gl.UseProgram(program);
  upload(one_triangle());
  t.expect_equal(count_refined(t), 1U, "triangles of the second context before ARKinit");
  refine_uniformly(3);
  for (int round = 0; round < 3; ++round) {
    t.require(second->make_current(), "the second context can be made current");
    t.expect_equal(count_refined(t), 64U, "triangles of the second context");
    t.require(t.context().make_current(), "the first context can be made current");
    t.expect_equal(count_refined(t), 4U, "triangles of the first context");
  }
  // The second context's change of the buffer shows in the first.
  t.require(second->make_current(), "the second context can be made current");
  Mesh moved = one_triangle();
  moved[2].position = {0.5F, 0.25F, 0, 1};
  gl.BindBuffer(GL_ARRAY_BUFFER, buffers.buffer);
  gl.BufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(moved.size() * sizeof(MeshVertex)), moved.data());
  gl.Finish();
  t.require(t.context().make_current(), "the first context can be made current");
  gl.BindBuffer(GL_ARRAY_BUFFER, buffers.buffer);
  bool is_there = false;
  for (const CapturedVertex& vertex : capture(t, draw_triangle)) is_there = is_there || vertex.position[0] == 0.5F;
  t.expect(is_there, "a refined draw reads what another context wrote to its buffer");
}

struct Drawing {
  std::string vertex;
  std::string fragment;
  GLuint level;
};

// Draws often and clears in between. Returns how many pictures differ from the first, or -1 after another failure.
int draw_often(const Drawing& drawing) {
  std::string log;
  const GLuint program = try_program({.vertex = drawing.vertex, .fragment = drawing.fragment}, log);
  if (program == 0) return -1;
  gl.UseProgram(program);
  upload(one_triangle());
  refine_uniformly(drawing.level);
  const Picture first = picture_of(draw_triangle);
  if (count_different(first, Picture(surface_size, surface_size), 0) < 1000) return -1;
  int different = 0;
  for (int round = 0; round < 40; ++round) {
    refine_uniformly(drawing.level);
    different += count_different(picture_of(draw_triangle), first, 0) > 0 ? 1 : 0;
    if (gl.GetError() != GL_NO_ERROR) return -1;
  }
  return different;
}

void check_threads(Test& t) {
  const std::string vertex = glsl_head(t) + bent_stage;
  const std::string fragment = glsl_head(t) + Sources{}.fragment;
  std::atomic<int> other = -2;
  std::atomic<bool> has_context = true;
  std::thread thread([&] {
    try {
      const std::unique_ptr<Context> second = t.create_context();
      other = draw_often({vertex, fragment, 5});
    } catch (const std::exception&) {
      has_context = false;
    }
  });
  const int here = draw_often({vertex, fragment, 2});
  thread.join();
  if (!has_context) t.internal_error("the other thread gets no context");
  t.expect_equal(here, 0, "pictures of this thread that differ from the first");
  t.expect_equal(other.load(), 0, "pictures of the other thread that differ from the first");
}

struct Fault {
  const char* leaf;
  const char* plan;
  void (*set)();
  void (*draw)();
  bool has_client_memory = false;  // the compatibility profile reads client memory here, and there is none
};

void bind_incomplete() {
  GLuint framebuffer = 0;
  GLuint renderbuffer = 0;
  gl.GenFramebuffers(1, &framebuffer);
  gl.GenRenderbuffers(1, &renderbuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.BindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, renderbuffer);  // without storage
}

void map_buffer() { gl.MapBufferRange(GL_ARRAY_BUFFER, 0, sizeof(MeshVertex), GL_MAP_WRITE_BIT); }

void empty_buffer() { gl.BufferData(GL_ARRAY_BUFFER, 0, nullptr, GL_STATIC_DRAW); }

void bind_indices() {
  const GLushort indices[] = {0, 1, 2};
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof(indices), indices, GL_STATIC_DRAW);
}

void nothing() {}

const std::vector<Fault>& faults() {
  static const std::vector<Fault> all = {
      {"count_0", "A count of 0.", nothing, [] { gl.DrawArrays(GL_TRIANGLES, 0, 0); }},
      {"count_2", "Fewer vertices than a triangle has.", nothing, [] { gl.DrawArrays(GL_TRIANGLES, 0, 2); }},
      {"count_negative", "A negative count.", nothing, [] { gl.DrawArrays(GL_TRIANGLES, 0, -3); }},
      {"instances_0", "No instance.", nothing, [] { gl.DrawArraysInstanced(GL_TRIANGLES, 0, 3, 0); }},
      {"instances_negative", "A negative number of instances.", nothing,
       [] { gl.DrawArraysInstanced(GL_TRIANGLES, 0, 3, -1); }},
      {"elements_0", "No index.", bind_indices, [] { gl.DrawElements(GL_TRIANGLES, 0, GL_UNSIGNED_SHORT, nullptr); }},
      {"elements_negative", "A negative number of indices.", bind_indices,
       [] { gl.DrawElements(GL_TRIANGLES, -1, GL_UNSIGNED_SHORT, nullptr); }},
      {"elements_type", "An index type that does not exist.", bind_indices,
       [] { gl.DrawElements(GL_TRIANGLES, 3, GL_FLOAT, nullptr); }},
      {"range_end", "A range that ends before it begins.", bind_indices,
       [] { gl.DrawRangeElements(GL_TRIANGLES, 3, 1, 3, GL_UNSIGNED_SHORT, nullptr); }},
      {"mode", "A mode that does not exist.", nothing, [] { gl.DrawArrays(0x77, 0, 3); }},
      {"empty_buffer", "A count of 0 and an empty buffer.", empty_buffer, [] { gl.DrawArrays(GL_TRIANGLES, 0, 0); }},
      {"incomplete_framebuffer", "An incomplete framebuffer.", bind_incomplete, draw_triangle},
      {"mapped_buffer", "The array's buffer is mapped.", map_buffer, draw_triangle},
      {"indirect_without_buffer", "An indirect draw without an indirect buffer.", nothing,
       [] { gl.DrawArraysIndirect(GL_TRIANGLES, nullptr); }, true},
      {"indirect_misaligned", "An indirect draw from an address that is not a multiple of 4.", nothing,
       [] { gl.DrawArraysIndirect(GL_TRIANGLES, reinterpret_cast<const void*>(std::intptr_t{2})); }, true},
  };
  return all;
}

GLenum error_of(const Fault& fault) {
  fault.set();
  while (gl.GetError() != GL_NO_ERROR) continue;
  fault.draw();
  const GLenum error = gl.GetError();
  while (gl.GetError() != GL_NO_ERROR) continue;
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  return error;
}

// Returns the picture of the unrefined draw, made in a context of its own.
void check_fault(Test& t, const Fault& fault) {
  GLenum expected = GL_NO_ERROR;
  {
    const std::unique_ptr<Context> plain = t.create_context();
    gl.UseProgram(build_program(t, {.vertex = bent_stage}));
    upload(one_triangle());
    expected = error_of(fault);
  }
  t.require(t.context().make_current(), "the first context can be made current again");
  gl.UseProgram(build_program(t, {.vertex = bent_stage}));
  upload(one_triangle());
  refine_uniformly(2);
  const Picture before = picture_of(draw_triangle);
  upload(one_triangle());
  const GLenum error = error_of(fault);
  t.expect(error == expected, "the refined draw generates the error of the unrefined one, " + error_name(expected) +
                                  ", not " + error_name(error));
  upload(one_triangle());
  t.expect_same_picture(picture_of(draw_triangle), before, "a refined draw afterwards");
  t.expect_no_error("a refined draw afterwards");
}

// An object that is deleted while in use lives on (section 5.1.3 of the OpenGL specification).
void check_deleted(Test& t, bool is_program, bool is_refined) {
  const GLuint program = build_program(t, {.vertex = bent_stage});
  gl.UseProgram(program);
  const MeshBuffers buffers = upload(one_triangle());
  bind_indices();
  GLint indices = 0;
  gl.GetIntegerv(GL_ELEMENT_ARRAY_BUFFER_BINDING, &indices);
  const auto draw = [] { gl.DrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_SHORT, nullptr); };
  const Picture unrefined = picture_of(draw);
  if (is_refined) refine_uniformly(3);
  const Picture before = picture_of(draw);
  t.expect(count_different(before, Picture(surface_size, surface_size), 0) > 1000, "the triangle is drawn");
  if (is_program) gl.DeleteProgram(program);
  GLuint other = 0;
  gl.GenVertexArrays(1, &other);
  gl.BindVertexArray(other);
  const GLuint names[] = {buffers.buffer, static_cast<GLuint>(indices)};
  if (!is_program) gl.DeleteBuffers(2, names);
  gl.BindVertexArray(buffers.array);
  const Picture after = picture_of(draw);
  // A program that lives only because it is in use need not be refined.
  const bool may_be_coarse = is_program && count_different(after, unrefined, 0) == 0;
  t.expect_same_picture(after, may_be_coarse ? unrefined : before, "the deleted object is still in use");
  t.expect_no_error("drawing with deleted objects that are in use");
  gl.UseProgram(build_program(t, {.vertex = bent_stage}));
  t.expect_same_picture(picture_of(draw), before, "with a new program");
}

void check_indices(Test& t) {
  GLint flags = 0;
  gl.GetIntegerv(GL_CONTEXT_FLAGS, &flags);
  if ((flags & GL_CONTEXT_FLAG_ROBUST_ACCESS_BIT) == 0) t.not_supported("the context has no robust access");
  gl.UseProgram(build_program(t, {.vertex = bent_stage}));
  upload(one_triangle());
  refine_uniformly(2);
  const Picture before = picture_of(draw_triangle);
  const GLuint indices[] = {0, 1, 0xFFFFFFFE, 0x10000000, 2, 1};
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof(indices), indices, GL_STATIC_DRAW);
  gl.DrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_INT, nullptr);
  gl.DrawArrays(GL_TRIANGLES, 0x1000000, 3);
  gl.Finish();
  t.expect_no_error("indices out of range");
  t.expect_same_picture(picture_of(draw_triangle), before, "a refined draw afterwards");
}

}  // namespace

Cases contexts_and_faults_cases() {
  Cases cases = {
      {.name = "ark.interplay.conditional_rendering",
       .clauses = {"10.R.2-1"},
       .plan = "Conditional rendering draws a refined draw, or skips it, as the query says.",
       .wrong = "The implementation's passes ignore the condition, or draw nothing with it.",
       .apis = desktop_apis,
       .check = check_conditional},
      {.name = "ark.interplay.share_group",
       .clauses = {"11.R.1-3"},
       .plan = "Two contexts share a program and a buffer. Each has its own pool and depth, and they draw in turn.",
       .wrong = "The pool or the level of the other context; objects of one context are used in the other.",
       .check = check_shared},
      {.name = "ark.interplay.threads",
       .clauses = {"11.R.1-3"},
       .plan = "Two threads with a context each draw 40 refined pictures at the same time.",
       .wrong = "State in global variables: a picture with the other's depth, or a crash.",
       .check = check_threads},
      {.name = "ark.robustness.indices",
       .clauses = {"11.R.11-1"},
       .plan = "Draw with indices out of range in a context with robust access: no crash.",
       .wrong = "A crash.",
       .is_optional = true,
       .check = check_indices},
  };
  for (const bool is_program : {false, true})
    cases.push_back({.name = std::string("ark.robustness.deleted.") + (is_program ? "program" : "buffers"),
                     .clauses = is_program ? std::vector<std::string>{"10.R.2-1", "11.R.11-9"}
                                           : std::vector<std::string>{"10.R.2-1"},
                     .plan = "Delete the program, or the vertex and index buffers of a vertex array that is not bound, "
                             "and draw with them: they are still in use.",
                     .wrong = "The implementation drops its data for them: nothing is drawn, or the draw is unrefined.",
                     .control = [is_program](Test& t) { check_deleted(t, is_program, false); },
                     .check = [is_program](Test& t) { check_deleted(t, is_program, true); }});
  for (const Fault& fault : faults()) {
    cases.push_back(
        {.name = std::string("ark.robustness.draws.") + fault.leaf,
         .clauses = {"10.R.2-13"},
         .plan = std::string(
                     "The refined draw generates the error of the unrefined one, and the next draw works as usual. ") +
                 fault.plan,
         .wrong = "No error, another error, or a crash; the state of the implementation's passes remains.",
         .check = [&fault](Test& t) { check_fault(t, fault); }});
    if (fault.has_client_memory) cases.back().apis = {Api::gl_core, Api::gles};
  }
  return cases;
}

}  // namespace glark::conformance
