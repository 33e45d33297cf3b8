// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/submit/submission.h"

#include "glark/core/refine/derive.h"
#include "glark/core/report/statistics.h"
#include "glark/core/shape.h"

namespace glark::submit {
namespace {

// The application's own program draws refined vertices, so no mode differs.
constexpr ModeChanges no_changes;
constexpr refine::FixedFunctionState not_read;

bool is_indirect(const core::DrawPlan& plan, const RefinedTriangles& refined) {
  return plan.depth.adaptive || refined.triangles.count_on_gpu;
}

}  // namespace

Submission::Submission(const core::Environment& environment, const Parts& parts)
    : env_(environment), parts_(parts), modes_(environment), stage_(environment.gl) {}

void Submission::begin(const core::DrawPlan& plan, bool indirect) const {
  const core::Bindings& b = env_.bindings();
  if (plan.owner != nullptr) {
    parts_.programs.derived().copy_stale_uniforms(*plan.owner);
  }
  if (plan.corners != nullptr) {
    core::set_shape(env_.gl, env_.options, env_.ark, *plan.corners);
  }
  if (plan.assembly != nullptr) {
    parts_.programs.assembly().upload(*plan.assembly, *plan.derived);
    if (plan.corners != nullptr) {
      parts_.programs.assembly().upload(*plan.assembly, *plan.corners);
    }
  }
  stop_restart();
  if (indirect && b.parameter_buffer != 0) {
    env_.gl.BindBuffer(GL_PARAMETER_BUFFER, 0);  // Mesa 22 reads the count of every indirect draw from it
  }
}

void Submission::draw(const core::DrawPlan& plan, const RefinedTriangles& refined) {
  const core::Bindings& b = env_.bindings();
  if (refined.storage_changed) {
    restore_storage();  // the vertex stage may read it
  }
  const bool captures = parts_.feedback.captures(b);
  if (captures && parts_.feedback.mode != GL_TRIANGLES) {
    parts_.capture.set_feedback_mode(plan.capture.program, parts_.feedback.mode, b);
  }
  parts_.programs.in_use().use_derived(*plan.derived, plan.pipeline);
  if (captures) {
    env_.gl.ResumeTransformFeedback();
    parts_.feedback.has_captured = true;
  }
  const refine::FixedFunctionState& fixed = parts_.programs.fixed_function().state();
  const ModeChanges changes = mode_changes(plan, fixed, b);
  modes_.set(changes, fixed);
  set_inputs(plan, refined);
  issue(plan, refined);
  modes_.reset(changes, fixed);
  if (captures) {
    env_.gl.PauseTransformFeedback();
  }
  resume_restart();
  const bool indirect = is_indirect(plan, refined);
  drew_indirectly_ = drew_indirectly_ || indirect;
  if (indirect && b.parameter_buffer != 0) {
    env_.gl.BindBuffer(GL_PARAMETER_BUFFER, b.parameter_buffer);
  }
  restore(indirect, plan.derived->stored());
}

void Submission::draw_vertices(const core::RefinedVertices& vertices) {
  stop_restart();
  modes_.set(no_changes, not_read);
  env_.gl.BindVertexArray(vertices.vertex_array);
  env_.gl.DrawElements(GL_TRIANGLES, vertices.index_count, GL_UNSIGNED_INT, nullptr);
  restore_vertex_array();
  modes_.reset(no_changes, not_read);
  resume_restart();
}

void Submission::set_inputs(const core::DrawPlan& plan, const RefinedTriangles& refined) const {
  const core::DerivedProgram& derived = *plan.derived;
  core::set_shape(env_.gl, env_.options, env_.ark, derived);
  if (derived.stored()) {
    const GLintptr first_word = plan.depth.adaptive ? 0 : refined.triangles.offset / 4;
    env_.gl.ProgramUniform1i(derived.name, derived.first_word, static_cast<GLint>(first_word));
    env_.gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, refine::records_binding,
                           plan.depth.adaptive ? refined.instances.records : refined.triangles.buffer);
  }
}

void Submission::issue(const core::DrawPlan& plan, const RefinedTriangles& refined) {
  const bool stored = plan.derived->stored();
  const capture::Layout* const layout = plan.capture.layout;
  const pattern::GpuPool& pool = parts_.pool.pool();
  if (plan.depth.adaptive) {
    stage_.draw_binned(pool, refined.instances,
                       {stored ? 0 : layout->chunk_count(), plan.derived->numbered ? refined.numbers : 0});
    return;
  }
  const unsigned level = plan.depth.level;
  stage_.draw_uniform(pool, {refined.triangles, layout, stored, level, plan.placed, refined.count_command});
  core::statistics().refined_triangles +=
      refined.triangles.count_on_gpu ? 0 : std::uint64_t{refined.triangles.count} << (2 * level);
}

void Submission::restore(bool indirect, bool storage) const {
  const core::Bindings& b = env_.bindings();
  restore_vertex_array();
  parts_.programs.in_use().use_application();
  if (indirect) {
    env_.gl.BindBuffer(GL_DRAW_INDIRECT_BUFFER, b.draw_indirect_buffer);
  }
  if (storage) {
    restore_storage();
  }
}

void Submission::flush_indirect() {
  if (drew_indirectly_) {
    drew_indirectly_ = false;
    env_.gl.Flush();
  }
}

void Submission::restore_after_capture() const { restore(false, false); }

// Restart must not apply to our own index buffers, nor to those of the passes.
void Submission::stop_restart() const {
  if (env_.bindings().primitive_restart) {
    env_.gl.Disable(GL_PRIMITIVE_RESTART);
  }
}

void Submission::resume_restart() const {
  if (env_.bindings().primitive_restart) {
    env_.gl.Enable(GL_PRIMITIVE_RESTART);
  }
}

void Submission::restore_vertex_array() const { env_.gl.BindVertexArray(env_.bindings().vertex_array); }

void Submission::restore_storage() const {
  const core::Bindings& b = env_.bindings();
  for (GLuint i = 0; i < b.storage.size(); ++i) {
    const core::IndexedBuffer& binding = b.storage[i];
    if (binding.size > 0 && binding.buffer != 0) {
      env_.gl.BindBufferRange(GL_SHADER_STORAGE_BUFFER, i, binding.buffer, binding.offset, binding.size);
    } else {
      env_.gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, i, binding.buffer);
    }
  }
  env_.gl.BindBuffer(GL_SHADER_STORAGE_BUFFER, b.storage_buffer);
}

}  // namespace glark::submit
