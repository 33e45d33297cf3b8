// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Both queries of primitives at once, around draws whose number of triangles only GL knows, and around others.
#include <fmt/core.h>

#include <array>
#include <functional>
#include <vector>

#include "conformance/cases/cases.h"
#include "conformance/cases/draws/four_triangles.h"

namespace glark::conformance {
namespace {

constexpr GLuint both_level = 2;
constexpr GLuint both_refined = 1U << (2 * both_level);

// One kind of draw and its coarse triangles.
struct BothDraw {
  const char* leaf;
  GLuint triangles;
  std::function<void()> draw;
};

void bind_both_elements() {
  const GLuint elements[] = {0, 1, 2, 0xFFFFFFFF, 3, 4, 5, 0xFFFFFFFF, 6, 7, 8};
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof(elements), elements, GL_STATIC_DRAW);
}

void bind_both_commands() {
  const GLuint commands[] = {6, 1, 3, 0};  // count, instances, first, base instance
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_DRAW_INDIRECT_BUFFER, buffer);
  gl.BufferData(GL_DRAW_INDIRECT_BUFFER, sizeof(commands), commands, GL_STATIC_DRAW);
}

const std::vector<BothDraw>& both_draws() {
  static const std::vector<BothDraw> all = {
      {"restart", 3,
       [] {
         gl.Enable(GL_PRIMITIVE_RESTART_FIXED_INDEX);
         gl.DrawElements(GL_TRIANGLE_STRIP, 11, GL_UNSIGNED_INT, nullptr);
         gl.Disable(GL_PRIMITIVE_RESTART_FIXED_INDEX);
       }},
      {"indirect", 2, [] { gl.DrawArraysIndirect(GL_TRIANGLES, nullptr); }},
      {"arrays", 4, [] { gl.DrawArrays(GL_TRIANGLES, 0, all_vertices); }},
  };
  return all;
}

struct BothCounts {
  GLuint generated = 0;
  GLuint written = 0;
};

template <typename Body>
BothCounts both_counts_of(const std::array<GLuint, 2>& queries, bool written_first, const Body& body) {
  const GLenum targets[] = {GL_PRIMITIVES_GENERATED, GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN};
  for (const std::size_t i : {0U, 1U}) {
    const std::size_t which = written_first ? 1 - i : i;
    gl.BeginQuery(targets[which], queries[which]);
  }
  body();
  for (const GLenum target : targets) gl.EndQuery(target);
  BothCounts counts;
  gl.GetQueryObjectuiv(queries[0], GL_QUERY_RESULT, &counts.generated);
  gl.GetQueryObjectuiv(queries[1], GL_QUERY_RESULT, &counts.written);
  return counts;
}

void bind_both_feedback() {
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
  gl.BufferData(GL_TRANSFORM_FEEDBACK_BUFFER, 1 << 20, nullptr, GL_STREAM_READ);
}

void check_both(Test& t, bool written_first, bool has_feedback) {
  if (has_feedback) {
    gl.UseProgram(capture_program(t));
    upload(four_triangles(), false);
    bind_both_feedback();
  } else {
    set_up_four_triangles(t);
  }
  bind_both_elements();
  bind_both_commands();
  std::array<GLuint, 2> queries{};
  gl.GenQueries(2, queries.data());
  refine_uniformly(both_level);
  // Each draw alone, each after each other, and captured before one that is not.
  for (const BothDraw& first : both_draws())
    for (const BothDraw& second : both_draws())
      for (const bool is_enabled : {true, false}) {
        is_enabled ? gl.Enable(GL_ARK) : gl.Disable(GL_ARK);
        const GLuint each = is_enabled ? both_refined : 1;
        const BothCounts counts = both_counts_of(queries, written_first, [&] {
          if (has_feedback) gl.BeginTransformFeedback(GL_TRIANGLES);
          first.draw();
          if (has_feedback) gl.EndTransformFeedback();
          second.draw();
          second.draw();
        });
        const std::string what =
            fmt::format("{}, {}, {}", first.leaf, second.leaf, is_enabled ? "refined" : "unrefined");
        t.expect_equal(counts.generated, each * (first.triangles + 2 * second.triangles), what + ": generated");
        t.expect_equal(counts.written, has_feedback ? each * first.triangles : 0, what + ": written");
      }
  t.expect_no_error("the draws");
}

}  // namespace

Cases both_queries_cases() {
  Cases cases;
  for (const bool written_first : {false, true})
    for (const bool has_feedback : {false, true})
      cases.push_back(
          {.name =
               fmt::format("ark.after_vertex.both_queries.{}.{}", written_first ? "written_first" : "generated_first",
                           has_feedback ? "feedback" : "drawn"),
           .clauses = {"chapter-14-8", "chapter-14-9"},
           .plan = "Count two kinds of draws in a row with PRIMITIVES_GENERATED and "
                   "TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN "
                   "at once.",
           .wrong = "A draw stays unrefined, because one query is needed to count its triangles; or a count is lost.",
           .check = [=](Test& t) { check_both(t, written_first, has_feedback); }});
  return cases;
}

}  // namespace glark::conformance
