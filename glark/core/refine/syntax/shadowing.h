// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Names of local variables that hide a local variable of the same name in an enclosing block.
#pragma once

#include <set>
#include <string>

#include "glark/core/refine/glsl/tokens.h"

namespace glark::refine {

// `tokens`: a valid shader after preprocessing. May name too many variables, never too few.
std::set<std::string> shadowing_names(const Tokens& tokens);

}  // namespace glark::refine
