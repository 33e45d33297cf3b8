// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/depth/measure/measure.h"

#include <numbers>

namespace glark::depth {
namespace {

constexpr char measure_source[] =
#include "glark/core/depth/measure/measure.glsl.inc"
    ;

// Uniforms of the pass that makes the limits.
constexpr const char* limit_names[] = {"pixels", "radians_of_turn", "budget", "restart", "most_change"};
enum LimitUniform : std::size_t { pixels, radians_of_turn, budget, restart_limits, most_change };

// Uniforms of the pass that measures; all but the last are integers.
constexpr const char* depth_names[] = {"record_offset",   "corner_words",      "normal_offset",
                                       "first_depth",     "triangle_bound",    "pool_level",
                                       "on_screen",       "packed_bits",       "depth_steps",
                                       "turn_offset",     "straight_position", "straight_position_words",
                                       "straight_normal", "straight_control",  "half_size"};
constexpr std::size_t half_size = 14;

constexpr int depths = static_cast<int>(core::max_supported_level) + 1;
constexpr GLsizeiptr limit_bytes = 4 * (1 + 2 * depths);
constexpr GLsizeiptr bytes_a_triangle = 3 * 16 + 4;
constexpr float most_change_while_morphing =
    1.0F / 16;  // of a level in a frame: at 60 frames a second, a quarter of a second

// Positions come first. The place of the depths depends only on the room, not on the number of triangles.
GLintptr first_depth(const core::GpuBuffer& ends) { return ends.size() / bytes_a_triangle * 3 * 16; }

}  // namespace

bool MeasureStage::compile() {
  const auto text = [this](std::uint64_t pass) {
    return core::ComputeText{.what = "a measuring pass",
                             .source = measure_source,
                             .es = language_ == capture::Language::es,
                             .defines = {{"GLARK_PASS", pass}, {"GLARK_DEPTHS", depths}}};
  };
  return limits_pass_.build(gl_, text(0), limit_names) && depth_pass_.build(gl_, text(1), depth_names);
}

// Tries to compile only once.
bool MeasureStage::prepare() {
  if (feedback_ != 0) {
    return limits_pass_.built() && depth_pass_.built() && limits_.name() != 0;
  }
  gl_.GenTransformFeedbacks(1, &feedback_);
  gl_.GenVertexArrays(1, &vertex_array_);
  return compile() && limits_.allocate(gl_, limit_bytes, nullptr, GL_DYNAMIC_COPY);
}

bool MeasureStage::has_room(std::uint32_t triangles) const {
  return limits_.name() != 0 && GLsizeiptr{triangles} * bytes_a_triangle <= ends_.size();
}

bool MeasureStage::reserve(std::uint32_t triangles) {
  return prepare() && ends_.reserve(gl_, GLsizeiptr{triangles} * bytes_a_triangle, GL_DYNAMIC_COPY);
}

// The limits change only between frames, so that every pass over the same geometry gets the same depths.
void MeasureStage::update_limits(const core::EdgeMeasure& rule, bool morphs, GLuint work) {
  const bool restart = rule != rule_;
  if (!restart && !(frame_finished_ && rule.budget > 0)) {
    return;
  }
  rule_ = rule;
  frame_finished_ = false;
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, limits_.name());
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, work);
  limits_pass_.use(gl_);
  gl_.Uniform1f(limits_pass_.location(pixels), rule.pixels);
  gl_.Uniform1f(limits_pass_.location(radians_of_turn), rule.degrees * std::numbers::pi_v<float> / 180.0F);
  gl_.Uniform1i(limits_pass_.location(budget), static_cast<GLint>(rule.budget));
  gl_.Uniform1i(limits_pass_.location(restart_limits), restart ? 1 : 0);
  gl_.Uniform1f(limits_pass_.location(most_change), morphs ? most_change_while_morphing : 0.0F);
  core::ComputePass::dispatch(gl_, 1);
  gl_.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void MeasureStage::capture_positions(const MeasureRequest& request, const core::Bindings& bindings) {
  const capture::Layout& layout = *request.layout;
  gl_.UseProgram(request.corner_program);
  gl_.BindVertexArray(vertex_array_);
  const int chunks = layout.corner_chunk_count();
  for (int chunk = enabled_chunks_; chunk < chunks; ++chunk) {
    const auto location = static_cast<GLuint>(chunk);
    gl_.EnableVertexAttribArray(location);
    gl_.VertexAttribFormat(location, 4, GL_FLOAT, GL_FALSE, static_cast<GLuint>(chunk * 16));
    gl_.VertexAttribBinding(location, 0);
  }
  for (int chunk = chunks; chunk < enabled_chunks_; ++chunk) {
    gl_.DisableVertexAttribArray(static_cast<GLuint>(chunk));
  }
  enabled_chunks_ = chunks;
  gl_.BindVertexBuffer(0, request.triangles.buffer, request.triangles.offset, layout.corner_words * 4);
  gl_.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, feedback_);
  gl_.BindBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, ends_.name(), 0, first_depth(ends_));
  gl_.BindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER,
                 bindings.feedback_buffer);  // only the generic binding point: the indexed one belongs to the object
  if (!bindings.rasterizer_discard) {
    gl_.Enable(GL_RASTERIZER_DISCARD);
  }
  gl_.BeginTransformFeedback(GL_TRIANGLES);
  gl_.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(3 * request.triangles.count));
  gl_.EndTransformFeedback();
  if (!bindings.rasterizer_discard) {
    gl_.Disable(GL_RASTERIZER_DISCARD);
  }
  gl_.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, bindings.transform_feedback);
}

