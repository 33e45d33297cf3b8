// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The text of the program that evaluates the vertex inputs of a draw at its refined vertices. No GL.
#pragma once

#include <string>
#include <vector>

#include "glark/core/capture/layout.h"
#include "glark/core/refinement.h"

namespace glark::evaluate {

struct EvaluationSource {
  std::string vertex;                 // empty: it cannot be made
  std::vector<std::string> varyings;  // the inputs, in the order of the record
  std::string error;
};

// The program is derived like those of the application, from a vertex stage that copies its inputs to its outputs. So
// both have the same inputs at a refined vertex, to the bit.
EvaluationSource evaluation_source(const capture::Layout& layout, core::Refinement refinement,
                                   const core::ScalarTags& tags, capture::Language language);

}  // namespace glark::evaluate
