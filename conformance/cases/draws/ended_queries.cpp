// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Queries of primitives that begin and end in every way: with an index or without, of several streams, and by their
// deletion (GL 4.6, 4.2 and 4.2.2).
#include <fmt/core.h>

#include <array>

#include "conformance/cases/cases.h"
#include "conformance/cases/draws/four_triangles.h"

namespace glark::conformance {
namespace {

constexpr GLuint refined_triangles = 64;  // of four triangles, at depth 2

struct QueryStart {
  const char* what;
  void (*begin)(GLenum target, GLuint query);
};
struct QueryEnd {
  const char* what;
  void (*end)(GLenum target, GLuint query);
  bool has_result = true;
};

constexpr QueryStart query_starts[] = {
    {"BeginQuery", [](GLenum target, GLuint query) { gl.BeginQuery(target, query); }},
    {"BeginQueryIndexed", [](GLenum target, GLuint query) { gl.BeginQueryIndexed(target, 0, query); }}};
constexpr QueryEnd query_ends[] = {{"EndQuery", [](GLenum target, GLuint) { gl.EndQuery(target); }},
                                   {"EndQueryIndexed", [](GLenum target, GLuint) { gl.EndQueryIndexed(target, 0); }},
                                   {"DeleteQueries", [](GLenum, GLuint query) { gl.DeleteQueries(1, &query); }, false},
                                   {"DeleteQueries of several",
                                    [](GLenum, GLuint query) {
                                      GLuint names[] = {0, 0, query};
                                      gl.GenQueries(1, &names[1]);
                                      gl.DeleteQueries(3, names);
                                    },
                                    false}};

constexpr GLenum query_targets[] = {GL_PRIMITIVES_GENERATED, GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN};

// Draws four triangles. The counts of some are known before the draw, those of others are not.
struct FourTriangles {
  const char* what;
  void (*draw)();
};
constexpr FourTriangles four_draws[] = {
    {"arrays", [] { gl.DrawArrays(GL_TRIANGLES, 0, all_vertices); }},
    {"restarting elements", [] { gl.DrawElements(GL_TRIANGLES, all_vertices + 2, GL_UNSIGNED_SHORT, nullptr); }},
    {"indirect arrays", [] { gl.DrawArraysIndirect(GL_TRIANGLES, nullptr); }}};

void set_up_queries(Test& t) {
  gl.UseProgram(build_program(t, {.vertex = plain_vertex_shader, .captured = {"gl_Position"}}));
  upload(four_triangles(), false);
  const GLushort indices[] = {0, 1, 2, 0xffff, 3, 4, 5, 6, 7, 8, 0xffff, 9, 10, 11};
  const GLuint command[] = {all_vertices, 1, 0, 0};
  std::array<GLuint, 3> buffers{};
  gl.GenBuffers(3, buffers.data());
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[0]);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof(indices), indices, GL_STATIC_DRAW);
  gl.BindBuffer(GL_DRAW_INDIRECT_BUFFER, buffers[1]);
  gl.BufferData(GL_DRAW_INDIRECT_BUFFER, sizeof(command), command, GL_STATIC_DRAW);
  gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffers[2]);
  gl.BufferData(GL_TRANSFORM_FEEDBACK_BUFFER, 1 << 20, nullptr, GL_STATIC_DRAW);
  gl.Enable(GL_PRIMITIVE_RESTART_FIXED_INDEX);
}

GLuint result_of(GLuint query) {
  GLuint result = 0;
  gl.GetQueryObjectuiv(query, GL_QUERY_RESULT, &result);
  return result;
}

// Draws in a query of this target. The primitives of draws after its end do not count.
void expect_query(Test& t, GLenum target, const QueryStart& start, const QueryEnd& end, const FourTriangles& four,
                  GLuint expected) {
  GLuint query = 0;
  gl.GenQueries(1, &query);
  const bool is_captured = target == GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN;
  start.begin(target, query);
  if (is_captured) gl.BeginTransformFeedback(GL_TRIANGLES);
  four.draw();
  if (is_captured) gl.EndTransformFeedback();
  end.end(target, query);
  GLint current = 1;
  gl.GetQueryiv(target, GL_CURRENT_QUERY, &current);
  const std::string what = fmt::format("{} and {}, {}, of 0x{:x}", start.what, end.what, four.what, target);
  t.expect_equal(current, 0, what + ": no query is active");
  for (const FourTriangles& later : four_draws) later.draw();
  // What an implementation has not drawn before, it has to capture now.
  gl.DrawArraysInstanced(GL_TRIANGLES, 0, all_vertices, 2 + static_cast<GLsizei>(query % 37));
  gl.DrawArrays(GL_TRIANGLES, 3 * static_cast<GLint>(query % 3), 3);
  if (end.has_result) {
    t.expect_equal(result_of(query), expected, what + ": triangles");
    gl.DeleteQueries(1, &query);
  }
}