EdgeEnds MeasureStage::find_ends(const MeasureRequest& request, const core::EdgeMeasure& rule, GLuint work,
                                 const core::Bindings& bindings) {
  if (request.corner_program != 0) {
    capture_positions(request, bindings);  // with the storage buffers of the application still bound
  }
  update_limits(rule, request.depth_steps > 1, work);
  return {ends_.name(), limits_.name()};
}

std::array<GLint, straight_edge_uniforms> straight_edge_words(const MeasureRequest& request) {
  const capture::Layout& layout = *request.layout;
  const capture::Field* const position = capture::find_role(layout.fields, capture::Role::position);
  if (!request.budget.curves_only || position == nullptr) {
    return {0, 0, -1, -1};
  }
  return {position->offset, position->words, capture::normal_offset(layout.fields), layout.control_offset};
}

MeasuredDepths MeasureStage::measure(const MeasureRequest& request, const core::Bindings& bindings) {
  const MeasuredDepths result{ends_.name(), first_depth(ends_), request.depth_steps == 1 ? 4 : 10};
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, request.triangles.buffer);
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, ends_.name());
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, limits_.name());
  depth_pass_.use(gl_);
  const auto straight = straight_edge_words(request);
  const GLint values[] = {static_cast<GLint>(request.triangles.offset / 4),
                          request.layout->corner_words,
                          request.normal_offset,
                          static_cast<GLint>(result.offset / 4),
                          static_cast<GLint>(request.triangles.count),
                          static_cast<GLint>(request.pool_level),
                          request.corner_program != 0 ? 1 : 0,
                          result.bits,
                          request.depth_steps,
                          request.layout->turn_offset,
                          straight[0],
                          straight[1],
                          straight[2],
                          straight[3]};
  depth_pass_.set_integers(gl_, values);
  gl_.Uniform2f(depth_pass_.location(half_size), 0.5F * bindings.viewport[0], 0.5F * bindings.viewport[1]);
  core::ComputePass::dispatch(gl_, request.triangles.count);
  gl_.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  return result;
}

void MeasureStage::release() {
  if (feedback_ != 0) {
    gl_.DeleteTransformFeedbacks(1, &feedback_);
    gl_.DeleteVertexArrays(1, &vertex_array_);
    feedback_ = 0;
  }
  limits_pass_.release(gl_);
  depth_pass_.release(gl_);
  enabled_chunks_ = 0;
  rule_ = core::EdgeMeasure{};
  limits_.release(gl_);
  ends_.release(gl_);
}

}  // namespace glark::depth
