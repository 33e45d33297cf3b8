// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Every kind of state that a draw reads, set by a command that a list compiles (GL 4.6 compatibility profile, 21.4): it
// takes effect when the list is called, and not before. An implementation that follows the commands has to know that.
#include <fmt/core.h>

#include <array>
#include <map>
#include <memory>
#include <tuple>

#include "conformance/cases/cases.h"
#include "conformance/cases/lists/compiled_states.h"
#include "conformance/support/capture.h"
#include "conformance/support/counted.h"

namespace glark::conformance {
namespace {

constexpr GLuint inner_list = 41;
constexpr GLuint outer_list = 42;
constexpr GLuint outermost_list = 43;

struct StateDepths {
  const char* name;
  void (*refine)();
  bool is_curved = false;  // the picture is not that of the unrefined draw
};
constexpr StateDepths state_depths[] = {
    {"a uniform depth", [] { refine_uniformly(2, GL_LINEAR_OUTPUTS_ARK); }},
    {"depth tags", [] { refine_by_tags(4, GL_LINEAR_INPUTS_ARK); }},
    {"measured depths",
     [] {
       refine_by_tags(4, GL_LINEAR_OUTPUTS_ARK);
       gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK);
       gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, 12);
     }},
    // Depths may depend on what is culled or lies outside of the viewport.
    {"welded depths by the error on the screen",
     [] {
       refine_by_tags(4, GL_CURVED_PN_ARK);
       gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK);
       gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, 0);
       gl.ARKParameterfARK(GL_SCREEN_ERROR_ARK, 0.1F);
       gl.ARKParameteriARK(GL_WELD_ARK, GL_TRUE);
     },
     true},
};

constexpr std::size_t backgrounds = 2;

// What GL drew, on two backgrounds: what keeps Clear from clearing shows, too.
struct Drawn {
  std::array<Picture, backgrounds> pictures;
  GLuint triangles = 0;
};

