// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <iterator>
#include <utility>

#include "conformance/cases/cases.h"

namespace glark::conformance {
namespace {

void add(Cases& all, Cases cases) { std::move(cases.begin(), cases.end(), std::back_inserter(all)); }

}  // namespace

Cases written_cases() {
  Cases all;
#define GLARK_CASES(folder, name) add(all, name##_cases());
#include "conformance/cases/files.inc"
#undef GLARK_CASES
  return all;
}

}  // namespace glark::conformance
