// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The application's refinement shader: GLSL that defines void refine(), to be put in front of our main.
#pragma once

#include <set>
#include <string>

#include "glark/core/refine/glsl/rewrite.h"

namespace glark::refine {

// Line numbers within the application's refinement shader carry this source string number in the compiler's log.
inline constexpr int refinement_source_string = 7001;

struct RefinementSource {
  std::string text;        // '#line', then the source: lines as they were, names as in the derived program
  std::string extensions;  // its #extension lines, which must come first in the shader
  std::set<std::string> identifiers;
};

// A uniform that both texts declare is one uniform (11.R.9). Removes such declarations from the source; the shader
// around it keeps them.
void drop_repeated_uniforms(Tokens& source, const Interface& elsewhere, bool es_context);

// `names` as for the application's own text. Macros are left to the driver's preprocessor.
RefinementSource prepare_refinement_source(const Tokens& source, const std::string& prefix, const NewNames& names,
                                           const GlslVersion& version);

}  // namespace glark::refine