// Without Viewport, which picture_of() may call: it would hide that a list has set the viewport, or has not.
Drawn draw_state(std::size_t most_backgrounds = backgrounds) {
  Drawn drawn;
  for (std::size_t background = 0; background < most_backgrounds; ++background) {
    gl.ClearColor(0, background == 0 ? 0.0F : 0.3F, 0, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    drawn.triangles = count_generated(draw_state_triangles);
    drawn.pictures[background] = read_picture(surface_size, surface_size);
  }
  return drawn;
}

void expect_drawn(Test& t, const Drawn& expected, int times, const std::string& what) {
  for (int again = 0; again < times; ++again) {
    const std::size_t shown = again + 1 == times ? backgrounds : 1;
    const Drawn drawn = draw_state(shown);
    for (std::size_t background = 0; background < shown; ++background)
      t.expect_same_picture(drawn.pictures[background], expected.pictures[background], what, 4, 80);
    t.expect_equal(drawn.triangles, expected.triangles, what + ", triangles");
  }
}

// What a context draws where the command was executed at once: the unrefined picture, unless triangles are curved, and the
// number of refined triangles.
Drawn draw_at_once(Test& t, const CompiledState& state, const StateDepths& depths, bool is_changed) {
  const std::unique_ptr<Context> context = t.create_context();
  set_up_state_triangles(t);
  state.prepare();
  depths.refine();
  draw_state();  // some states keep pixels as they were, also from Clear
  if (is_changed) state.change();
  Drawn drawn = draw_state();
  if (depths.is_curved) return drawn;
  gl.Disable(GL_ARK);
  drawn.pictures = draw_state().pictures;
  return drawn;
}

// The same, drawn once in a process: several cases, and several lists of a case, expect it.
const Drawn& executed_at_once(Test& t, const CompiledState& state, const StateDepths& depths, bool is_changed) {
  static std::map<std::tuple<const CompiledState*, const StateDepths*, bool>, Drawn> all;
  const auto key = std::tuple{&state, &depths, is_changed};
  const auto found = all.find(key);
  return found != all.end() ? found->second
                            : all.emplace(key, draw_at_once(t, state, depths, is_changed)).first->second;
}

void compile_calls(GLuint list, GLuint called, bool by_calls) {
  gl.NewList(list, GL_COMPILE);
  by_calls ? gl.CallLists(1, GL_UNSIGNED_INT, &called) : gl.CallList(called);
  gl.EndList();
}

void check_compiled(Test& t, const CompiledState& state, const StateDepths& depths, bool is_early) {
  const Drawn& before = executed_at_once(t, state, depths, false);
  const Drawn& after = executed_at_once(t, state, depths, true);
  const std::string with = fmt::format(" with {}{}", depths.name, is_early ? ", compiled early" : "");
  const std::unique_ptr<Context> context = t.create_context();
  set_up_state_triangles(t);
  state.prepare();
  depths.refine();
  const auto compile = [&] {
    gl.NewList(inner_list, GL_COMPILE);
    state.change();
    gl.EndList();
  };
  if (is_early) compile();
  expect_drawn(t, before, 4, "before the list" + with);
  if (!is_early) compile();
  expect_drawn(t, before, 2, "after the list is compiled" + with);
  compile_calls(outer_list, inner_list, is_early);
  compile_calls(outermost_list, outer_list, !is_early);
  expect_drawn(t, before, 3, "after lists that call it are compiled" + with);
  gl.CallList(is_early ? outermost_list : outer_list);
  expect_drawn(t, after, 4, "after the call" + with);
  t.expect_no_error("the draws" + with);
}

// COMPILE_AND_EXECUTE takes effect at once.
void check_executed(Test& t, const CompiledState& state, const StateDepths& depths) {
  const Drawn& before = executed_at_once(t, state, depths, false);
  const Drawn& after = executed_at_once(t, state, depths, true);
  const std::string with = std::string(" with ") + depths.name;
  const std::unique_ptr<Context> context = t.create_context();
  set_up_state_triangles(t);
  state.prepare();
  depths.refine();
  expect_drawn(t, before, 4, "before the list" + with);
  gl.NewList(inner_list, GL_COMPILE_AND_EXECUTE);
  state.change();
  gl.EndList();
  expect_drawn(t, after, 3, "after the list is compiled and executed" + with);
  t.expect_no_error("the draws" + with);
}

// A uniform depth with lists that are compiled before and after the first draws; the other depths with one of them, which
// differs from state to state.
void check_lists(Test& t, const CompiledState& state, std::size_t number) {
  for (std::size_t i = 0; i < std::size(state_depths); ++i)
    for (const bool is_early : {false, true})
      if (i == 0 || is_early == ((i + number) % 2 == 0)) check_compiled(t, state, state_depths[i], is_early);
}

// Both pictures differ without the extension.
void check_shown(Test& t, const CompiledState& state) {
  Picture pictures[2];
  for (const bool is_changed : {false, true}) {
    const std::unique_ptr<Context> context = t.create_context();
    set_up_state_triangles(t);
    state.prepare();
    draw_state();
    if (is_changed) state.change();
    pictures[is_changed ? 1 : 0] = draw_state().pictures[0];
  }
  t.expect(!state.shows || count_different(pictures[0], pictures[1], 8) > 300, "the state shows");
}

}  // namespace

Cases compiled_states_cases() {
  Cases cases;
  std::size_t number = 0;
  for (const CompiledState& state : compiled_states()) {
    ++number;
    cases.push_back({.name = fmt::format("ark.list.compiled.{}", state.leaf),
                     .clauses = {"10.R.2-1", "11.R.10-1", "chapter-21-4"},
                     .plan = "Compile a command that sets this state into a list, and that list into other ones: "
                             "repeated draws do not change. Call it: they do.",
                     .wrong = "The state takes effect when it is compiled; or never, or not through another list.",
                     .apis = compat_only,
                     .control = [&state](Test& t) { check_shown(t, state); },
                     .check = [&state, number](Test& t) { check_lists(t, state, number); }});
    if (!state.executes) continue;
    cases.push_back({.name = fmt::format("ark.list.compiled.{}.executed", state.leaf),
                     .clauses = {"10.R.2-1", "11.R.10-1", "chapter-21-4"},
                     .plan = "The same, with COMPILE_AND_EXECUTE: the draws change at once.",
                     .wrong = "What is compiled is not executed.",
                     .apis = compat_only,
                     .check = [&state](Test& t) {
                       for (const StateDepths& depths : state_depths) check_executed(t, state, depths);
                     }});
  }
  return cases;
}

}  // namespace glark::conformance
