// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Programs of random steps: draws, and changes of what draws read. Each refined draw is compared with the same draw
// without refinement. A program that fails is made as short as possible.
#pragma once

#include <functional>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "conformance/changes/changed_draw.h"
#include "conformance/changes/combinations.h"

namespace glark::conformance {

struct Step {
  const Change* change = nullptr;  // null: a draw
  Combination draw = {};
};

struct RandomProgram {
  int triangles = 4;
  std::vector<Step> steps;
};

RandomProgram random_program(std::mt19937& random, Api api, int version, std::size_t steps);

// Runs the program in a context of its own. Returns what is wrong with the first picture that is wrong.
std::optional<std::string> run(Test& t, const RandomProgram& program);

// Leaves out steps as long as the program still fails; runs it at most `most_runs` times (delta debugging: Zeller and
// Hildebrandt 2002, Simplifying and isolating failure-inducing input).
RandomProgram shortest(const RandomProgram& program, const std::function<bool(const RandomProgram&)>& fails,
                       int most_runs);

// The steps, a line each.
std::string text_of(const RandomProgram& program);

}  // namespace glark::conformance
