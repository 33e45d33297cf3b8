// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace glark::refine {

// The compiler numbers the lines of the refinement shader from here on, so that they differ from all other lines. Not all
// drivers print the number of the source string.
inline constexpr int first_refinement_line = 1000001;
inline constexpr int first_line_after_refinement = 2000001;

// Rewrites the log of the driver's compiler for the author of the shaders: lines of the refinement shader have their own
// numbers, names are those of the author, and warnings about other text are left out. `prefix` begins our names.
std::string log_for_author(std::string_view log, const std::string& prefix);

}  // namespace glark::refine
