// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Refined draws within conditional rendering. A draw that it discards leaves nothing behind: neither counts of queries,
// nor anything that changes later draws.
#include <fmt/core.h>

#include "conformance/cases/cases.h"
#include "conformance/cases/draws/four_triangles.h"
#include "conformance/support/counted.h"

namespace glark::conformance {
namespace {

struct Condition {
  const char* leaf;
  GLenum mode;
  bool is_inverted;
};
constexpr Condition conditions[] = {{"wait", GL_QUERY_WAIT, false},
                                    {"by_region_wait", GL_QUERY_BY_REGION_WAIT, false},
                                    {"wait_inverted", GL_QUERY_WAIT_INVERTED, true},
                                    {"by_region_wait_inverted", GL_QUERY_BY_REGION_WAIT_INVERTED, true}};

enum class HiddenWay { arrays, begin, list };

struct DepthChoice {
  const char* leaf;
  void (*choose)();
};
// The pool's level is 3. Edges of many pixels have the depth of the pool.
constexpr DepthChoice depth_choices[] = {
    {"uniform",
     [] {
       gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
       gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 3);
     }},
    {"tags",
     [] {
       gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_DEPTH_TAG_ARK);
       gl.DepthTag1i(3);
     }},
    {"pixels",
     [] {
       gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK);
       gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, 1);
     }},
};
constexpr GLuint hidden_triangles = 4 << (2 * 3);

void draw_hidden(HiddenWay way) {
  if (way == HiddenWay::arrays) return gl.DrawArrays(GL_TRIANGLES, 0, all_vertices);
  if (way == HiddenWay::list) return gl.CallList(1);
  gl.Begin(GL_TRIANGLES);
  for (const MeshVertex& vertex : four_triangles()) {
    gl.VertexAttrib4fv(at_colour, vertex.colour.data());
    gl.VertexAttrib4fv(at_position, vertex.position.data());
  }
  gl.End();
}

// A query that has counted samples, or none.
GLuint query_of_surface(bool some) {
  GLuint query = 0;
  gl.GenQueries(1, &query);
  gl.BeginQuery(GL_ANY_SAMPLES_PASSED, query);
  if (some) gl.DrawArrays(GL_TRIANGLES, 0, 3);
  gl.EndQuery(GL_ANY_SAMPLES_PASSED);
  return query;
}

struct SampleQueries {
  GLuint some = 0;  // queries
  GLuint none = 0;
};

SampleQueries set_up_condition(Test& t, const Condition& condition, HiddenWay way) {
  if (condition.is_inverted && t.version() < 45) t.not_supported("conditions cannot be inverted");
  set_up_four_triangles(t);
  clear_surface();
  const SampleQueries queries{query_of_surface(true), query_of_surface(false)};
  gl.ARKinit(3);
  if (way == HiddenWay::list) {
    gl.NewList(1, GL_COMPILE);
    draw_hidden(HiddenWay::begin);
    gl.EndList();
  }
  gl.Enable(GL_ARK);
  return queries;
}

Picture picture_within(const Condition& condition, GLuint query, HiddenWay way, GLuint& counted) {
  return picture_of([&] {
    counted = count_generated([&] {
      gl.BeginConditionalRender(query, condition.mode);
      draw_hidden(way);
      gl.EndConditionalRender();
    });
  });
}

void check_condition(Test& t, const Condition& condition, HiddenWay way) {
  const SampleQueries queries = set_up_condition(t, condition, way);
  const GLuint shown = condition.is_inverted ? queries.none : queries.some;
  const GLuint hidden = condition.is_inverted ? queries.some : queries.none;
  gl.Disable(GL_ARK);
  const Picture plain = picture_of([&] { draw_hidden(way); });
  gl.Enable(GL_ARK);
  for (const DepthChoice& kind : depth_choices) {
    kind.choose();
    GLuint counted = 0;
    for (const GLuint query : {hidden, shown, shown, hidden, hidden, shown}) {
      const Picture picture = picture_within(condition, query, way, counted);
      const std::string what = fmt::format("{}, {}", kind.leaf, query == shown ? "shown" : "hidden");
      t.expect_equal(counted, query == shown ? hidden_triangles : 0, what + ": triangles");
      t.expect_same_picture(picture, query == shown ? plain : Picture(surface_size, surface_size), what, 2, 24);
    }
    t.expect_equal(count_generated([&] { draw_hidden(way); }), hidden_triangles,
                   std::string(kind.leaf) + ": afterwards");
  }
  t.expect_no_error("the draws");
}