// Each way to end a query, followed by a query of either target with each way to begin and end.
void check_query_ends(Test& t, bool is_refined) {
  set_up_queries(t);
  if (is_refined) refine_uniformly(2);
  const GLuint expected = is_refined ? refined_triangles : 4;
  for (const GLenum target : query_targets)
    for (const QueryStart& start : query_starts)
      for (const QueryEnd& end : query_ends)
        for (const GLenum next : query_targets)
          for (const FourTriangles& four : four_draws) {
            expect_query(t, target, start, end, four_draws[0], expected);
            expect_query(t, next, query_starts[0], query_ends[0], four, expected);
            expect_query(t, target, start, end, four, expected);
            expect_query(t, next, query_starts[1], query_ends[1], four, expected);
          }
  t.expect_no_error("the queries");
}

// OpenGL ES has neither indexed queries nor other streams.
void check_query_deletion(Test& t, bool is_refined) {
  set_up_queries(t);
  if (is_refined) refine_uniformly(2);
  const GLuint expected = is_refined ? refined_triangles : 4;
  for (const GLenum target : query_targets)
    for (const QueryEnd& end : {query_ends[2], query_ends[3], query_ends[0]})
      for (const GLenum next : query_targets)
        for (const FourTriangles& four : four_draws) {
          expect_query(t, target, query_starts[0], end, four_draws[0], expected);
          expect_query(t, next, query_starts[0], query_ends[0], four, expected);
        }
  t.expect_no_error("the queries");
}

// A query of the first stream, and queries of other streams that begin before it or after it and end in any order. No
// program writes to other streams.
void check_query_streams(Test& t, bool is_refined) {
  set_up_queries(t);
  if (is_refined) refine_uniformly(2);
  GLint streams = 0;
  gl.GetIntegerv(GL_MAX_VERTEX_STREAMS, &streams);
  for (const GLenum target : query_targets)
    for (GLuint stream = 1; stream < static_cast<GLuint>(streams); ++stream)
      for (unsigned order = 0; order < 8; ++order)
        for (const FourTriangles& four : four_draws) {
          GLuint queries[2] = {};
          gl.GenQueries(2, queries);
          const bool is_captured = target == GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN;
          const bool other_begins = (order & 1U) != 0;
          const bool other_ends = (order & 2U) != 0;
          if (other_begins) gl.BeginQueryIndexed(target, stream, queries[1]);
          gl.BeginQuery(target, queries[0]);
          if (!other_begins) gl.BeginQueryIndexed(target, stream, queries[1]);
          if (is_captured) gl.BeginTransformFeedback(GL_TRIANGLES);
          four.draw();
          if (is_captured) gl.EndTransformFeedback();
          const auto end_other = [&] {
            (order & 4U) != 0 ? gl.DeleteQueries(1, &queries[1]) : gl.EndQueryIndexed(target, stream);
          };
          if (other_ends) {
            end_other();
            if (!is_captured) four.draw();
          }
          gl.EndQuery(target);
          if (!other_ends) end_other();
          four.draw();
          const GLuint expected = (is_refined ? refined_triangles : 4) * (other_ends && !is_captured ? 2 : 1);
          const std::string what = fmt::format("0x{:x}, stream {}, order {}, {}", target, stream, order, four.what);
          t.expect_equal(result_of(queries[0]), expected, what + ": triangles of the first stream");
          if ((order & 4U) == 0) t.expect_equal(result_of(queries[1]), 0U, what + ": triangles of the other stream");
          gl.DeleteQueries(2, queries);
        }
  t.expect_no_error("the queries");
}

constexpr Area query_case{.prefix = "ark.after_vertex.query."};

Case with_unrefined_control(Case each, void (*check)(Test& t, bool is_refined)) {
  each.control = [check](Test& t) { check(t, false); };
  each.check = [check](Test& t) { check(t, true); };
  return each;
}

}  // namespace

Cases ended_queries_cases() {
  const std::vector<std::string> clauses = {"chapter-14-8", "chapter-14-9"};
  const char* const wrong = "The query goes on for the implementation; later queries count too much or too little.";
  return {with_unrefined_control(
              query_case("ended", clauses,
                         "Begin and end queries with index 0 or without an index, or delete them while they "
                         "are active; then count in another query.",
                         wrong, {}, desktop_apis),
              check_query_ends),
          with_unrefined_control(
              query_case("deleted", clauses, "Delete an active query; then count in another query.", wrong, {}),
              check_query_deletion),
          with_unrefined_control(
              query_case("streams", clauses, "Queries of two streams at once, in any order.",
                         "The query of the other stream counts as the one of the first.", {}, desktop_apis),
              check_query_streams)};
}

}  // namespace glark::conformance
