// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/programs/program_switch.h"

#include "glark/core/refine/program/subroutines.h"

namespace glark::core {

void ProgramSwitch::read_subroutines(const Program* owner, const PipelineObject* pipeline) const {
  Programs& programs = env_.state.programs();
  if (programs.subroutines().known()) {
    return;
  }
  SubroutineChoice choice;
  for (std::size_t i = 0; env_.gl.GetProgramStageiv != nullptr && owner != nullptr && i < pipeline_stages.size(); ++i) {
    const GLuint provider = pipeline != nullptr ? pipeline->programs[i] : owner->name;
    if (provider == 0) {
      continue;
    }
    Program& program = *programs.known(provider);
    if (!program.subroutines_asked) {
      program.subroutines_asked = true;
      ErrorScope errors(env_.errors);
      program.uses_subroutines = refine::has_subroutine_uniforms(env_.gl, program);
    }
    if (program.uses_subroutines && program.has_stage(pipeline_stages[i])) {
      refine::read_subroutines(env_.gl, provider, pipeline_stages[i], choice);
    }
  }
  programs.subroutines().set(std::move(choice));
}

void ProgramSwitch::use_derived(const DerivedProgram& derived, const PipelineObject* pipeline) const {
  Programs& programs = env_.state.programs();
  if (pipeline != nullptr) {
    const std::uint64_t epoch = env_.share.program_epoch.load(std::memory_order_relaxed);
    env_.gl.UseProgram(0);
    env_.gl.BindProgramPipeline(programs.pipelines().with_derived(*pipeline, derived.name, epoch));
  } else {
    env_.gl.UseProgram(derived.name);
  }
  if (const SubroutineChoice& choice = programs.subroutines().choice(); !choice.empty()) {
    refine::choose_subroutines(env_.gl, choice, derived.subroutines);
  }
}

void ProgramSwitch::use_application() const {
  const Bindings& b = env_.bindings();
  env_.gl.UseProgram(b.program);
  if (b.program == 0 && b.pipeline != 0) {
    env_.gl.BindProgramPipeline(b.pipeline);
  }
  if (const SubroutineChoice& choice = env_.state.programs().subroutines().choice(); !choice.empty()) {
    refine::choose_subroutines(env_.gl, choice);
  }
}

}  // namespace glark::core
