// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <stdexcept>

#include "conformance/suite/case.h"

namespace glark::conformance {
namespace {

bool is_well_named(const std::string& name) {
  return name.starts_with("ark.") &&
         name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_.") == std::string::npos;
}

std::vector<Case> sorted_cases() {
  std::vector<Case> all = written_cases();
  std::sort(all.begin(), all.end(), [](const Case& a, const Case& b) { return a.name < b.name; });
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!is_well_named(all[i].name)) throw std::logic_error("no name for a case: " + all[i].name);
    if (i > 0 && all[i - 1].name == all[i].name) throw std::logic_error("two cases are named " + all[i].name);
    if (all[i].clauses.empty() || all[i].plan.empty())
      throw std::logic_error(all[i].name + " has no clause or no plan");
    for (const std::string& clause : all[i].clauses) sentence_of(clause);
  }
  return all;
}

}  // namespace

const std::vector<Case>& all_cases() {
  static const std::vector<Case> cases = sorted_cases();
  return cases;
}

const Case* find_case(const std::string& name) {
  for (const Case& each : all_cases())
    if (each.name == name) return &each;
  return nullptr;
}

}  // namespace glark::conformance
