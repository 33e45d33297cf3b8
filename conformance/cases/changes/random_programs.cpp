// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Random programs of changes and draws. --seed gives others.
#include <fmt/core.h>

#include "conformance/cases/cases.h"
#include "conformance/changes/random_program.h"
#include "conformance/gl/observer.h"

namespace glark::conformance {
namespace {

constexpr int programs = 24;
constexpr std::size_t steps = 60;
constexpr int most_runs = 300;

void check_program(Test& t) {
  const RandomProgram program = random_program(t.random(), t.api(), t.version(), steps);
  const auto first = run(t, program);
  t.expect(!first, "a picture is not that of the unrefined draw: " + first.value_or(""));
  if (!first) return;
  const auto fails = [&](const RandomProgram& tried) { return run(t, tried).has_value(); };
  const RandomProgram failing = shortest(program, fails, most_runs);
  if (observer != nullptr) observer->begins_again();  // only the shortest program is shown
  const auto wrong = run(t, failing);
  t.log(fmt::format("the shortest program that fails:\n{}: {}", text_of(failing), wrong.value_or("not in each run")));
}

}  // namespace

Cases random_programs_cases() {
  Cases cases;
  for (int i = 0; i < programs; ++i)
    cases.push_back(
        {.name = fmt::format("ark.random.program_{:02}", i),
         .clauses = {"10.R.2-1", "11.R.13-1"},
         .plan = "Draw in three ways, and change what the draws read, in 60 random steps: all pictures are those "
                 "of unrefined draws. A failure says the shortest program, and --show prints it.",
         .wrong = "What a draw read before some change.",
         .check = check_program});
  return cases;
}

}  // namespace glark::conformance
