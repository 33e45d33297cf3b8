// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The programs derived from the application's: built when they are first asked for, dropped when the application's program changes.
#pragma once

#include <memory>

#include "glark/core/capture/capture.h"
#include "glark/core/refine/program/program_builder.h"
#include "glark/core/state/environment.h"

namespace glark::core {

class DerivedPrograms {
 public:
  DerivedPrograms(const Environment& environment, capture::CaptureStage& stage);

  // Finds out whether and how the program can be refined, if that is not known.
  void prepare(Program& program) const;
  // Null: it cannot be built. `owner`: the application's program whose uniforms the derived one follows; null: fixed function.
  std::shared_ptr<DerivedProgram> find(Program& program, Program* owner, const DerivedKey& key) const;
  // A program that holds the generated vertex stage of `state` beside the fragment stages of `fragment` (may be null).
  std::shared_ptr<Program> fixed_function(const refine::FixedFunctionState& state, const Program* fragment) const;
  // Takes over the uniform values of the owner that a display list has set.
  void copy_stale_uniforms(Program& owner) const;
  // Drops what was derived from the program.
  void discard(Program& program);
  // The same; says nothing to those who refer to programs by their names.
  void discard_quietly(Program& program) { builder_.discard(program); }

 private:
  const Environment& env_;
  capture::CaptureStage& stage_;
  refine::ProgramBuilder builder_;
};

}  // namespace glark::core
