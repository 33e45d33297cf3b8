// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// How a geometry shader uses its input vertices, as far as its text shows.
#pragma once

#include <set>
#include <string>
#include <vector>

namespace glark::refine {

// The identifiers that gl_Position is computed from, directly or through other variables.
std::set<std::string> words_of_positions(const std::vector<std::string>& sources);

// Returns whether the positions of the shader's triangles do not depend on the input vertices. Every refined triangle
// would then draw them again.
bool makes_its_own_positions(const std::vector<std::string>& sources);

}  // namespace glark::refine
