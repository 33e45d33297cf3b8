// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Draws whose vertex count is in a buffer.
#include <cstring>

#include "conformance/cases/cases.h"
#include "conformance/cases/draws/four_triangles.h"
#include "conformance/support/capture.h"
#include "conformance/support/counted.h"
#include "conformance/support/state.h"

namespace glark::conformance {
namespace {

using Draw = std::function<void()>;

// Each repeated draw gives the unrefined picture, with 4^2 triangles for each coarse one.
void expect_drawn(Test& t, const Draw& draw, const std::string& what) {
  gl.Disable(GL_ARK);
  const Picture plain = picture_of(draw);
  const GLuint coarse = count_generated(draw);
  t.expect(coarse > 0 && count_different(plain, Picture(surface_size, surface_size), 8) > 100,
           what + ": something is drawn");
  refine_uniformly(2);
  for (int again = 0; again < 3; ++again) {
    t.expect_same_picture(picture_of(draw), plain, what, 3, 60);
    t.expect_equal(count_generated(draw), 16 * coarse, what + ": triangles");
  }
  t.expect_no_error(what);
}

void bind_words(GLenum target, const std::vector<GLuint>& words) {
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(target, buffer);
  gl.BufferData(target, static_cast<GLsizeiptr>(words.size() * sizeof(GLuint)), words.data(), GL_STATIC_DRAW);
}

// Records eight words apart. The words in between would draw too much.
void check_stride(Test& t) {
  set_up_four_triangles(t);
  bind_words(GL_DRAW_INDIRECT_BUFFER, {3, 1, 0, 0, 9, 9, 9, 9, 6, 1, 3, 0, 0, 0, 0, 0, 3, 2, 9, 0});
  expect_drawn(
      t, [] { gl.MultiDrawArraysIndirect(GL_TRIANGLES, nullptr, 2, 32); }, "the first two of three records");
  expect_drawn(
      t, [] { gl.MultiDrawArraysIndirect(GL_TRIANGLES, nullptr, 3, 32); }, "all three records");
  bind_words(GL_ELEMENT_ARRAY_BUFFER, {11, 9, 10, 0, 1, 2, 5, 3, 4});
  bind_words(GL_DRAW_INDIRECT_BUFFER, {6, 1, 0, 0, 0, 1, 1, 3, 1, 6, 3, 0, 0, 0, 3, 1, 0, static_cast<GLuint>(-3), 0});
  expect_drawn(
      t, [] { gl.MultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, nullptr, 2, 28); }, "two indexed records");
}

// No record, one record, and records that draw nothing among others that do.
void check_empty_records(Test& t) {
  set_up_four_triangles(t);
  bind_words(GL_DRAW_INDIRECT_BUFFER, {0, 1, 0, 0, 3, 1, 3, 0, 3, 0, 0, 0, 6, 1, 6, 0});
  expect_drawn(
      t, [] { gl.MultiDrawArraysIndirect(GL_TRIANGLES, nullptr, 4, 0); }, "four records, two of them empty");
  const GLint first[] = {0, 3, 3, 9};
  const GLsizei count[] = {3, 0, 2, 3};
  expect_drawn(
      t, [&] { gl.MultiDrawArrays(GL_TRIANGLES, first, count, 4); }, "four draws, two of them empty");
  const Picture black(surface_size, surface_size);
  t.expect_same_picture(picture_of([] { gl.MultiDrawArraysIndirect(GL_TRIANGLES, nullptr, 0, 0); }), black,
                        "no record");
  t.expect_same_picture(picture_of([&] { gl.MultiDrawArrays(GL_TRIANGLES, first, count, 0); }), black, "no draw");
  t.expect_no_error("draws of nothing");
}

void check_restart(Test& t) {
  set_up_four_triangles(t);
  const GLuint restart = 0xffffffffU;
  gl.Enable(GL_PRIMITIVE_RESTART_FIXED_INDEX);
  bind_words(GL_ELEMENT_ARRAY_BUFFER, {0, 1, 2, restart, 3, 4, 5, restart, restart, 9, 10, 11, restart, 6});
  bind_words(GL_DRAW_INDIRECT_BUFFER, {14, 1, 0, 0, 0});
  for (const GLenum mode : {GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN})
    expect_drawn(
        t, [mode] { gl.DrawElementsIndirect(mode, GL_UNSIGNED_INT, nullptr); }, "an indirect draw with restarts");
  for (const GLenum mode : {GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN})
    expect_drawn(
        t, [mode] { gl.DrawElements(mode, 14, GL_UNSIGNED_INT, nullptr); }, "a draw with restarts");
}

// Small restart indices are also vertex numbers in an implementation's patterns.
void check_small_restart(Test& t) {
  set_up_four_triangles(t);
  gl.Enable(GL_PRIMITIVE_RESTART);
  bind_words(GL_ELEMENT_ARRAY_BUFFER, {0, 1, 2, 7, 3, 4, 5, 9, 10, 11});
  for (const GLuint index : {7U, 1U, 4U, 10U}) {
    gl.PrimitiveRestartIndex(index);
    expect_drawn(
        t, [] { gl.DrawElements(GL_TRIANGLE_STRIP, 10, GL_UNSIGNED_INT, nullptr); }, "restart " + as_text(index));
    expect_drawn(
        t, [] { gl.DrawArrays(GL_TRIANGLES, 0, all_vertices); }, "a draw without indices, restart " + as_text(index));
  }
}

// Buffers and pointers that such draws use stay bound.
void check_bindings(Test& t) {
  set_up_four_triangles(t);
  gl.Enable(GL_PRIMITIVE_RESTART_FIXED_INDEX);
  bind_words(GL_ELEMENT_ARRAY_BUFFER, {0, 1, 2, 0xffffffffU, 3, 4, 5});
  bind_words(GL_DRAW_INDIRECT_BUFFER, {7, 1, 0, 0, 0});
  const std::vector<GLenum> targets = {GL_DRAW_INDIRECT_BUFFER, GL_QUERY_BUFFER, GL_PARAMETER_BUFFER,
                                       GL_SHADER_STORAGE_BUFFER, GL_TRANSFORM_FEEDBACK_BUFFER};
  const std::vector<GLenum> names = {GL_DRAW_INDIRECT_BUFFER_BINDING, GL_QUERY_BUFFER_BINDING,
                                     GL_PARAMETER_BUFFER_BINDING, GL_SHADER_STORAGE_BUFFER_BINDING,
                                     GL_TRANSFORM_FEEDBACK_BUFFER_BINDING};
  std::vector<GLint> before;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    if (i > 0) bind_words(targets[i], std::vector<GLuint>(64));
    if (gl.GetError() == GL_NO_ERROR) before.push_back(integer_of(names[i]));
    while (gl.GetError() != GL_NO_ERROR) continue;
    if (before.size() == i) before.push_back(-1);  // an older context does not have it
  }
  for (const GLuint level : {0U, 2U})
    for (const GLenum source : {GL_DEPTH_TAG_ARK, GL_UNIFORM_DEPTH_ARK}) {
      refine_uniformly(2);
      gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, static_cast<GLint>(source));
      gl.DepthTag1i(level);
      gl.DrawElements(GL_TRIANGLE_STRIP, 7, GL_UNSIGNED_INT, nullptr);
      gl.DrawElementsIndirect(GL_TRIANGLE_STRIP, GL_UNSIGNED_INT, nullptr);
      gl.DrawArrays(GL_TRIANGLES, 0, all_vertices);
      for (std::size_t i = 0; i < names.size(); ++i)
        if (before[i] >= 0) t.expect_equal(integer_of(names[i]), before[i], "the binding of target " + as_text(i));
    }
  t.expect_no_error("the draws");
}

