// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/feedback/feedback_room.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "glark/core/capture/layout.h"
#include "glark/core/objects/gpu_buffer.h"

namespace glark::core {
namespace {

// The least number of bytes that a vertex takes in each buffer.
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
  const GLuint program = capturing_program();
  std::uint64_t vertices = 0;
  if (program != 0) {
    const std::vector<std::uint64_t> strides = feedback_strides(env_.gl, program);
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
