// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/state/bindings.h"

#include "glark/core/objects/get_integer.h"

namespace glark::core {
namespace {

GLuint get_name(const gl::Dispatch& gl, GLenum binding) { return static_cast<GLuint>(get_integer(gl, binding)); }

void read_objects(const gl::Dispatch& gl, Bindings& b) {
  b.program = get_name(gl, GL_CURRENT_PROGRAM);
  b.pipeline = get_name(gl, GL_PROGRAM_PIPELINE_BINDING);
  b.vertex_array = get_name(gl, GL_VERTEX_ARRAY_BINDING);
  b.transform_feedback.object = get_name(gl, GL_TRANSFORM_FEEDBACK_BINDING);
  b.transform_feedback.active = get_integer(gl, GL_TRANSFORM_FEEDBACK_ACTIVE) != 0;
  if (!b.transform_feedback.ours) {  // ours is paused between our draws
    b.transform_feedback.paused = get_integer(gl, GL_TRANSFORM_FEEDBACK_PAUSED) != 0;
  }
}

void read_buffers(const gl::Dispatch& gl, const Capabilities& capabilities, Bindings& b) {
  b.draw_indirect_buffer = get_name(gl, GL_DRAW_INDIRECT_BUFFER_BINDING);
  b.query_buffer = capabilities.query_buffer ? get_name(gl, GL_QUERY_BUFFER_BINDING) : 0;
  b.parameter_buffer = capabilities.parameter_buffer ? get_name(gl, GL_PARAMETER_BUFFER_BINDING) : 0;
  b.transform_feedback.buffer = get_name(gl, GL_TRANSFORM_FEEDBACK_BUFFER_BINDING);
  b.storage_buffer = get_name(gl, GL_SHADER_STORAGE_BUFFER_BINDING);
  for (GLuint i = 0; i < b.storage.size(); ++i) {
    GLint buffer = 0;
    GLint64 offset = 0;
    GLint64 size = 0;
    gl.GetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, i, &buffer);
    gl.GetInteger64i_v(GL_SHADER_STORAGE_BUFFER_START, i, &offset);
    gl.GetInteger64i_v(GL_SHADER_STORAGE_BUFFER_SIZE, i, &size);
    b.storage[i] = {static_cast<GLuint>(buffer), static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(size)};
  }
}

void read_modes(const gl::Dispatch& gl, const Capabilities& capabilities, Bindings& b) {
  b.debug_output = gl.IsEnabled(GL_DEBUG_OUTPUT) != GL_FALSE;
  b.blend = gl.IsEnabled(GL_BLEND) != GL_FALSE;
  b.depth_test = gl.IsEnabled(GL_DEPTH_TEST) != GL_FALSE;
  b.depth_writes = get_integer(gl, GL_DEPTH_WRITEMASK) != 0;
  b.depth_function = static_cast<GLenum>(get_integer(gl, GL_DEPTH_FUNC));
  b.stencil_test = gl.IsEnabled(GL_STENCIL_TEST) != GL_FALSE;
  b.polygon_offset = gl.IsEnabled(GL_POLYGON_OFFSET_FILL) != GL_FALSE;
  GLboolean channels[4] = {GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE};
  gl.GetBooleanv(GL_COLOR_WRITEMASK, channels);
  b.color_writes =
      channels[0] != GL_FALSE || channels[1] != GL_FALSE || channels[2] != GL_FALSE || channels[3] != GL_FALSE;
  b.culling.enabled = gl.IsEnabled(GL_CULL_FACE) != GL_FALSE;
  b.culling.face = static_cast<GLenum>(get_integer(gl, GL_CULL_FACE_MODE));
  b.culling.front_face = static_cast<GLenum>(get_integer(gl, GL_FRONT_FACE));
  GLfloat viewport[4] = {0, 0, 0, 0};
  gl.GetFloatv(GL_VIEWPORT, viewport);
  b.viewport = {viewport[2], viewport[3]};
  b.rasterizer_discard = gl.IsEnabled(GL_RASTERIZER_DISCARD) != GL_FALSE;
  b.primitive_restart_fixed = gl.IsEnabled(GL_PRIMITIVE_RESTART_FIXED_INDEX) != GL_FALSE;
  if (capabilities.api != Capabilities::Api::es) {
    b.primitive_restart = gl.IsEnabled(GL_PRIMITIVE_RESTART) != GL_FALSE;
    b.clip_distances = 0;
    for (GLenum i = 0; i < clip_distance_count; ++i) {
      b.clip_distances |= static_cast<std::uint8_t>((gl.IsEnabled(GL_CLIP_DISTANCE0 + i) != GL_FALSE ? 1U : 0U) << i);
    }
    GLint modes[2] = {GL_FILL, GL_FILL};
    gl.GetIntegerv(GL_POLYGON_MODE, modes);
    b.polygon_modes.front = static_cast<GLenum>(modes[0]);
    b.polygon_modes.back = capabilities.is_compatibility() ? static_cast<GLenum>(modes[1]) : b.polygon_modes.front;
    b.provoking_vertex = static_cast<GLenum>(get_integer(gl, GL_PROVOKING_VERTEX));
  }
}

// Returns whether the first draw buffer has floating-point colours.
bool draws_floats(const gl::Dispatch& gl) {
  const auto buffer = static_cast<GLenum>(get_integer(gl, GL_DRAW_BUFFER));
  if (get_integer(gl, GL_DRAW_FRAMEBUFFER_BINDING) == 0 || buffer == GL_NONE) {
    return false;
  }
  const auto attachment = [&](GLenum name) {
    GLint value = GL_NONE;
    gl.GetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, buffer, name, &value);
    return value;
  };
  return attachment(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_NONE &&
         attachment(GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_FLOAT;
}

void read_compatibility_modes(const gl::Dispatch& gl, Bindings& b) {
  b.vertex_program = gl.IsEnabled(GL_VERTEX_PROGRAM_ARB) != GL_FALSE;
  b.two_side = gl.IsEnabled(GL_VERTEX_PROGRAM_TWO_SIDE) != GL_FALSE;
  b.matrix_mode = static_cast<GLenum>(get_integer(gl, GL_MATRIX_MODE));
  b.shade_model = static_cast<GLenum>(get_integer(gl, GL_SHADE_MODEL));
  const GLint clamp = get_integer(gl, GL_CLAMP_VERTEX_COLOR);
  b.clamps_by_framebuffer = clamp == GL_FIXED_ONLY;
  b.clamp_vertex_color = clamp != GL_FALSE && !(b.clamps_by_framebuffer && draws_floats(gl));
  b.render_mode = static_cast<GLenum>(get_integer(gl, GL_RENDER_MODE));
  b.list_base = get_name(gl, GL_LIST_BASE);
}

}  // namespace

void read_bindings(const gl::Dispatch& gl, const Capabilities& capabilities, Bindings& bindings) {
  read_objects(gl, bindings);
  read_buffers(gl, capabilities, bindings);
  read_modes(gl, capabilities, bindings);
  if (capabilities.is_compatibility()) {
    read_compatibility_modes(gl, bindings);
  }
}

}  // namespace glark::core
