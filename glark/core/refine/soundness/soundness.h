// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Is it sound to run a vertex stage on interpolated inputs? Decided on the syntax tree, by an abstract run of the
// stage that follows how each value depends on the vertex attributes.
//
// Assignments, structures, arrays, functions with output parameters, loops and conditions are followed. A value that
// is assigned under a condition depends on the condition. Functions that main() does not reach do not count.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "glark/core/refine/syntax/syntax_tree.h"
#include "glark/core/state/programs/variation.h"

namespace glark::refine {

// How each output varies. `trees`: those of all shader objects of the stage. Empty if the stage is too large
// to be followed. `constants`: names of attributes that are the same at all corners of a triangle.
std::optional<StageVariation> find_variation(const std::vector<const SyntaxTree*>& trees,
                                             const std::set<std::string>& constants = {});

// The names of all variables that main() and the functions it reaches mention, and those in initialisers of globals.
std::set<std::string> reached_names(const std::vector<const SyntaxTree*>& trees);

}  // namespace glark::refine
