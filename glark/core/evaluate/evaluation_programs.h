// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The programs that evaluate vertex inputs at refined vertices.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "glark/core/capture/layout.h"
#include "glark/core/shape.h"
#include "glark/core/state/environment.h"

namespace glark::evaluate {

struct EvaluationProgram {
  GLuint name = 0;          // 0: it could not be built
  GLint shape_number = -1;  // location of the uniform
  core::DisplacementUniforms displacement;
  std::vector<std::string> uniforms;  // of the application's refinement shader, element by element
};

class EvaluationPrograms {
 public:
  explicit EvaluationPrograms(const core::Environment& environment) : env_(environment) {}

  // What a program is built for; the same for all draws with `derived`.
  struct Request {
    const std::shared_ptr<core::DerivedProgram>& derived;
    bool placed = false;                 // pieces have a placement
    std::string_view refinement_source;  // the application's
  };
  // Builds the program when it is first asked for. Wrap in an ErrorScope.
  const EvaluationProgram& find(const Request& request);
  void release();

 private:
  EvaluationProgram build(const Request& request);
  void find_uniforms(EvaluationProgram& program, std::string& error) const;

  const core::Environment& env_;
  std::map<std::weak_ptr<const core::DerivedProgram>, EvaluationProgram, std::owner_less<>> of_derived_;
  std::map<std::string, EvaluationProgram> by_source_;  // derived programs with the same inputs share one
};

}  // namespace glark::evaluate
