// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/depth/measure.h"

#include <algorithm>
#include <numbers>

#include "glark/core/report.h"

namespace glark::depth {
namespace {

constexpr char measure_source[] =
#include "glark/core/depth/measure.glsl.inc"
    ;

constexpr const char* uniform_names[] = {"record_offset",  "corner_words", "normal_offset", "first_depth",
                                         "triangle_bound", "pool_level",   "on_screen",     "packed_bits",
                                         "depth_steps",    "turn_offset"};
constexpr int depths = static_cast<int>(core::max_supported_level) + 1;
constexpr GLsizeiptr limit_bytes = 4 * (1 + 2 * depths);
constexpr GLsizeiptr bytes_a_triangle = 3 * 16 + 4;
constexpr float most_change_while_morphing =
    1.0F / 16;  // of a level in a frame: at 60 frames a second, a quarter of a second
constexpr GLuint group_size = 64;
constexpr GLuint most_groups = 65535;  // in one dimension, guaranteed; more go to the second

// Positions come first, whatever the number of triangles: where the depths begin depends on the room alone.
GLintptr first_depth(const core::GpuBuffer& ends) { return ends.size() / bytes_a_triangle * 3 * 16; }

}  // namespace

GLuint MeasureStage::compile(int pass) const {
  const std::string version = language_ == capture::Language::es
                                  ? "#version 320 es\nprecision highp float;\nprecision highp int;\n"
                                  : "#version 430\n";
  const std::string source = version + "#define GLARK_PASS " + std::to_string(pass) + "\n#define GLARK_DEPTHS " +
                             std::to_string(depths) + "\n" + measure_source;
  const char* text = source.c_str();
  const GLuint shader = gl_.CreateShader(GL_COMPUTE_SHADER);
  gl_.ShaderSource(shader, 1, &text, nullptr);
  gl_.CompileShader(shader);
  const GLuint program = gl_.CreateProgram();
  gl_.AttachShader(program, shader);
  gl_.LinkProgram(program);
  GLint linked = GL_FALSE;
  gl_.GetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked != GL_FALSE) {
    gl_.DeleteShader(shader);
    return program;
  }
  std::array<char, 2048> log{};
  gl_.GetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
  core::log(core::LogLevel::error, std::string("measuring pass does not compile: ") + log.data());
  gl_.DeleteShader(shader);
  gl_.DeleteProgram(program);
  return 0;
}

bool MeasureStage::prepare() {
  if (feedback_ != 0) {
    return limits_pass_.program != 0 && depth_pass_.program != 0 && limits_.name() != 0;
  }
  gl_.GenTransformFeedbacks(1, &feedback_);
  gl_.GenVertexArrays(1, &vertex_array_);
  const GLuint limits = compile(0);
  limits_pass_ = {limits,
                  gl_.GetUniformLocation(limits, "pixels"),
                  gl_.GetUniformLocation(limits, "radians_of_turn"),
                  gl_.GetUniformLocation(limits, "budget"),
                  gl_.GetUniformLocation(limits, "restart"),
                  gl_.GetUniformLocation(limits, "most_change")};
  depth_pass_.program = compile(1);
  for (std::size_t i = 0; i < depth_pass_.uniform.size(); ++i) {
    depth_pass_.uniform[i] = gl_.GetUniformLocation(depth_pass_.program, uniform_names[i]);
  }
  depth_pass_.half_size = gl_.GetUniformLocation(depth_pass_.program, "half_size");
  return limits_.allocate(gl_, limit_bytes, nullptr, GL_DYNAMIC_COPY) && prepare();
}

bool MeasureStage::has_room(std::uint32_t triangles) const {
  return limits_.name() != 0 && GLsizeiptr{triangles} * bytes_a_triangle <= ends_.size();
}

bool MeasureStage::reserve(std::uint32_t triangles) {
  return prepare() && ends_.reserve(gl_, GLsizeiptr{triangles} * bytes_a_triangle, GL_DYNAMIC_COPY);
}

// Only between frames, so that every pass over the same geometry has the same depths.
void MeasureStage::update_limits(const core::EdgeMeasure& rule, bool morphs, GLuint work) {
  const bool restart = rule != rule_;
  if (!restart && !(frame_finished_ && rule.budget > 0)) {
    return;
  }
  rule_ = rule;
  frame_finished_ = false;
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, limits_.name());
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, work);
  gl_.UseProgram(limits_pass_.program);
  gl_.Uniform1f(limits_pass_.pixels, rule.pixels);
  gl_.Uniform1f(limits_pass_.radians, rule.degrees * std::numbers::pi_v<float> / 180.0F);
  gl_.Uniform1i(limits_pass_.budget, static_cast<GLint>(rule.budget));
  gl_.Uniform1i(limits_pass_.restart, restart ? 1 : 0);
  gl_.Uniform1f(limits_pass_.most_change, morphs ? most_change_while_morphing : 0.0F);
  gl_.DispatchCompute(1, 1, 1);
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
                 bindings.feedback_buffer);  // only the generic point: the object keeps its own
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

MeasuredDepths MeasureStage::measure(const MeasureRequest& request, const core::Bindings& bindings) {
  const MeasuredDepths result{ends_.name(), first_depth(ends_), request.depth_steps == 1 ? 4 : 10};
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, request.triangles.buffer);
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, ends_.name());
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, limits_.name());
  gl_.UseProgram(depth_pass_.program);
  const GLint values[] = {static_cast<GLint>(request.triangles.offset / 4),
                          request.layout->corner_words,
                          request.normal_offset,
                          static_cast<GLint>(result.offset / 4),
                          static_cast<GLint>(request.triangles.count),
                          static_cast<GLint>(request.pool_level),
                          request.corner_program != 0 ? 1 : 0,
                          result.bits,
                          request.depth_steps,
                          request.layout->turn_offset};
  for (std::size_t i = 0; i < depth_pass_.uniform.size(); ++i) {
    gl_.Uniform1i(depth_pass_.uniform[i], values[i]);
  }
  gl_.Uniform2f(depth_pass_.half_size, 0.5F * bindings.viewport[0], 0.5F * bindings.viewport[1]);
  const GLuint groups = (request.triangles.count + group_size - 1) / group_size;
  gl_.DispatchCompute(std::min(groups, most_groups), (groups + most_groups - 1) / most_groups, 1);
  gl_.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  return result;
}

void MeasureStage::release() {
  if (feedback_ != 0) {
    gl_.DeleteTransformFeedbacks(1, &feedback_);
    gl_.DeleteVertexArrays(1, &vertex_array_);
    gl_.DeleteProgram(limits_pass_.program);
    gl_.DeleteProgram(depth_pass_.program);
    feedback_ = 0;
  }
  limits_pass_ = LimitsPass{};
  depth_pass_ = DepthPass{};
  enabled_chunks_ = 0;
  rule_ = core::EdgeMeasure{};
  limits_.release(gl_);
  ends_.release(gl_);
}

}  // namespace glark::depth
