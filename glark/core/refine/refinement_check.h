// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Mistakes in a refinement shader that the compiler would report in words of the derived program, or not at all.
#pragma once

#include <set>
#include <span>
#include <string>

#include "glark/core/capture/record.h"
#include "glark/core/refine/glsl/tokens.h"

namespace glark::refine {

struct RefinementSurroundings {
  std::span<const capture::Field> inputs;  // active ones of the vertex stage
  const std::set<std::string>& outputs;    // names that the vertex stage declares as outputs
  bool es = false;
};

// Returns "refinement shader:LINE: error: ..." for the first mistake, or an empty text. Never throws on any text.
std::string find_mistake(const Tokens& source, const RefinementSurroundings& surroundings);

}  // namespace glark::refine
