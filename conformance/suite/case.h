// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "conformance/platform/platform.h"

namespace glark::conformance {

class Test;

// One clause of the specification, looked at in one way.
struct Case {
  std::string name;                  // "ark.area.topic.leaf": lower case, digits, underscores and dots
  std::vector<std::string> clauses;  // ids of clauses/clauses.txt; the sentences are quoted from there
  std::string plan;                  // how the case looks at it
  std::string wrong = {};            // what typical wrong implementations do or draw, and how that shows
  std::vector<Api> apis = {Api::gl_compat, Api::gl_core, Api::gles};
  // What must hold without refinement: if it does not, the case cannot judge. Runs in a context of its own.
  std::function<void(Test&)> control = {};
  std::function<void(Test&)> check = {};  // empty: planned, not written
};

// What the program was built with, in any order: cases/joined.cpp, or what a test of the suite has in its place.
std::vector<Case> written_cases();

// In order of their names; the same for every run. Throws std::logic_error where two have one name.
const std::vector<Case>& all_cases();

// The sentence with this id. Throws std::logic_error where there is none.
const std::string& sentence_of(const std::string& clause);

}  // namespace glark::conformance
