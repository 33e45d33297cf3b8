// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Puts a derived program in use in place of the application's, and gives the application's program back: by name, or as a stage of
// a program pipeline, and with the subroutines that were chosen.
#pragma once

#include "glark/core/state/environment.h"
#include "glark/core/state/programs/program_pipelines.h"

namespace glark::core {

class ProgramSwitch {
 public:
  explicit ProgramSwitch(const Environment& environment) : env_(environment) {}

  // Reads the subroutines of the program in use, unless they are known. `owner` may be null: fixed function.
  void read_subroutines(const Program* owner, const PipelineObject* pipeline) const;
  // `pipeline`: null unless the application's stages are separate programs.
  void use_derived(const DerivedProgram& derived, const PipelineObject* pipeline) const;
  void use_application() const;

 private:
  const Environment& env_;
};

}  // namespace glark::core
