// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Replaces the application's program with a derived program, and restores it afterwards: by name, or as a stage of a
// program pipeline, with the chosen subroutines.
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
