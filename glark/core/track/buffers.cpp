// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Hooks of buffer objects: which buffers are bound, and which ones the GPU may write.
#include "glark/core/track/track.h"

namespace glark::core {
namespace {

// Returns whether GL has certainly accepted the name. Core contexts refuse names that GL did not give out.
bool surely_bound(const Context& c, GLuint buffer, std::uint64_t generation) {
  return buffer == 0 || c.capabilities().api != Capabilities::Api::core ||
         c.state().arrays().bound_buffers().confirmed(buffer, generation);
}

// The binding of a target that refined draws use themselves and give back; null for other targets.
GLuint* tracked_binding(Context& c, GLenum target) {
  Bindings& b = c.state().bindings();
  switch (target) {
    case GL_DRAW_INDIRECT_BUFFER: return &b.draw_indirect_buffer;
    case GL_PARAMETER_BUFFER: return &b.parameter_buffer;
    case GL_QUERY_BUFFER: return &b.query_buffer;
    case GL_SHADER_STORAGE_BUFFER: return &b.storage_buffer;
    case GL_TRANSFORM_FEEDBACK_BUFFER: return &b.transform_feedback.buffer;
    default: return nullptr;
  }
}

// After the call: returns whether GL has accepted the name. GL is asked once for each buffer.
bool has_accepted(Context& c, GLuint buffer) {
  const std::uint64_t generation = c.share().buffers.generation(buffer);
  if (surely_bound(c, buffer, generation)) {
    return true;
  }
  if (c.gl().IsBuffer(buffer) == GL_FALSE) {
    return false;
  }
  c.state().arrays().bound_buffers().confirm(buffer, generation);
  return true;
}

bool is_index_of(const Context& c, GLenum target, GLuint index) {
  switch (target) {
    case GL_SHADER_STORAGE_BUFFER: return index < c.capabilities().storage_bindings;
    case GL_TRANSFORM_FEEDBACK_BUFFER:
      return index < c.capabilities().feedback_buffers && !c.state().bindings().transform_feedback.active;
    default: return false;
  }
}

// Notes the buffer that writes to `target` change. If this is uncertain, the first write asks GL.
void follow_binding(Context& c, GLenum target, GLuint buffer) {
  const std::uint64_t generation = c.share().buffers.generation(buffer);
  const BoundBuffer bound{surely_bound(c, buffer, generation), buffer, generation};
  if (target == GL_ELEMENT_ARRAY_BUFFER) {
    c.state().arrays().vertex_arrays().change(c.state().bindings().vertex_array).elements = bound;
  } else if (BoundBuffer* kept = c.state().arrays().bound_buffers().at(target); kept != nullptr) {
    *kept = bound;
  }
}

// Notes an indexed binding. Except for uniform buffers, such bindings let the GPU write.
void follow_indexed(Context& c, GLenum target, GLuint buffer) {
  if (BoundBuffer* kept = c.state().arrays().bound_buffers().at(target); kept != nullptr) {
    *kept = {false, buffer, c.share().buffers.generation(buffer)};
  }
  if (target != GL_UNIFORM_BUFFER) {
    c.writes().gpu_may_write(buffer);
  }
}

void follow_several(Context& c, GLenum target, GLsizei count, const GLuint* buffers) {
  for (GLsizei i = 0; i < count && buffers != nullptr && target != GL_UNIFORM_BUFFER; ++i) {
    c.writes().gpu_may_write(buffers[i]);
  }
}

// GL may have refused the index or the alignment.
void forget_range(Context& c, GLenum target, GLuint buffer) {
  follow_indexed(c, target, buffer);
  if (tracked_binding(c, target) != nullptr) {
    c.state().forget_bindings();
  }
}

}  // namespace

namespace hook {

// Programs bind buffers before every draw. So the most frequent target comes first.
void BindBuffer(Context& c, GLenum target, GLuint buffer) {
  if (target == GL_ARRAY_BUFFER) {
    const std::uint64_t generation = c.share().buffers.generation(buffer);
    c.state().arrays().bound_buffers().array() = {surely_bound(c, buffer, generation), buffer, generation};
    c.gl().BindBuffer(target, buffer);
    return;
  }
  c.gl().BindBuffer(target, buffer);
  if (GLuint* const tracked = tracked_binding(c, target); tracked != nullptr && has_accepted(c, buffer)) {
    *tracked = buffer;
  }
  follow_binding(c, target, buffer);
  if (target == GL_EXTERNAL_VIRTUAL_MEMORY_BUFFER_AMD) {
    c.writes().never_trust_buffer(buffer);  // its contents are the application's memory
  }
}

void BindBufferBase(Context& c, GLenum target, GLuint index, GLuint buffer) {
  c.gl().BindBufferBase(target, index, buffer);
  if (is_index_of(c, target, index) && has_accepted(c, buffer)) {
    *tracked_binding(c, target) = buffer;
    if (target == GL_SHADER_STORAGE_BUFFER && index < tracked_storage_bindings) {
      c.state().bindings().storage[index] = {buffer, 0, 0};
    }
  }
  follow_indexed(c, target, buffer);
}

void BindBufferRange(Context& c, GLenum target, GLuint index, GLuint buffer, GLintptr offset, GLsizeiptr size) {
  c.gl().BindBufferRange(target, index, buffer, offset, size);
  forget_range(c, target, buffer);
}

void BindBufferOffsetEXT(Context& c, GLenum target, GLuint index, GLuint buffer, GLintptr offset) {
  c.gl().BindBufferOffsetEXT(target, index, buffer, offset);
  forget_range(c, target, buffer);
}

void BindBuffersBase(Context& c, GLenum target, GLuint first, GLsizei count, const GLuint* buffers) {
  c.gl().BindBuffersBase(target, first, count, buffers);
  follow_several(c, target, count, buffers);
  if (target == GL_SHADER_STORAGE_BUFFER) {
    c.state().forget_bindings();
  }
}

void BindBuffersRange(Context& c, GLenum target, GLuint first, GLsizei count, const GLuint* buffers,
                      const GLintptr* offsets, const GLsizeiptr* sizes) {
  c.gl().BindBuffersRange(target, first, count, buffers, offsets, sizes);
  follow_several(c, target, count, buffers);
  if (target == GL_SHADER_STORAGE_BUFFER) {
    c.state().forget_bindings();
  }
}

void DeleteBuffers(Context& c, GLsizei n, const GLuint* buffers) {
  c.gl().DeleteBuffers(n, buffers);
  c.state().forget_bindings();                          // deleting unbinds
  c.state().arrays().vertex_arrays().forget_current();  // other vertex arrays keep the object
  c.state().arrays().vertex_arrays().forget_elements();
  for (GLsizei i = 0; i < n && buffers != nullptr; ++i) {
    c.writes().deleted(buffers[i]);
    c.state().arrays().bound_buffers().unbind(buffers[i]);
  }
}

}  // namespace hook
}  // namespace glark::core
