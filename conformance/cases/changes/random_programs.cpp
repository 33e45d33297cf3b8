// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Random programs: changes of what draws read (ark.random.program_*), and commands and draws of all kinds, with a program
// (stage, curved, uniforms). --seed gives others.
#include <fmt/core.h>

#include "conformance/cases/cases.h"
#include "conformance/changes/random_program.h"
#include "conformance/changes/shortest.h"
#include "conformance/gl/observer.h"
#include "conformance/random/sequence.h"

namespace glark::conformance {
namespace {

constexpr int programs = 24;
constexpr std::size_t steps = 60;
constexpr int most_runs = 300;

std::string text_of(const std::string& wrong) { return wrong; }
std::string text_of(const WrongDraw& wrong) { return wrong.what; }

void attach(Test&, const std::string&) {}
void attach(Test& t, const WrongDraw& wrong) {
  if (count_different(wrong.actual, wrong.expected, 0) > 0)
    t.expect_same_picture(wrong.actual, wrong.expected, "the picture of the last draw");
}

// Makes what fails as short as possible, and logs it.
template <typename Program>
void expect_to_pass(Test& t, const Program& program) {
  const auto first = run(t, program);
  t.expect(!first, first ? "a draw is not as without refinement: " + text_of(*first) : "");
  if (!first) return;
  const auto fails = [&](const Program& tried) { return run(t, tried).has_value(); };
  const Program failing = shortest<Program>(program, fails, most_runs);
  if (observer != nullptr) observer->begins_again();  // only the shortest program is shown
  const auto wrong = run(t, failing);
  t.log(fmt::format("the shortest program that fails:\n{}: {}", text_of(failing),
                    wrong ? text_of(*wrong) : "not in each run"));
  if (wrong) attach(t, *wrong);
}

void check_program(Test& t) { expect_to_pass(t, random_program(t.random(), t.api(), t.version(), steps)); }

void check_sequence(Test& t, WorldKind kind, std::size_t number) {
  const auto all = random_sequences(t.seed(), kind, {t.api(), t.version()});
  expect_to_pass(t, all[number]);
}

void add_sequences(Cases& cases, WorldKind kind, const char* name, Apis apis) {
  for (std::size_t i = 0; i < sequence_count(kind); ++i)
    cases.push_back({.name = fmt::format("ark.random.{}_{:02}", name, i),
                     .clauses = {"10.R.2-1", "10.R.2-6", "11.R.13-1"},
                     .plan =
                         "Execute random commands and draw between them: pictures, errors, state and counts are those "
                         "of unrefined draws. A failure says the shortest sequence, and --show prints it.",
                     .wrong = "A command has another effect on refined draws than on unrefined ones.",
                     .apis = apis,
                     .check = [kind, i](Test& t) { check_sequence(t, kind, i); }});
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
  add_sequences(cases, WorldKind::stage, "stage", every_api);
  add_sequences(cases, WorldKind::uniforms, "uniforms", every_api);
  add_sequences(cases, WorldKind::curved, "curved", every_api);
  add_sequences(cases, WorldKind::fixed, "fixed", compat_only);
  add_sequences(cases, WorldKind::polygons, "polygons", compat_only);
  return cases;
}

}  // namespace glark::conformance
