// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Conditional rendering that display lists begin or end. The same list hides its draws in one call and shows them in
// another, as its query has counted since.
#include <fmt/format.h>

#include "conformance/cases/cases.h"
#include "conformance/cases/draws/four_triangles.h"
#include "conformance/support/counted.h"

namespace glark::conformance {
namespace {

// Names of lists.
constexpr GLuint begin_list = 1, end_list = 2, draw_list = 3, whole_list = 4;

struct ListedDraw {
  const char* leaf;
  void (*draw)();
};
constexpr ListedDraw listed_draws[] = {
    {"arrays", [] { gl.DrawArrays(GL_TRIANGLES, 0, all_vertices); }},
    {"begin",
     [] {
       gl.Begin(GL_TRIANGLES);
       for (const MeshVertex& vertex : four_triangles()) {
         gl.VertexAttrib4fv(at_colour, vertex.colour.data());
         gl.VertexAttrib4fv(at_position, vertex.position.data());
       }
       gl.End();
     }},
};

// What calls the condition and the draw.
struct ConditionForm {
  const char* leaf;
  void (*call)(GLuint query, const ListedDraw& draw);
};
void begin_condition(GLuint query) { gl.BeginConditionalRender(query, GL_QUERY_WAIT); }
constexpr ConditionForm condition_forms[] = {
    {"whole", [](GLuint, const ListedDraw&) { gl.CallList(whole_list); }},
    {"around",
     [](GLuint, const ListedDraw& draw) {
       gl.CallList(begin_list);
       draw.draw();
       gl.CallList(end_list);
     }},
    {"around_list",
     [](GLuint, const ListedDraw&) {
       const GLubyte lists[] = {begin_list, draw_list, end_list};
       gl.CallLists(3, GL_UNSIGNED_BYTE, lists);
     }},
    {"begun",
     [](GLuint, const ListedDraw& draw) {
       gl.CallList(begin_list);
       draw.draw();
       gl.EndConditionalRender();
     }},
    {"ended",
     [](GLuint query, const ListedDraw& draw) {
       begin_condition(query);
       draw.draw();
       gl.CallList(end_list);
     }},
};

void compile(GLuint list, const std::function<void()>& commands) {
  gl.NewList(list, GL_COMPILE);
  commands();
  gl.EndList();
}

// Counts again, without refinement: some samples, or none.
void count_samples(GLuint query, bool some) {
  gl.Disable(GL_ARK);
  gl.BeginQuery(GL_ANY_SAMPLES_PASSED, query);
  if (some) gl.DrawArrays(GL_TRIANGLES, 0, 3);
  gl.EndQuery(GL_ANY_SAMPLES_PASSED);
  gl.Enable(GL_ARK);
}

void check_listed_condition(Test& t, const ConditionForm& form, const ListedDraw& draw) {
  set_up_four_triangles(t);
  GLuint query = 0;
  gl.GenQueries(1, &query);
  gl.ARKinit(3);
  count_samples(query, false);  // BeginConditionalRender needs the name of a query that has begun
  compile(begin_list, [query] { begin_condition(query); });
  compile(end_list, [] { gl.EndConditionalRender(); });
  compile(draw_list, draw.draw);
  compile(whole_list, [&] {
    begin_condition(query);
    draw.draw();
    gl.EndConditionalRender();
  });
  gl.Disable(GL_ARK);
  const Picture plain = picture_of([&] { draw.draw(); });
  refine_uniformly(3);
  const GLuint triangles = count_generated([&] { draw.draw(); });
  t.expect_equal(triangles, 4U << (2 * 3), "the control: triangles of an unconditional draw");
  for (const GLenum source : {GL_UNIFORM_DEPTH_ARK, GL_DEPTH_TAG_ARK, GL_MEASURED_DEPTH_ARK}) {
    gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, static_cast<GLint>(source));
    gl.DepthTag1i(3);
    gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, 1);
    for (const bool shown : {false, true, true, false, false, true}) {
      count_samples(query, shown);
      const std::string what = fmt::format("source {:#x}, {}", source, shown ? "shown" : "hidden");
      const Picture picture = picture_of([&] { form.call(query, draw); });
      t.expect_same_picture(picture, shown ? plain : Picture(surface_size, surface_size), what, 2, 24);
      t.expect_same_picture(picture_of([&] { draw.draw(); }), plain, what + ": afterwards", 2, 24);
    }
    t.expect_equal(count_generated([&] { draw.draw(); }), triangles, fmt::format("source {:#x}: afterwards", source));
  }
  t.expect_no_error("the draws");
}

constexpr Area condition_case{.prefix = "ark.list.condition.", .apis = compat_only};

}  // namespace

Cases listed_conditions_cases() {
  Cases cases;
  for (const ConditionForm& form : condition_forms)
    for (const ListedDraw& draw : listed_draws)
      cases.push_back(
          condition_case(fmt::format("{}.{}", form.leaf, draw.leaf), {"10.R.2-2", "chapter-21-4"},
                         "A list begins or ends conditional rendering around a draw, hidden and shown in turn.",
                         "A hidden draw shows, or what it left out is missing in later draws.",
                         [&form, &draw](Test& t) { check_listed_condition(t, form, draw); }));
  return cases;
}

}  // namespace glark::conformance