struct IndexedTarget {
  const char* leaf;
  GLenum target;
  GLenum start;
  GLenum size;
  GLenum alignment;  // the query for it; 0: 4 bytes
};
constexpr IndexedTarget indexed_targets[] = {
    {"storage_ranges", GL_SHADER_STORAGE_BUFFER, GL_SHADER_STORAGE_BUFFER_START, GL_SHADER_STORAGE_BUFFER_SIZE,
     GL_SHADER_STORAGE_BUFFER_OFFSET_ALIGNMENT},
    {"uniform_ranges", GL_UNIFORM_BUFFER, GL_UNIFORM_BUFFER_START, GL_UNIFORM_BUFFER_SIZE,
     GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT},
    {"feedback_ranges", GL_TRANSFORM_FEEDBACK_BUFFER, GL_TRANSFORM_FEEDBACK_BUFFER_START,
     GL_TRANSFORM_FEEDBACK_BUFFER_SIZE, 0}};

// The application reads an indexed binding with an offset between refined draws. Some ranges begin where the buffer
// begins, but do not end where it ends.
void check_ranges(Test& t, const IndexedTarget& indexed) {
  set_up_four_triangles(t);
  GLint alignment = 4;
  if (indexed.alignment != 0) gl.GetIntegerv(indexed.alignment, &alignment);
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(indexed.target, buffer);
  gl.BufferData(indexed.target, 4 * alignment, nullptr, GL_STATIC_DRAW);
  for (const GLuint turn : {0U, 1U, 2U}) {
    const auto offset = [=](GLuint index) { return GLint64{alignment} * ((index + turn) % 3); };
    for (GLuint index = 0; index < 4; ++index)
      gl.BindBufferRange(indexed.target, index, buffer, offset(index), alignment);
    for (const GLenum source : {GL_UNIFORM_DEPTH_ARK, GL_DEPTH_TAG_ARK, GL_MEASURED_DEPTH_ARK}) {
      refine_uniformly(2);
      upload(four_triangles());
      gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, static_cast<GLint>(source));
      for (int again = 0; again < 2; ++again) gl.DrawArrays(GL_TRIANGLES, 0, all_vertices);
      for (GLuint index = 0; index < 4; ++index) {
        GLint64 start = 0;
        GLint64 size = 0;
        gl.GetInteger64i_v(indexed.start, index, &start);
        gl.GetInteger64i_v(indexed.size, index, &size);
        t.expect_equal(start, offset(index), "the offset of binding " + as_text(index));
        t.expect_equal(size, GLint64{alignment}, "the size of binding " + as_text(index));
      }
    }
  }
  t.expect_no_error("the draws");
}

}  // namespace

