// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/support/capture.h"

#include <fmt/core.h>
#include <string>

namespace glark::conformance {

GLuint capture_program(Test& t) {
  return build_program(
      t, {.vertex =
              "layout(location = 0) in vec4 position; layout(location = 2) in vec3 weights;\n"
              "layout(location = 6) in float triangle; out vec3 weights_out; out float triangle_out; out vec4 colour;\n"
              "void main() { weights_out = weights; triangle_out = triangle; colour = vec4(weights, 1.0);\n"
              "  gl_Position = position; }\n",
          .captured = {"gl_Position", "weights_out", "triangle_out"}});
}

std::vector<unsigned char> capture_bytes(Test& t, std::size_t stride, std::size_t per_primitive, std::size_t most,
                                         GLenum mode, const std::function<void()>& draw) {
  GLuint buffer = 0;
  GLuint query = 0;
  gl.GenBuffers(1, &buffer);
  gl.GenQueries(1, &query);
  gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
  gl.BufferData(GL_TRANSFORM_FEEDBACK_BUFFER, static_cast<GLsizeiptr>(most * per_primitive * stride), nullptr,
                GL_STREAM_READ);
  gl.Enable(GL_RASTERIZER_DISCARD);
  gl.BeginQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, query);
  gl.BeginTransformFeedback(mode);
  draw();
  gl.EndTransformFeedback();
  gl.EndQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);
  gl.Disable(GL_RASTERIZER_DISCARD);
  GLuint written = 0;
  gl.GetQueryObjectuiv(query, GL_QUERY_RESULT, &written);
  t.expect_no_error("drawing to transform feedback");
  t.require(written < most, fmt::format("at most {} primitives are captured", most));
  const std::size_t size = written * per_primitive * stride;
  std::vector<unsigned char> bytes(size);
  if (size > 0) {
    const void* const mapped =
        gl.MapBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, static_cast<GLsizeiptr>(size), GL_MAP_READ_BIT);
    t.require(mapped != nullptr, "the captured buffer can be mapped");
    std::memcpy(bytes.data(), mapped, size);
    gl.UnmapBuffer(GL_TRANSFORM_FEEDBACK_BUFFER);
  }
  gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
  gl.DeleteBuffers(1, &buffer);
  gl.DeleteQueries(1, &query);
  return bytes;
}

void refine_uniformly(GLuint level, GLenum refinement) {
  gl.ARKinit(level);
  gl.ARKParameteriARK(GL_REFINEMENT_ARK, static_cast<GLint>(refinement));
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, static_cast<GLint>(level));
  gl.Enable(GL_ARK);
}

void refine_by_tags(GLuint pool_level, GLenum refinement) {
  gl.ARKinit(pool_level);
  gl.ARKParameteriARK(GL_REFINEMENT_ARK, static_cast<GLint>(refinement));
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_DEPTH_TAG_ARK);
  gl.Enable(GL_ARK);
}

void clear_surface() {
  // After Viewport, an implementation may read its state from GL again. That would hide a change that it has missed. So
  // Viewport is called only if the viewport differs.
  GLint viewport[4] = {};
  gl.GetIntegerv(GL_VIEWPORT, viewport);
  if (viewport[0] != 0 || viewport[1] != 0 || viewport[2] != surface_size || viewport[3] != surface_size)
    gl.Viewport(0, 0, surface_size, surface_size);
  gl.ClearColor(0, 0, 0, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

Picture picture_of(const std::function<void()>& draw) {
  clear_surface();
  draw();
  return read_picture(surface_size, surface_size);
}

}  // namespace glark::conformance
