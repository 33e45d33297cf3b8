// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/changes/changed_draw.h"

#include <fmt/core.h>

#include <cctype>
#include <iterator>
#include <utility>

#include "conformance/changes/combinations.h"
#include "conformance/changes/paths.h"
#include "conformance/support/capture.h"

namespace glark::conformance {
namespace {

std::vector<const Change*> known;

bool concerns(const Change& change, const Path& path) {
  if (change.concern == Concern::indices) return path.has_indices;
  if (change.concern == Concern::commands) return path.has_commands;
  if (change.concern == Concern::instances) return path.has_instances;
  return true;
}

bool shows(const Change& change, const Path& path) {
  return !(path.copies_arrays && change.concern == Concern::arrays);
}

// Ends the case at the first picture that is wrong.
void expect_picture(Test& t, const Picture& actual, const Picture& expected, const std::string& what) {
  t.require(t.expect_same_picture(actual, expected, what, most_difference, most_edge_pixels),
            "the picture is that of the unrefined draw");
}

void check_combination(Test& t, const Change& change, const Combination& one, bool is_refined,
                       ScenePrograms& programs) {
  const Path& path = paths()[one.path];
  const std::string what = fmt::format("{}, refined {} times before", text_of(one), one.history);
  Scene scene(t, one.triangles, path.draws_instances || change.concern == Concern::integers,
              change.changes_program ? nullptr : &programs);
  if (path.prepare != nullptr) path.prepare(t, scene);
  const auto draw = [&] { path.draw(scene); };
  const Picture before = picture_of(draw);
  t.require(count_different(before, Picture(surface_size, surface_size), 8) > 1000, "something is drawn: " + what);
  if (is_refined) set_refinement(one);
  for (int i = 1; is_refined && i < one.history; ++i) draw();
  if (is_refined && one.history > 0) expect_picture(t, picture_of(draw), before, "before the change: " + what);
  change.make(t, scene);
  t.expect_no_error("the change: " + what);
  const Picture first = picture_of(draw);
  const Picture second = picture_of(draw);
  gl.Disable(GL_ARK);
  const Picture plain = picture_of(draw);
  if (shows(change, path))
    t.require(count_different(before, plain, most_difference) > 3 * most_edge_pixels,
              "the change shows without refinement: " + what);
  expect_picture(t, first, plain, "after the change: " + what);
  expect_picture(t, second, plain, "the second draw after the change: " + what);
  t.expect_no_error(what);
}

void check_change(Test& t, const Change& change, std::size_t number, bool is_refined) {
  if (!t.is_gles() && t.version() < change.version)
    t.not_supported(fmt::format("OpenGL {}.{} is needed", change.version / 10, change.version % 10));
  ScenePrograms programs;
  for (const Combination& one : combinations_of(number, paths().size())) {
    const Path& path = paths()[one.path];
    if (path.apis.contains(t.api()) && concerns(change, path)) check_combination(t, change, one, is_refined, programs);
  }
}

constexpr GLuint changing_list = 71;
constexpr GLuint calling_list = 72;

// The errors of a change that is compiled, and of the call: lists take some commands in no implementation.
GLenum error_of_compiled(Test& t, const Change& change, const Combination& one, ScenePrograms& programs) {
  Scene scene(t, one.triangles, false, change.changes_program ? nullptr : &programs);
  gl.NewList(changing_list, GL_COMPILE);
  change.make(t, scene);
  gl.EndList();
  gl.CallList(changing_list);
  const GLenum error = gl.GetError();
  while (gl.GetError() != GL_NO_ERROR) {
  }
  return error;
}

// The change is compiled into a list, which another list calls. Commands that lists do not compile are executed at once, so
// that the unrefined draw says what is right.
void check_compiled(Test& t, const Change& change, const Combination& one, ScenePrograms& programs) {
  gl.Disable(GL_ARK);
  if (error_of_compiled(t, change, one, programs) != GL_NO_ERROR) {
    t.log("lists do not take the commands of this change");
    t.expect_no_error("the list");
    return;
  }
  const Path& path = paths()[one.path];
  const std::string what = fmt::format("{}, refined {} times before", text_of(one), one.history);
  Scene scene(t, one.triangles, path.draws_instances || change.concern == Concern::integers,
              change.changes_program ? nullptr : &programs);
  if (path.prepare != nullptr) path.prepare(t, scene);
  const auto draw = [&] { path.draw(scene); };
  const auto expect_as_plain = [&](const std::string& when) {
    const Picture first = picture_of(draw);
    const Picture second = picture_of(draw);
    gl.Disable(GL_ARK);
    Picture plain = picture_of(draw);
    gl.Enable(GL_ARK);
    expect_picture(t, first, plain, when + what);
    expect_picture(t, second, plain, "again " + when + what);
    return plain;
  };
  set_refinement(one);
  for (int i = 0; i < one.history; ++i) draw();
  gl.NewList(changing_list, GL_COMPILE);
  change.make(t, scene);
  gl.EndList();
  expect_as_plain("after the list is compiled: ");
  gl.NewList(calling_list, GL_COMPILE);
  gl.CallList(changing_list);
  gl.EndList();
  for (int i = 0; i < one.history; ++i) draw();
  expect_as_plain("after the list that calls it is compiled: ");
  gl.CallList(calling_list);
  gl.Finish();  // as for a change outside of lists: lists do not compile it
  expect_as_plain("after the call: ");
  t.expect_no_error(what);
}

bool is_compiled(const Change& change) {
  return change.apis.contains(Api::gl_compat) &&
         (change.concern == Concern::state || change.concern == Concern::integers);
}

// Each change meets each path in one of four kinds of circumstances.
void check_compiled_change(Test& t, const Change& change, std::size_t number) {
  if (t.version() < change.version)
    t.not_supported(fmt::format("OpenGL {}.{} is needed", change.version / 10, change.version % 10));
  const std::vector<Combination> all = combinations_of(number, paths().size());
  ScenePrograms programs;
  for (std::size_t i = number % 4; i < all.size(); i += 4)
    if (paths()[all[i].path].apis.contains(t.api())) check_compiled(t, change, all[i], programs);
}

// "BindVertexArray" as the part of a case's name: "bind_vertex_array".
std::string lower_case(const char* leaf) {
  std::string text;
  for (const char* c = leaf; *c != 0; ++c) {
    const bool is_upper = std::isupper(static_cast<unsigned char>(*c)) != 0;
    if (is_upper && !text.empty() && text.back() != '.') text += '_';
    text += static_cast<char>(std::tolower(static_cast<unsigned char>(*c)));
  }
  return text;
}

}  // namespace

std::vector<Change> joined(std::vector<std::vector<Change>> tables) {
  std::vector<Change> all;
  for (std::vector<Change>& table : tables) std::move(table.begin(), table.end(), std::back_inserter(all));
  return all;
}

const std::vector<const Change*>& all_changes() { return known; }

std::vector<Case> change_cases(const char* area, const std::vector<Change>& changes, std::size_t first) {
  std::vector<Case> cases;
  for (const Change& change : changes) known.push_back(&change);
  for (const Change& change : changes) {
    const std::size_t number = first + static_cast<std::size_t>(&change - changes.data());
    Case made{.name = fmt::format("ark.change.{}.{}", area, lower_case(change.leaf)),
              .clauses = {"10.R.2-1", "11.R.13-1"},
              .plan =
                  "Draw, change what the draw reads, and draw again, in all kinds of draws: the picture is that of "
                  "the unrefined draw.",
              .wrong = "What the draw read before the change.",
              .apis = change.apis,
              .is_optional = change.version != 0,
              .control = [&change, number](Test& t) { check_change(t, change, number, false); },
              .check = [&change, number](Test& t) { check_change(t, change, number, true); }};
    made.commands.assign(change.commands.begin(), change.commands.end());
    cases.push_back(std::move(made));
    if (!is_compiled(change)) continue;
    cases.push_back({.name = fmt::format("ark.change.{}.{}.compiled", area, lower_case(change.leaf)),
                     .clauses = {"10.R.2-1", "11.R.13-1", "chapter-21-4"},
                     .plan =
                         "Draw, compile the change into a list, compile a list that calls it, and call that: each time "
                         "the picture is that of the unrefined draw.",
                     .wrong = "The change takes effect when it is compiled, or does not when the list is called.",
                     .apis = compat_only,
                     .is_optional = change.version != 0,
                     .check = [&change, number](Test& t) { check_compiled_change(t, change, number); }});
  }
  return cases;
}

}  // namespace glark::conformance
