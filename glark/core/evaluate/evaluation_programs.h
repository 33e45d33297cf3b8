// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The programs that evaluate vertex inputs at refined vertices.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "glark/core/capture/layout.h"
#include "glark/core/state/environment.h"

namespace glark::evaluate {

struct EvaluationProgram {
  GLuint name = 0;          // 0: it could not be built
  GLint shape_number = -1;  // location of the uniform
};

class EvaluationPrograms {
 public:
  explicit EvaluationPrograms(const core::Environment& environment) : env_(environment) {}

  // Builds the program when it is first asked for. Wrap in an ErrorScope.
  // `placed`: pieces have a placement; the same for all draws with `derived`.
  const EvaluationProgram& find(const std::shared_ptr<core::DerivedProgram>& derived, bool placed);
  void release();

 private:
  EvaluationProgram build(const core::DerivedProgram& derived, bool placed);

  const core::Environment& env_;
  std::map<std::weak_ptr<const core::DerivedProgram>, EvaluationProgram, std::owner_less<>> of_derived_;
  std::map<std::string, EvaluationProgram> by_source_;  // derived programs with the same inputs share one
};

}  // namespace glark::evaluate
