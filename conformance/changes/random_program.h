// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Programs of random steps: draws, and changes of what draws read. Each refined draw is compared with the same draw
// without refinement.
#pragma once

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

// The steps, a line each.
std::string text_of(const RandomProgram& program);

}  // namespace glark::conformance
