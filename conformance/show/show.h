// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "conformance/suite/case.h"

namespace glark::conformance {

// Runs a case and returns its calls of OpenGL as a function in C99, with the plan of the case as a comment. Names of
// objects, locations and results are those of this run. What only asks OpenGL is left out.
std::string show(const Case& shown, Platform& platform, Api api, unsigned random_seed);

}  // namespace glark::conformance
