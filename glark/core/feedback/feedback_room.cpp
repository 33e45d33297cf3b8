// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/feedback/feedback_room.h"

#include <algorithm>
#include <array>
#include <memory>
#include <mutex>
#include <vector>

#include "glark/core/capture/layout.h"
#include "glark/core/objects/gpu_buffer.h"

namespace glark::core {
namespace {

constexpr GLint most_buffers = 64;  // far more than any implementation has

// Since OpenGL 4.4, the vertex stage itself may say in which buffer an output lies.
std::vector<std::uint64_t> strides_of_buffers(const gl::Dispatch& gl, GLuint program) {
  GLint count = 0;
  gl.GetProgramInterfaceiv(program, GL_TRANSFORM_FEEDBACK_BUFFER, GL_ACTIVE_RESOURCES, &count);
  std::vector<std::uint64_t> strides;
  for (GLint i = 0; i < count; ++i) {
    constexpr std::array<GLenum, 2> properties{GL_BUFFER_BINDING, GL_TRANSFORM_FEEDBACK_BUFFER_STRIDE};
    std::array<GLint, 2> found{};  // the binding, and bytes
    gl.GetProgramResourceiv(program, GL_TRANSFORM_FEEDBACK_BUFFER, static_cast<GLuint>(i), 2, properties.data(), 2,
                            nullptr, found.data());
    const auto binding = static_cast<std::size_t>(std::clamp(found[0], 0, most_buffers - 1));
    strides.resize(std::max(strides.size(), binding + 1));
    strides[binding] = static_cast<std::uint64_t>(std::max(found[1], 0));
  }
  return strides;
}

// The least number of bytes that a vertex takes in each buffer.
std::vector<std::uint64_t> feedback_strides(const gl::Dispatch& gl, const Capabilities& capabilities,
                                            const Program& program) {
  if (capabilities.api != Capabilities::Api::es && capabilities.version >= 44) {
    if (std::vector<std::uint64_t> found = strides_of_buffers(gl, program.name); !found.empty()) {
      return found;
    }
  }
  const LinkSettings& settings = program.link_settings;
  std::vector<std::uint64_t> strides(1, 0);
  bool first = true;
  for (const FeedbackVarying& varying : settings.feedback_varyings) {
    const bool next = varying.name == "gl_NextBuffer";
    if (next || (settings.feedback_mode == GL_SEPARATE_ATTRIBS && !first)) {
      strides.push_back(0);
    }
    const int words = capture::words_of(varying.type) * varying.size;
    strides.back() += next ? 0 : 4 * static_cast<std::uint64_t>(std::max(1, words));
    first = false;
  }
  return strides;
}

// Bytes of the buffer range at an indexed binding of transform feedback.
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

}  // namespace

// The program of the last stage before the fragments; 0 without such a stage.
GLuint FeedbackRoom::capturing_program() const {
  const Bindings& b = env_.bindings();
  GLuint program = b.program;
  if (program == 0 && b.pipeline != 0) {
    const auto& programs = env_.state.programs().pipelines().object(b.pipeline).programs;
    for (const std::size_t last_stage : {3U, 2U, 0U}) {  // geometry, tessellation, vertices
      program = program != 0 ? program : programs[last_stage];
    }
  }
  return program;
}

// Streams of a geometry shader go to separate buffers: the buffer with the most room bounds them all.
void FeedbackRoom::note() {
  const Quiet quiet = env_.state.quiet();
  ErrorScope errors(env_.errors);
  const GLuint name = capturing_program();
  const std::shared_ptr<Program> program = name != 0 ? env_.state.programs().known(name) : nullptr;
  std::uint64_t vertices = 0;
  if (program != nullptr) {
    const std::lock_guard lock(program->mutex);
    const std::vector<std::uint64_t> strides = feedback_strides(env_.gl, env_.capabilities, *program);
    for (std::size_t i = 0; i < strides.size(); ++i) {
      if (strides[i] > 0) {
        vertices = std::max(vertices, bytes_bound(env_.gl, static_cast<GLuint>(i)) / strides[i]);
      }
    }
  }
  vertices_[env_.bindings().transform_feedback.object] = vertices;
}

std::optional<std::uint64_t> FeedbackRoom::vertices(GLuint object) const {
  const auto found = vertices_.find(object);
  return found != vertices_.end() ? std::optional(found->second) : std::nullopt;
}

}  // namespace glark::core
