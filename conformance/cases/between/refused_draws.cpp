// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Draws that GL refuses, within queries and transform feedback, and between draws that are refined. They draw nothing,
// count nothing, and leave everything as it was.
#include <fmt/core.h>

#include "conformance/cases/between/refusals.h"
#include "conformance/cases/cases.h"
#include "conformance/cases/repeated/repeated.h"
#include "conformance/support/capture.h"
#include "conformance/support/counted.h"
#include "conformance/support/state.h"

namespace glark::conformance {
namespace {

constexpr GLuint accepted_triangles = 4 * 4;  // of the good draw, at tags of 1
constexpr GLuint uniform_triangles = 4 * 16;  // at a uniform depth of 2

void draw_accepted() { gl.DrawArrays(GL_TRIANGLES, 0, 12); }

// The error is read once GL is as it was before.
GLenum error_of(Test& t, const Refusal& refusal, const RefusedScene& scene) {
  refusal.enter(t, scene);
  refusal.draw(scene);
  refusal.leave(scene);
  return gl.GetError();
}

void refuse(Test& t, const Refusal& refusal, const RefusedScene& scene, GLenum error, const std::string& what) {
  t.expect_equal(error_name(error_of(t, refusal, scene)), error_name(error), refusal.leaf + what);
  t.expect_no_error(refusal.leaf + what + ": a second error");
}

// The error without refinement, and while transform feedback is active or not. GL may allow a draw that could be an error,
// as with mapped buffers.
GLenum plain_error(Test& t, const Refusal& refusal, bool in_feedback) {
  if (!refusal.is_plain) return refusal.error;
  const std::unique_ptr<Context> context = t.create_context();
  const RefusedScene scene = make_refused_scene(t);
  GLenum error = GL_NO_ERROR;
  const auto draw = [&] { error = error_of(t, refusal, scene); };
  if (in_feedback)
    capture_bytes(t, sizeof(CapturedVertex), 3, 4000, GL_TRIANGLES, draw);
  else
    draw();
  t.log(refusal.leaf + " without refinement: " + error_name(error));
  return error;
}

struct QueryTarget {
  const char* name;
  GLenum target;
  Apis apis = every_api;
};
constexpr QueryTarget query_targets[] = {
    {"PRIMITIVES_GENERATED", GL_PRIMITIVES_GENERATED},
    {"TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN", GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN},
    {"SAMPLES_PASSED", GL_SAMPLES_PASSED, desktop_apis},
    {"ANY_SAMPLES_PASSED", GL_ANY_SAMPLES_PASSED},
    {"TIME_ELAPSED", GL_TIME_ELAPSED, desktop_apis},
};

GLuint result_of(GLenum target, const std::function<void()>& draws) {
  GLuint query = 0;
  GLuint result = 0;
  gl.GenQueries(1, &query);
  gl.BeginQuery(target, query);
  draws();
  gl.EndQuery(target);
  gl.GetQueryObjectuiv(query, GL_QUERY_RESULT, &result);
  gl.DeleteQueries(1, &query);
  return result;
}

struct Depth {
  const char* name;
  void (*refine)();
  GLuint triangles;
};
constexpr Depth depths_of_refused[] = {{"tags", [] { refine_by_tags(3); }, accepted_triangles},
                                       {"a uniform depth", [] { refine_uniformly(2); }, uniform_triangles}};

// How many primitives or samples two draws give that are not refused.
GLuint expected_of(GLenum target, const Depth& depth) {
  if (target == GL_PRIMITIVES_GENERATED) return 2 * depth.triangles;
  if (target == GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN) return 0;
  return result_of(target, [] {
    draw_accepted();
    draw_accepted();
  });
}

void check_in_query(Test& t, const Refusal& refusal, GLenum error, const Depth& depth, const QueryTarget& query,
                    bool is_first) {
  const std::unique_ptr<Context> context = t.create_context();
  const RefusedScene scene = make_refused_scene(t);
  const std::string where = fmt::format(" in {}, {}, {}", query.name, depth.name, is_first ? "first" : "kept");
  const Picture plain = picture_of(draw_accepted);
  const std::string with = ": " + where;
  depth.refine();
  if (!is_first) repeat_often(draw_accepted);
  if (refusal.allows_queries) {
    const GLuint alone = result_of(query.target, [&] {
      refuse(t, refusal, scene, error, where);
      refuse(t, refusal, scene, error, where);
    });
    if (query.target != GL_TIME_ELAPSED) t.expect_equal(alone, 0U, refusal.leaf + with + ": alone");
    clear_surface();
    const GLuint among = result_of(query.target, [&] {
      draw_accepted();
      refuse(t, refusal, scene, error, where);
      draw_accepted();
    });
    clear_surface();
    if (query.target != GL_TIME_ELAPSED)
      t.expect_near(among, expected_of(query.target, depth), query.target == GL_SAMPLES_PASSED ? 80 : 0,
                    refusal.leaf + with + ": between two draws");
  }
  refuse(t, refusal, scene, error, " after queries");
  for (int again = 0; again < 2; ++again) {
    GLuint triangles = 0;
    t.expect_same_picture(picture_of([&] { triangles = count_generated(draw_accepted); }), plain,
                          "the draw after " + refusal.leaf + with, 4, 80);
    t.expect_equal(triangles, depth.triangles, "triangles after " + refusal.leaf + with);
  }
  t.expect_no_error("the draws");
}

void check_refused(Test& t, const Refusal& refusal) {
  const GLenum error = plain_error(t, refusal, false);
  t.expect(error == refusal.error || error == GL_NO_ERROR, "the error is the one that GL names, if there is one");
  if (error == GL_NO_ERROR) return;
  std::size_t turn = 0;
  for (const QueryTarget& query : query_targets)
    for (const bool is_first : {false, true})
      if (query.apis.contains(t.api()))
        check_in_query(t, refusal, error, depths_of_refused[turn++ % std::size(depths_of_refused)], query, is_first);
  check_in_query(t, refusal, error, depths_of_refused[0], query_targets[0], true);
  check_in_query(t, refusal, error, depths_of_refused[1], query_targets[0], false);
}

// The captured bytes are those of the two draws.
void check_in_feedback(Test& t, const Refusal& refusal) {
  const GLenum error = plain_error(t, refusal, true);
  t.expect_no_error("the unrefined draw");
  if (error == GL_NO_ERROR) return;
  for (const Depth& depth : depths_of_refused)
    for (const bool is_first : {false, true}) {
      const std::unique_ptr<Context> context = t.create_context();
      const RefusedScene scene = make_refused_scene(t);
      depth.refine();
      const auto two = [] {
        draw_accepted();
        draw_accepted();
      };
      const auto three = [&] {
        if (is_first) refuse(t, refusal, scene, error, " before captured draws");
        draw_accepted();
        refuse(t, refusal, scene, error, " between captured draws");
        draw_accepted();
        refuse(t, refusal, scene, error, " after captured draws");
      };
      const auto capture_of = [&](const std::function<void()>& draws) {
        return capture_bytes(t, sizeof(CapturedVertex), 3, 4000, GL_TRIANGLES, draws);
      };
      const auto mixed = capture_of(three);
      const auto expected = capture_of(two);
      const std::string with = fmt::format("{} with {}", refusal.leaf, depth.name);
      t.expect_equal(mixed.size(), std::size_t{2} * depth.triangles * 3 * sizeof(CapturedVertex),
                     "bytes captured around " + with);
      t.expect(mixed == expected, "what is captured around " + with);
      t.expect(capture_of(three) == expected, "what is captured again around " + with);
    }
}

}  // namespace

Cases refused_draws_cases() {
  Cases cases;
  for (const Refusal& refusal : refusals()) {
    cases.push_back({.name = "ark.draw.between.refused." + refusal.leaf,
                     .clauses = {"10.R.2-13", "chapter-14-9"},
                     .plan = "A draw that GL refuses for this reason, in queries of each kind, alone and between draws "
                             "that are refined: the same error, and no counts.",
                     .wrong = "Its capture counts; another error; the draws around it lose tags, triangles or counts.",
                     .apis = refusal.apis,
                     .check = [&refusal](Test& t) { check_refused(t, refusal); }});
    if (!refusal.allows_feedback) continue;
    cases.push_back({.name = "ark.draw.between.refused." + refusal.leaf + ".captured",
                     .clauses = {"10.R.2-13", "chapter-14-5"},
                     .plan = "A draw that GL refuses for this reason before, between and after draws that transform "
                             "feedback captures: it captures those alone.",
                     .wrong = "The draws around it are not captured, or at another place.",
                     .apis = refusal.apis,
                     .check = [&refusal](Test& t) { check_in_feedback(t, refusal); }});
  }
  return cases;
}

}  // namespace glark::conformance
