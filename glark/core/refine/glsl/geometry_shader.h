// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What a geometry shader does with the vertices that it is given, as far as its text tells.
#pragma once

#include <set>
#include <string>
#include <vector>

namespace glark::refine {

// The identifiers in what is assigned to gl_Position, and in what those are assigned, and so on.
std::set<std::string> words_of_positions(const std::vector<std::string>& sources);

// Whether its triangles lie in places that do not depend on the vertices at all: then every refined triangle would give them again.
bool makes_its_own_positions(const std::vector<std::string>& sources);

}  // namespace glark::refine
