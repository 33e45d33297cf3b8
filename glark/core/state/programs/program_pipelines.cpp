// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/state/programs/program_pipelines.h"

namespace glark::core {
namespace {

constexpr std::array<GLbitfield, pipeline_stages.size()> stage_bits = {GL_VERTEX_SHADER_BIT, GL_TESS_CONTROL_SHADER_BIT,
                                                                       GL_TESS_EVALUATION_SHADER_BIT,
                                                                       GL_GEOMETRY_SHADER_BIT, GL_FRAGMENT_SHADER_BIT};

}  // namespace

const PipelineObject& ProgramPipelines::object(GLuint pipeline) {
  const auto known = objects_.find(pipeline);
  if (known != objects_.end()) {
    return known->second;
  }
  PipelineObject& object = objects_[pipeline];
  for (std::size_t i = 0; i < pipeline_stages.size(); ++i) {
    GLint program = 0;
    gl_.GetProgramPipelineiv(pipeline, pipeline_stages[i], &program);
    object.programs[i] = static_cast<GLuint>(program);
  }
  GLint active = 0;
  gl_.GetProgramPipelineiv(pipeline, GL_ACTIVE_PROGRAM, &active);
  object.active = static_cast<GLuint>(active);
  return object;
}

GLuint ProgramPipelines::with_derived(const PipelineObject& of, GLuint derived, std::uint64_t epoch) {
  if (epoch != epoch_) {
    release();
    epoch_ = epoch;
  }
  GLuint& name = own_[{of.programs, derived}];
  if (name != 0) {
    return name;
  }
  gl_.GenProgramPipelines(1, &name);
  for (std::size_t i = 0; i < pipeline_stages.size(); ++i) {
    if (of.programs[i] != 0) {
      gl_.UseProgramStages(name, stage_bits[i], of.programs[i] == of.vertex() ? derived : of.programs[i]);
    }
  }
  return name;
}

void ProgramPipelines::release() {
  for (const auto& [key, name] : own_) {
    gl_.DeleteProgramPipelines(1, &name);
  }
  own_.clear();
}

}  // namespace glark::core
