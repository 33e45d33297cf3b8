// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Hooks of calls that choose the program, the program pipeline or the subroutines in use.
#include "glark/core/track/track.h"

namespace glark::core {
namespace {

// Another program comes into use. The draws of the old one may have written buffers.
void leave_program(Context& c) {
  const bool known = c.state().programs().current() != nullptr;
  if (known ? c.state().programs().current()->may_store
            : c.state().bindings().program != 0 || c.state().bindings().pipeline != 0) {
    c.writes().by_gpu();
  }
}

// Updates the state when another program or program pipeline is bound. Returns false while a display list is compiled
// without execution: then nothing is bound.
bool follow_change(Context& c) {
  leave_program(c);
  if (!track::executes(c)) {
    return false;
  }
  c.state().programs().subroutines().forget();
  c.state().programs().refresh_mirroring();
  if (c.state().bindings().transform_feedback.active && c.state().bindings().stale) {
    // Feedback may have ended. Then GL accepts the program, and later uniform calls set its values.
    c.state().refresh();
  }
  return true;
}

// Returns false if GL may have refused the program.
bool use_known(Context& c, GLuint program) {
  if (c.state().bindings().transform_feedback.active) {
    return false;
  }
  c.state().programs().use(c.state().programs().find(program));
  const std::shared_ptr<Program>& current = c.state().programs().current();
  return current != nullptr && current->linked;
}

}  // namespace

namespace hook {

void UseProgram(Context& c, GLuint program) {
  if (track::refused_while_capturing(c)) {
    return;
  }
  c.gl().UseProgram(program);
  if (!follow_change(c)) {
    return;
  }
  if (program != 0 && !use_known(c, program)) {
    c.state().forget_bindings();  // GL may have refused
    return;
  }
  if (program == 0) {
    c.state().programs().use(nullptr);
  }
  if (c.state().bindings().program != program && c.state().bindings().program == 0) {
    c.state().fixed_function().touch();
  }
  c.state().bindings().program = program;
}

void UniformSubroutinesuiv(Context& c, GLenum type, GLsizei count, const GLuint* indices) {
  c.gl().UniformSubroutinesuiv(type, count, indices);
  c.state().programs().subroutines().forget();
}

void BindProgramPipeline(Context& c, GLuint pipeline) {
  if (track::refused_while_capturing(c)) {
    return;
  }
  c.gl().BindProgramPipeline(pipeline);
  if (!follow_change(c)) {
    return;
  }
  if (pipeline != 0 &&
      (c.state().bindings().transform_feedback.active || c.gl().IsProgramPipeline(pipeline) == GL_FALSE)) {
    c.state().forget_bindings();  // GL may have refused
    return;
  }
  c.state().bindings().pipeline = pipeline;
}

void UseProgramStages(Context& c, GLuint pipeline, GLbitfield stages, GLuint program) {
  c.gl().UseProgramStages(pipeline, stages, program);
  leave_program(c);
  c.state().programs().subroutines().forget();
  c.state().programs().pipelines().changed(pipeline);
}

void ActiveShaderProgram(Context& c, GLuint pipeline, GLuint program) {
  c.gl().ActiveShaderProgram(pipeline, program);
  c.state().programs().pipelines().changed(pipeline);
}

void DeleteProgramPipelines(Context& c, GLsizei n, const GLuint* pipelines) {
  c.gl().DeleteProgramPipelines(n, pipelines);
  for (GLsizei i = 0; i < n && pipelines != nullptr; ++i) {
    c.state().programs().pipelines().changed(pipelines[i]);
  }
  c.state().forget_bindings();  // deleting unbinds
}

}  // namespace hook
}  // namespace glark::core
