// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The cases by area. Every file defines some; written_cases() joins them.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "conformance/suite/case.h"

namespace glark::conformance {

using Cases = std::vector<Case>;

// Makes cases whose names begin alike and that share a control.
struct Area {
  const char* prefix;  // "ark.area."
  void (*control)(Test&) = nullptr;
  Apis apis = every_api;

  Case operator()(const std::string& leaf, std::vector<std::string> clauses, std::string plan, std::string wrong,
                  std::function<void(Test&)> check) const {
    return (*this)(leaf, std::move(clauses), std::move(plan), std::move(wrong), std::move(check), apis);
  }
  Case operator()(const std::string& leaf, std::vector<std::string> clauses, std::string plan, std::string wrong,
                  std::function<void(Test&)> check, Apis of_case) const {
    return {.name = prefix + leaf,
            .clauses = std::move(clauses),
            .plan = std::move(plan),
            .wrong = std::move(wrong),
            .apis = of_case,
            .control = control,
            .check = std::move(check)};
  }
};

#define GLARK_CASES(folder, name) Cases name##_cases();
#include "conformance/cases/files.inc"
#undef GLARK_CASES

}  // namespace glark::conformance
