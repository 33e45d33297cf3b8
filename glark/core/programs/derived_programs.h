// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Programs derived from the application's programs. They are built on first use, and dropped when the application's
// program changes.
#pragma once

#include <memory>
#include <string>

#include "glark/core/capture/capture.h"
#include "glark/core/refine/program/program_builder.h"
#include "glark/core/state/environment.h"

namespace glark::core {

class DerivedPrograms {
 public:
  DerivedPrograms(const Environment& environment, capture::CaptureStage& stage);

  // Determines whether and how the program can be refined, unless this is known.
  void prepare(Program& program) const;
  // As ProgramBuilder::variation(). The program is prepared.
  const refine::StageVariation& variation(Program& program, std::uint32_t instanced) const {
    return builder_.variation(program, instanced);
  }
  // Returns null if the program cannot be built, or must wait for the next frame (Compilation::refused()). The derived program follows the uniforms of `owner`, the application's
  // program; null for fixed function.
  std::shared_ptr<DerivedProgram> find(Program& program, Program* owner, const DerivedKey& key) const;
  // A program that holds the generated vertex stage of `state` beside the fragment stages of `fragment` (may be null).
  std::shared_ptr<Program> fixed_function(const refine::FixedFunctionState& state, const Program* fragment) const;
  // The same with the GLSL of an assembly program. Null: GL refuses it.
  std::shared_ptr<Program> assembly(const std::string& source, const Program* fragment) const;
  // Takes over the uniform values of the owner that a display list has set.
  void copy_stale_uniforms(Program& owner) const;
  // Drops the programs derived from this program.
  void discard(Program& program);
  // Deletes a program of ours that was made with the fragment stages of the application's program `fragment`.
  void remove_generated(GLuint fragment, Program& program);

 private:
  const Environment& env_;
  capture::CaptureStage& stage_;
  refine::ProgramBuilder builder_;
};

}  // namespace glark::core
