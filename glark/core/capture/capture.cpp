// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The thesis (Boubekeur 2007, ch. 7.2.3) sends the attributes of each coarse triangle as uniforms. Here transform
// feedback captures them: GL itself then handles every draw call, mode and index type.
#include "glark/core/capture/capture.h"

#include <algorithm>
#include <cstddef>

#include "glark/core/objects/programs/shader.h"

namespace glark::capture {
namespace {

constexpr std::int64_t initial_ring_bytes = std::int64_t{4} << 20;
constexpr std::int64_t largest_capture_bytes = std::int64_t{1} << 30;

constexpr std::array<GLenum, 2> query_targets = {GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, GL_PRIMITIVES_GENERATED};

std::int64_t bytes_of(const Layout& layout, std::uint64_t triangles) {
  return static_cast<std::int64_t>(triangles) * layout.triangle_words() * 4;
}

// A capture of glBegin needs nearly the same in every layout: one allocation does for all.
std::int64_t in_whole_steps(std::int64_t bytes) {
  constexpr std::int64_t step = std::int64_t{1} << 20;
  return (bytes + step - 1) / step * step;
}

}  // namespace

std::uint64_t query_result(const gl::Dispatch& gl, GLuint query, const core::Bindings& bindings) {
  GLuint result = 0;
  if (bindings.query_buffer != 0) {
    gl.BindBuffer(GL_QUERY_BUFFER, 0);
  }
  gl.GetQueryObjectuiv(query, GL_QUERY_RESULT, &result);
  if (bindings.query_buffer != 0) {
    gl.BindBuffer(GL_QUERY_BUFFER, bindings.query_buffer);
  }
  return result;
}

GLuint CaptureStage::program_for(const Layout& layout, GLuint tag_attribute) {
  CaptureSources sources = capture_sources(layout, language_, tag_attribute);
  const auto found = programs_.find(sources.vertex);
  if (found != programs_.end()) {
    return found->second;
  }
  const GLuint program = build(sources);
  programs_.emplace(std::move(sources.vertex), program);
  return program;
}

GLuint CaptureStage::build(const CaptureSources& sources) const {
  const std::vector<core::ShaderText> texts{
      {GL_VERTEX_SHADER, sources.vertex}, {GL_FRAGMENT_SHADER, core::idle_fragment_shader(language_ == Language::es)}};
  return core::build_program(gl_, "the capture program", texts, sources.varyings);
}

bool CaptureStage::can_reserve(const Layout& layout, std::uint64_t triangles) const {
  return triangles <= static_cast<std::uint64_t>(largest_capture_bytes) /
                          static_cast<std::uint64_t>(std::max(1, layout.triangle_words() * 4));
}

GLuint CaptureStage::feedback() {
  if (feedback_ == 0) {
    gl_.GenTransformFeedbacks(1, &feedback_);
  }
  return feedback_;
}

bool CaptureStage::has_room(const Layout& layout, std::uint64_t triangles) const {
  return queries_[0] != 0 && cursor_ + bytes_of(layout, triangles) + chunk_overrun <= ring_.size();
}

bool CaptureStage::reserve(const Layout& layout, std::uint64_t triangles) {
  feedback();
  if (queries_[0] == 0) {
    gl_.GenQueries(2, queries_.data());
    const CountCommand command;
    if (!count_command_.allocate(gl_, sizeof(command), &command, GL_DYNAMIC_COPY)) {
      return false;
    }
  }
  const std::int64_t needed = bytes_of(layout, triangles) + chunk_overrun;
  if (cursor_ + needed <= ring_.size()) {
    return true;
  }
  cursor_ = 0;
  if (needed <= ring_.size()) {
    return true;
  }
  return ring_.reserve(gl_, std::max(in_whole_steps(needed), initial_ring_bytes), GL_DYNAMIC_COPY);
}

void CaptureStage::bind_target(GLuint buffer, GLintptr offset, std::int64_t size,
                               const core::Bindings& bindings) const {
  gl_.BindBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer, offset, static_cast<GLsizeiptr>(size));
  // Restores the generic binding point only: the indexed one belongs to the transform feedback object.
  gl_.BindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, bindings.transform_feedback.buffer);
}

void CaptureStage::begin(GLuint program, const core::Bindings& bindings, Count count, const core::GpuBuffer* own_buffer,
                         GLenum primitive) {
  gl_.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, feedback_);
  if (own_buffer != nullptr) {
    current_.buffer = own_buffer->name();
    current_.offset = 0;
    bind_target(current_.buffer, 0, own_buffer->size(), bindings);
  } else {
    current_.buffer = ring_.name();
    current_.offset = cursor_;
    bind_target(current_.buffer, cursor_, ring_.size() - cursor_, bindings);
  }
  current_.count = count;
  gl_.UseProgram(program);
  if (!bindings.rasterizer_discard) {
    gl_.Enable(GL_RASTERIZER_DISCARD);
  }
  if (current_.count != Count::known) {
    current_.query = bindings.queries.written() == 0 ? 0 : 1;
    gl_.BeginQuery(query_targets[current_.query], queries_[current_.query]);
  }
  gl_.BeginTransformFeedback(primitive);
}

void CaptureStage::set_feedback_mode(GLuint program, GLenum mode, const core::Bindings& bindings) const {
  gl_.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, feedback_);
  bind_target(ring_.name(), 0, ring_.size(), bindings);
  gl_.UseProgram(program);
  gl_.BeginTransformFeedback(mode);
  gl_.EndTransformFeedback();
  gl_.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, bindings.transform_feedback.object);
}

CoarseTriangles CaptureStage::end(const Layout& layout, std::uint64_t triangles, const core::Bindings& bindings) {
  gl_.EndTransformFeedback();
  CoarseTriangles result{current_.buffer, current_.offset, static_cast<std::uint32_t>(triangles), false};
  if (current_.count != Count::known) {
    gl_.EndQuery(query_targets[current_.query]);
    if (query_buffer_ && current_.count == Count::by_query) {
      gl_.BindBuffer(GL_QUERY_BUFFER, count_command_.name());
      gl_.GetQueryObjectuiv(queries_[current_.query], GL_QUERY_RESULT,
                            reinterpret_cast<GLuint*>(offsetof(CountCommand, instance_count)));
      gl_.BindBuffer(GL_QUERY_BUFFER, bindings.query_buffer);
      result.count_on_gpu = true;
    } else {
      result.count = std::min(result.count, static_cast<std::uint32_t>(counted(bindings)));
    }
  }
  if (!bindings.rasterizer_discard) {
    gl_.Disable(GL_RASTERIZER_DISCARD);
  }
  gl_.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, bindings.transform_feedback.object);
  if (current_.buffer == ring_.name()) {
    cursor_ += static_cast<GLintptr>(bytes_of(layout, triangles));
  }
  return result;
}

std::uint64_t CaptureStage::counted(const core::Bindings& bindings) const {
  return query_result(gl_, queries_[current_.query], bindings);
}

void CaptureStage::release() {
  for (const auto& [text, program] : programs_) {
    gl_.DeleteProgram(program);
  }
  programs_.clear();
  if (feedback_ != 0) {
    gl_.DeleteTransformFeedbacks(1, &feedback_);
    gl_.DeleteQueries(2, queries_.data());
    feedback_ = 0;
    queries_ = {};
  }
  ring_.release(gl_);
  count_command_.release(gl_);
}

}  // namespace glark::capture
