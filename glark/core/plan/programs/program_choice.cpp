// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/plan/programs/program_choice.h"

namespace glark::core {

ProgramChoice choose_program(const Bindings& bindings, const Program* current, const ChoiceConditions& conditions) {
  const Bindings& b = bindings;
  if (b.program != 0 && current == nullptr) {
    return {Cause::no_program};
  }
  if (b.program == 0 && b.pipeline != 0) {
    return {std::nullopt, VertexStage::program_pipeline};
  }
  if (current != nullptr && (!current->linked || current->cause == Cause::program_gone)) {
    return {Cause::program_gone};
  }
  if (current != nullptr && (current->stages.empty() || current->has_stage(GL_VERTEX_SHADER))) {
    return {std::nullopt, VertexStage::program};
  }
  if (!conditions.is_compatibility) {
    return {Cause::no_program};
  }
  if (b.vertex_program) {
    // The extension's text: a program that uses the extension gets such draws unrefined.
    return conditions.transparent ? ProgramChoice{std::nullopt, VertexStage::assembly}
                                  : ProgramChoice{Cause::assembly_program};
  }
  return {std::nullopt, VertexStage::fixed_function};
}

std::optional<Cause> check_stages(const PipelineObject& pipeline) {
  if (pipeline.vertex() == 0) {
    return Cause::program_pipeline;
  }
  if (pipeline.tessellation() != 0) {
    return Cause::tessellation;
  }
  return std::nullopt;
}

}  // namespace glark::core
