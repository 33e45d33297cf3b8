// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The program in use where it is more than one name: stages of a program pipeline, and the subroutines that were chosen.
#include "glark/core/context.h"
#include "glark/core/pipeline.h"
#include "glark/core/refine/program/subroutines.h"

namespace glark::core {

Cause Pipeline::find_pipeline_program(Plan& plan) {
  const PipelineObject& object = context_.state().programs().pipelines().object(context_.state().bindings().pipeline);
  if (object.vertex() == 0) {
    return Cause::program_pipeline;
  }
  if (object.tessellation() != 0) {
    return Cause::tessellation;
  }
  for (const GLuint name : object.programs) {
    const std::shared_ptr<Program> program = name != 0 ? context_.state().programs().known(name) : nullptr;
    if (name != 0 && program == nullptr) {
      return Cause::program_gone;
    }
    if (name == object.vertex()) {
      plan.program = plan.owner = program.get();
    }
    if (program != nullptr && !program->linked) {
      return Cause::program_gone;
    }
  }
  plan.pipeline = &object;
  if (!plan.program->prepared) {
    ErrorScope errors(context_.pending_error());
    builder_.prepare(*plan.program);
  }
  return plan.program->cause;
}

void Pipeline::read_subroutines(const Plan& plan) {
  if (context_.state().programs().subroutines_known()) {
    return;
  }
  SubroutineChoice choice;
  const bool has_subroutines = gl_.GetProgramStageiv != nullptr && plan.owner != nullptr;
  for (std::size_t i = 0; has_subroutines && i < pipeline_stages.size(); ++i) {
    const GLuint provider = plan.pipeline != nullptr ? plan.pipeline->programs[i] : plan.owner->name;
    if (provider == 0) {
      continue;
    }
    Program& program = *context_.state().programs().known(provider);
    if (!program.subroutines_asked) {
      program.subroutines_asked = true;
      ErrorScope errors(context_.pending_error());
      program.uses_subroutines = refine::has_subroutine_uniforms(gl_, program);
    }
    if (program.uses_subroutines && program.has_stage(pipeline_stages[i])) {
      refine::read_subroutines(gl_, provider, pipeline_stages[i], choice);
    }
  }
  context_.state().programs().set_subroutines(std::move(choice));
}

void Pipeline::use_derived(const Plan& plan) {
  if (plan.pipeline != nullptr) {
    const std::uint64_t epoch = context_.share().program_epoch.load(std::memory_order_relaxed);
    gl_.UseProgram(0);
    gl_.BindProgramPipeline(
        context_.state().programs().pipelines().with_derived(*plan.pipeline, plan.derived->name, epoch));
  } else {
    gl_.UseProgram(plan.derived->name);
  }
  if (!context_.state().programs().subroutines().empty()) {
    refine::choose_subroutines(gl_, context_.state().programs().subroutines(), plan.derived->subroutines);
  }
}

void Pipeline::use_application_program() {
  const Bindings& b = context_.state().bindings();
  gl_.UseProgram(b.program);
  if (b.program == 0 && b.pipeline != 0) {
    gl_.BindProgramPipeline(b.pipeline);
  }
  if (!context_.state().programs().subroutines().empty()) {
    refine::choose_subroutines(gl_, context_.state().programs().subroutines());
  }
}

}  // namespace glark::core
