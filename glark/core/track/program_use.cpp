// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Hooks of what is in use: the program or the program pipeline, and the subroutines.
#include "glark/core/track/track.h"

namespace glark::core {
namespace {

// The program in use is about to be another: what its draws stored, they have stored.
void leave_program(Context& c) {
  const bool known = c.current_program != nullptr;
  if (known ? c.current_program->may_store : c.bindings.program != 0 || c.bindings.pipeline != 0) {
    c.gpu_wrote();
  }
}

}  // namespace

namespace hook {

void UseProgram(Context& c, GLuint program) {
  c.gl.UseProgram(program);
  leave_program(c);
  if (!track::executes(c)) {
    return;
  }
  c.subroutines_known = false;
  c.mirror_uniforms = c.share->any_derived.load(std::memory_order_relaxed);
  if (c.bindings.transform_feedback_active && c.bindings_stale) {
    c.refresh_bindings();  // it may have ended, and the uniforms that follow are of the new program
  }
  if (program != 0 &&
      (c.bindings.transform_feedback_active || (c.current_program = track::find_program(c, program)) == nullptr ||
       !c.current_program->linked)) {
    c.bindings_stale = true;  // GL may have refused
    return;
  }
  if (program == 0) {
    c.current_program = nullptr;
  }
  if (c.bindings.program != program && c.bindings.program == 0) {
    c.fixed_function_stale = true;
  }
  c.bindings.program = program;
}

void UniformSubroutinesuiv(Context& c, GLenum type, GLsizei count, const GLuint* indices) {
  c.gl.UniformSubroutinesuiv(type, count, indices);
  c.subroutines_known = false;
}

void BindProgramPipeline(Context& c, GLuint pipeline) {
  c.gl.BindProgramPipeline(pipeline);
  leave_program(c);
  if (!track::executes(c)) {
    return;
  }
  c.subroutines_known = false;
  c.mirror_uniforms = c.share->any_derived.load(std::memory_order_relaxed);
  if (c.bindings.transform_feedback_active && c.bindings_stale) {
    c.refresh_bindings();
  }
  if (pipeline != 0 && (c.bindings.transform_feedback_active || c.gl.IsProgramPipeline(pipeline) == GL_FALSE)) {
    c.bindings_stale = true;  // GL may have refused
    return;
  }
  c.bindings.pipeline = pipeline;
}

void UseProgramStages(Context& c, GLuint pipeline, GLbitfield stages, GLuint program) {
  c.gl.UseProgramStages(pipeline, stages, program);
  leave_program(c);
  c.subroutines_known = false;
  if (c.pipeline != nullptr) {
    c.pipeline->pipeline_changed(pipeline);
  }
}

void ActiveShaderProgram(Context& c, GLuint pipeline, GLuint program) {
  c.gl.ActiveShaderProgram(pipeline, program);
  if (c.pipeline != nullptr) {
    c.pipeline->pipeline_changed(pipeline);
  }
}

void DeleteProgramPipelines(Context& c, GLsizei n, const GLuint* pipelines) {
  c.gl.DeleteProgramPipelines(n, pipelines);
  for (GLsizei i = 0; i < n && c.pipeline != nullptr && pipelines != nullptr; ++i) {
    c.pipeline->pipeline_changed(pipelines[i]);
  }
  c.bindings_stale = true;  // deleting unbinds
}

}  // namespace hook
}  // namespace glark::core