Cases indirect_draws_cases() {
  Cases cases = {
      {.name = "ark.draw.indirect.stride",
       .clauses = {"10.R.2-2"},
       .plan = "Records of indirect draws that are not tightly packed.",
       .wrong = "The words in between count as a record: too few triangles, or too many.",
       .apis = desktop_apis,
       .check = check_stride},
      {.name = "ark.draw.indirect.empty",
       .clauses = {"10.R.2-2"},
       .plan = "Several draws in one command. Some of them have no triangle.",
       .wrong = "The others are not refined, or not drawn.",
       .apis = desktop_apis,
       .check = check_empty_records},
      {.name = "ark.restart.counts.fixed",
       .clauses = {"10.R.2-2"},
       .plan =
           "Restart between triangles, strips and fans, in indirect draws and others; compare triangles and pictures.",
       .wrong = "Triangles are counted as if there were no restart: wrong ones appear.",
       .check = check_restart},
      {.name = "ark.restart.counts.small",
       .clauses = {"10.R.2-2", "11.R.5-7"},
       .plan = "Restart indices that are small numbers.",
       .wrong = "Restart also applies to the indices of patterns.",
       .apis = desktop_apis,
       .check = check_small_restart},
      {.name = "ark.draw.keeps.counted_bindings",
       .clauses = {"10.R.2-6", "10.R.2-2"},
       .plan = "Bind a buffer to each target that concerns counts, draw, and ask for the bindings.",
       .wrong = "Bindings of the implementation's own passes remain.",
       .apis = desktop_apis,
       .check = check_bindings}};
  for (const IndexedTarget& indexed : indexed_targets)
    cases.push_back({.name = std::string("ark.draw.keeps.") + indexed.leaf,
                     .clauses = {"10.R.2-6", "11.R.10-1"},
                     .plan = "Bind ranges of a buffer, draw, and ask for their offsets and sizes.",
                     .wrong = "The whole buffer is bound after a refined draw.",
                     .check = [&indexed](Test& t) { check_ranges(t, indexed); }});
  return cases;
}

}  // namespace glark::conformance
