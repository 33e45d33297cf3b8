// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The text of the program that evaluates the vertex inputs of a draw at its refined vertices. No GL.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "glark/core/capture/layout.h"
#include "glark/core/refinement.h"
#include "glark/core/state/programs/derived_program.h"

namespace glark::evaluate {

struct EvaluationSource {
  std::string vertex;                 // empty: it cannot be made
  std::vector<std::string> varyings;  // the inputs of the vertex stage, in the order of copied_fields()
  std::string error;
};

// The program is derived like those of the application, from a vertex stage that copies its inputs to its outputs. So
// both have the same inputs at a refined vertex, to the bit.
struct EvaluationRequest {
  const core::DerivedProgram& derived;  // the layout, and what the surface depends on
  core::ScalarTags constant_tags;
  bool placed = false;                 // pieces have a placement
  std::string_view refinement_source;  // the application's refinement shader, or empty
  capture::Language language = capture::Language::core;
  bool creased = false;  // see refine::DeriveRequest
};
EvaluationSource evaluation_source(const EvaluationRequest& request);

}  // namespace glark::evaluate
