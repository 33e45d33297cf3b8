// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The cases, by areas. Every file gives its own; all_cases() joins them.
#pragma once

#include <vector>

#include "conformance/suite/case.h"

namespace glark::conformance {

using Cases = std::vector<Case>;

#define GLARK_CASES(name) Cases name##_cases();
#include "conformance/cases/areas.inc"
#undef GLARK_CASES

}  // namespace glark::conformance