// One query spans draws that are hidden, shown and unconditional.
void check_one_query(Test& t, const Condition& condition, HiddenWay way) {
  const SampleQueries queries = set_up_condition(t, condition, way);
  for (const DepthChoice& kind : depth_choices) {
    kind.choose();
    const GLuint counted = count_generated([&] {
      for (const GLuint query : {queries.none, queries.some}) {
        gl.BeginConditionalRender(query, condition.mode);
        draw_hidden(way);
        draw_hidden(way);
        gl.EndConditionalRender();
        draw_hidden(way);
      }
    });
    t.expect_equal(counted, 4 * hidden_triangles, kind.leaf);
  }
  t.expect_no_error("the draws");
}

// The first draw of a context, and the first after parameters change, are hidden.
void check_first_hidden(Test& t, const Condition& condition, HiddenWay way) {
  const SampleQueries queries = set_up_condition(t, condition, way);
  const GLuint hidden = condition.is_inverted ? queries.some : queries.none;
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK);
  GLuint before = 0;
  for (const GLint pixels : {40, 90, 20}) {
    gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, pixels);
    gl.BeginConditionalRender(hidden, condition.mode);
    draw_hidden(way);
    gl.EndConditionalRender();
    const GLuint after_hidden = count_generated([&] { draw_hidden(way); });
    gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, pixels + 1);
    draw_hidden(way);
    gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, pixels);
    t.expect_equal(after_hidden, count_generated([&] { draw_hidden(way); }), fmt::format("{} pixels", pixels));
    t.expect(after_hidden != before, fmt::format("{} pixels: another number of triangles", pixels));
    before = after_hidden;
  }
  t.expect_no_error("the draws");
}

// Commands that GL refuses change nothing, and neither does a query that is deleted while it decides.
void check_refused_conditions(Test& t) {
  const SampleQueries queries = set_up_condition(t, conditions[0], HiddenWay::arrays);
  depth_choices[0].choose();
  gl.EndConditionalRender();
  t.expect_error(GL_INVALID_OPERATION, "EndConditionalRender without a beginning");
  gl.BeginConditionalRender(queries.none, GL_TRIANGLES);
  t.expect_error(GL_INVALID_ENUM, "BeginConditionalRender of no mode");
  t.expect_equal(count_generated([] { draw_hidden(HiddenWay::arrays); }), hidden_triangles,
                 "after a refused beginning");
  gl.BeginConditionalRender(queries.none, GL_QUERY_WAIT);
  gl.BeginConditionalRender(queries.some, GL_QUERY_WAIT);
  t.expect_error(GL_INVALID_OPERATION, "BeginConditionalRender within another");
  t.expect_equal(count_generated([] { draw_hidden(HiddenWay::arrays); }), 0U, "the first condition holds");
  gl.EndConditionalRender();
  t.expect_equal(count_generated([] { draw_hidden(HiddenWay::arrays); }), hidden_triangles, "after the end");
  gl.BeginConditionalRender(queries.some, GL_QUERY_WAIT);
  gl.DeleteQueries(1, &queries.some);
  draw_hidden(HiddenWay::arrays);
  gl.EndConditionalRender();
  t.expect_equal(count_generated([] { draw_hidden(HiddenWay::arrays); }), hidden_triangles,
                 "after a query was deleted");
  t.expect_no_error("the draws");
}

const char* leaf_of_hidden(HiddenWay way) {
  return way == HiddenWay::arrays ? "arrays" : way == HiddenWay::begin ? "begin" : "list";
}

}  // namespace

Cases conditional_rendering_cases() {
  Cases cases;
  const char* const wrong = "A hidden draw is counted, or what it left out is missing in later draws.";
  const auto add = [&](const std::string& name, const char* plan, HiddenWay way, const Condition& condition,
                       void (*check)(Test&, const Condition&, HiddenWay)) {
    cases.push_back({.name = fmt::format("ark.draw.conditional.{}.{}", leaf_of_hidden(way), name),
                     .clauses = {"10.R.2-2", "chapter-14-8", "chapter-14-9"},
                     .plan = plan,
                     .wrong = wrong,
                     .apis = way == HiddenWay::arrays ? desktop_apis : compat_only,
                     .is_optional = condition.is_inverted,
                     .check = [=, &condition](Test& t) { check(t, condition, way); }});
  };
  for (const HiddenWay way : {HiddenWay::arrays, HiddenWay::begin, HiddenWay::list}) {
    for (const Condition& condition : conditions)
      add(condition.leaf, "Draw with each source of depths, hidden and shown in turn; compare pictures and counts.",
          way, condition, check_condition);
    add("one_query", "One query counts hidden, shown and unconditional draws.", way, conditions[0], check_one_query);
    add("first", "Hide the first measured draw after each change of the measure.", way, conditions[0],
        check_first_hidden);
  }
  cases.push_back({.name = "ark.draw.conditional.refused",
                   .clauses = {"10.R.2-2", "10.R.2-13"},
                   .plan = "Begin and end conditions that GL refuses, and delete the query of one.",
                   .wrong = "A refused condition hides draws.",
                   .apis = desktop_apis,
                   .check = check_refused_conditions});
  return cases;
}

}  // namespace glark::conformance
