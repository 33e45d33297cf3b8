// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The application's transform feedback: what it captures of refined draws, and how much a draw from it can hold.
#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "glark/core/context.h"
#include "glark/core/pipeline.h"

namespace glark::core {
namespace {

// Bytes that a vertex takes in each buffer, at least.
std::vector<std::uint64_t> feedback_strides(const gl::Dispatch& gl, GLuint program) {
  GLint count = 0;
  GLint mode = GL_INTERLEAVED_ATTRIBS;
  gl.GetProgramiv(program, GL_TRANSFORM_FEEDBACK_VARYINGS, &count);
  gl.GetProgramiv(program, GL_TRANSFORM_FEEDBACK_BUFFER_MODE, &mode);
  std::vector<std::uint64_t> strides(1, 0);
  for (GLint i = 0; i < count; ++i) {
    std::array<char, 64> name{};
    GLsizei size = 0;
    GLenum type = 0;
    gl.GetTransformFeedbackVarying(program, static_cast<GLuint>(i), static_cast<GLsizei>(name.size()), nullptr, &size,
                                   &type, name.data());
    const bool next = std::string_view(name.data()) == "gl_NextBuffer";
    if (next || (mode == GL_SEPARATE_ATTRIBS && i > 0)) {
      strides.push_back(0);
    }
    strides.back() += next ? 0 : 4 * static_cast<std::uint64_t>(std::max(1, capture::words_of(type) * size));
  }
  return strides;
}

// Of the buffer range at an indexed binding of transform feedback.
std::uint64_t bytes_bound(const gl::Dispatch& gl, GLuint index) {
  GLint buffer = 0;
  GLint64 size = 0;
  gl.GetIntegeri_v(GL_TRANSFORM_FEEDBACK_BUFFER_BINDING, index, &buffer);
  gl.GetInteger64i_v(GL_TRANSFORM_FEEDBACK_BUFFER_SIZE, index, &size);
  if (buffer != 0 && size == 0) {  // the whole buffer
    const CopyWriteBinding binding(gl, static_cast<GLuint>(buffer));
    gl.GetBufferParameteri64v(GL_COPY_WRITE_BUFFER, GL_BUFFER_SIZE, &size);
  }
  return static_cast<std::uint64_t>(std::max<GLint64>(size, 0));
}

// What transform feedback takes of triangles that go through this program; GL_NONE: the program takes no triangles.
GLenum feedback_mode(const gl::Dispatch& gl, const Program& owner, GLuint derived) {
  if (!owner.has_stage(GL_GEOMETRY_SHADER)) {
    return GL_TRIANGLES;
  }
  GLint input = 0;
  GLint output = 0;
  gl.GetProgramiv(derived, GL_GEOMETRY_INPUT_TYPE, &input);
  gl.GetProgramiv(derived, GL_GEOMETRY_OUTPUT_TYPE, &output);
  if (input != GL_TRIANGLES) {
    return GL_NONE;
  }
  return output == GL_POINTS ? GL_POINTS : output == GL_LINE_STRIP ? GL_LINES : GL_TRIANGLES;
}

}  // namespace

bool Pipeline::begin_feedback(GLenum mode) {
  const Quiet quiet = context_.state().quiet();
  const auto nothing = [] {};
  Plan plan;
  plan.for_feedback = true;
  const bool tagged = context_.ark().depth_source == DepthSource::tag;
  const DrawCall call{.mode = GL_TRIANGLES, .tags_vary = tagged, .issue = nothing};
  if (plan_draw(call, plan) != Cause::count_ || plan.pipeline != nullptr ||
      (plan.owner != nullptr ? feedback_mode(gl_, *plan.owner, plan.derived->name) : GL_TRIANGLES) != mode) {
    return false;
  }
  use_derived(plan);
  gl_.BeginTransformFeedback(mode);
  gl_.PauseTransformFeedback();
  use_application_program();
  feedback_program_ = plan.derived;
  context_.state().set_feedback_ours(true);
  feedback_mode_ = mode;
  feedback_begun_ = false;
  return true;
}

void Pipeline::hand_back_feedback() {
  if (!owns_feedback() || feedback_begun_) {
    return;
  }
  context_.state().refresh();
  if (context_.state().bindings().transform_feedback_paused || !context_.state().bindings().transform_feedback_active) {
    return;
  }
  const Quiet quiet = context_.state().quiet();
  gl_.EndTransformFeedback();
  feedback_program_ = nullptr;
  context_.state().set_feedback_ours(false);
  gl_.BeginTransformFeedback(feedback_mode_);
  context_.update_refining();
}

bool Pipeline::feedback_refuses(GLenum mode) const {
  const bool points_or_lines = mode == GL_POINTS || mode == GL_LINES || mode == GL_LINE_LOOP || mode == GL_LINE_STRIP;
  return points_or_lines && owns_feedback() && !context_.state().bindings().transform_feedback_paused &&
         feedback_mode_ == GL_TRIANGLES;
}

void Pipeline::end_feedback() {
  feedback_program_ = nullptr;
  context_.state().set_feedback_ours(false);
  awaited_feedback_ = GL_NONE;
  context_.update_refining();
}

void Pipeline::take_awaited_feedback() {
  const GLenum mode = awaited_feedback_;
  if (mode == GL_NONE) {
    return;
  }
  context_.state().refresh();
  if (context_.state().bindings().transform_feedback_paused) {
    return;
  }
  awaited_feedback_ = GL_NONE;
  if (context_.ark().enabled &&
      context_.state()
          .bindings()
          .transform_feedback_active) {  // nothing has been captured: it may begin again, with another program
    gl_.EndTransformFeedback();
    context_.state().forget_bindings();
    if (!begin_feedback(mode)) {
      gl_.BeginTransformFeedback(mode);
    }
    context_.state().bindings().transform_feedback_active = true;
  }
  context_.update_refining();
}

// Streams of a geometry shader go to buffers of their own: the one with most room bounds them all.
void Pipeline::note_feedback_room() {
  const Bindings& b = context_.state().bindings();
  const Quiet quiet = context_.state().quiet();
  ErrorScope errors(context_.pending_error());
  GLuint program = b.program;
  if (program == 0 && b.pipeline != 0) {
    const auto& programs = context_.state().programs().pipelines().object(b.pipeline).programs;
    for (const std::size_t last_stage : {3U, 2U, 0U}) {  // geometry, tessellation, vertices
      program = program != 0 ? program : programs[last_stage];
    }
  }
  std::uint64_t vertices = 0;
  if (program != 0) {
    const std::vector<std::uint64_t> strides = feedback_strides(gl_, program);
    for (std::size_t i = 0; i < strides.size(); ++i) {
      if (strides[i] > 0) {
        vertices = std::max(vertices, bytes_bound(gl_, static_cast<GLuint>(i)) / strides[i]);
      }
    }
  }
  feedback_vertices_[b.transform_feedback] = vertices;
}

std::optional<std::uint64_t> Pipeline::feedback_vertices(GLuint object) const {
  const auto found = feedback_vertices_.find(object);
  return found != feedback_vertices_.end() ? std::optional(found->second) : std::nullopt;
}

}  // namespace glark::core
