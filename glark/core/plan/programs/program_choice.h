// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "glark/core/report/cause.h"
#include "glark/core/state/bindings.h"
#include "glark/core/state/programs/program.h"
#include "glark/core/state/programs/program_pipelines.h"

namespace glark::core {

// The origin of a draw's vertex stage.
enum class VertexStage { program, program_pipeline, assembly, fixed_function };

struct ProgramChoice {
  std::optional<Cause> cause;  // set if no vertex stage can be refined
  VertexStage stage = VertexStage::program;
};

struct ChoiceConditions {
  bool is_compatibility = false;
  bool transparent = false;  // the program does not know that it is refined
};

// `current` is the program in use; null if it is unknown. No GL.
ProgramChoice choose_program(const Bindings& bindings, const Program* current, const ChoiceConditions& conditions);
// Returns the cause why the stages of a program pipeline cannot be refined, if there is one. No GL.
std::optional<Cause> check_stages(const PipelineObject& pipeline);

}  // namespace glark::core
