// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "conformance/platform/platform.h"

namespace glark::conformance {

class Test;

// The APIs that a case concerns.
class Apis {
 public:
  constexpr Apis(std::initializer_list<Api> apis) {
    for (const Api api : apis) bits_ |= bit(api);
  }
  constexpr bool contains(Api api) const { return (bits_ & bit(api)) != 0; }

 private:
  static constexpr unsigned bit(Api api) { return 1U << static_cast<unsigned>(api); }
  unsigned bits_ = 0;
};
inline constexpr Apis every_api = {Api::gl_compat, Api::gl_core, Api::gles};
inline constexpr Apis desktop_apis = {Api::gl_compat, Api::gl_core};
inline constexpr Apis compat_only = {Api::gl_compat};

// Checks one or more clauses of the specification in one way.
struct Case {
  std::string name;                  // "ark.area.topic.leaf": lower case, digits, underscores and dots
  std::vector<std::string> clauses;  // ids of clauses/clauses.txt; the sentences are quoted from there
  std::string plan;                  // how the case checks the sentences
  std::string wrong = {};            // what typical wrong implementations do or draw, and how that shows
  Apis apis = every_api;
  // The case needs what an implementation may lack. Only such a case may call Test::not_supported().
  bool is_optional = false;
  std::vector<std::string> commands = {};  // the commands of GL whose effect on draws the case checks; "DrawArrays"
  // Checks what must hold without refinement, in a context of its own. If it fails, the case cannot judge.
  std::function<void(Test&)> control = {};
  std::function<void(Test&)> check = {};  // empty: planned, not written
};

// Marks a case that needs what an implementation may lack.
inline Case optional(Case each) {
  each.is_optional = true;
  return each;
}

// The program's cases, in any order. cases/written_cases.cpp defines it; tests of the suite define their own.
std::vector<Case> written_cases();

// All cases, sorted by name. Throws std::logic_error if two have the same name.
const std::vector<Case>& all_cases();
// Null if there is no case of this name.
const Case* find_case(const std::string& name);

// The sentence with this id. Throws std::logic_error if there is none.
const std::string& sentence_of(const std::string& clause);

}  // namespace glark::conformance
