// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Hooks of buffer objects: which buffers are bound, and which ones the GPU may write.
#include "glark/core/objects/get_integer.h"
#include "glark/core/track/track.h"

namespace glark::core {
namespace {

// Returns whether GL has certainly accepted the name. Core contexts refuse names that GL did not give out.
bool surely_bound(const Context& c, GLuint buffer, std::uint64_t generation) {
  return !c.state().immediate().open() && (buffer == 0 || c.capabilities().api != Capabilities::Api::core ||
                                           c.state().arrays().bound_buffers().confirmed(buffer, generation));
}

// After the call: returns whether GL has accepted the name.
bool has_accepted(Context& c, GLuint buffer) {
  return surely_bound(c, buffer, c.share().buffers.generation(buffer)) || c.gl().IsBuffer(buffer) != GL_FALSE;
}

// After the call: returns whether GL has accepted the index of a binding that is tracked.
bool has_accepted_index(Context& c, GLenum target, GLuint index) {
  switch (target) {
    case GL_SHADER_STORAGE_BUFFER:
      return index < tracked_storage_bindings ||
             index < static_cast<GLuint>(get_integer(c.gl(), GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS));
    case GL_TRANSFORM_FEEDBACK_BUFFER: {
      const bool es = c.capabilities().api == Capabilities::Api::es;
      const GLenum limit = es ? GL_MAX_TRANSFORM_FEEDBACK_SEPARATE_ATTRIBS : GL_MAX_TRANSFORM_FEEDBACK_BUFFERS;
      return !c.state().bindings().transform_feedback.active && index < static_cast<GLuint>(get_integer(c.gl(), limit));
    }
    default: return true;
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

void set_binding(Context& c, GLenum target, GLuint buffer) {
  switch (target) {
    case GL_DRAW_INDIRECT_BUFFER: c.state().bindings().draw_indirect_buffer = buffer; break;
    case GL_PARAMETER_BUFFER: c.state().bindings().parameter_buffer = buffer; break;
    case GL_QUERY_BUFFER: c.state().bindings().query_buffer = buffer; break;
    case GL_SHADER_STORAGE_BUFFER: c.state().bindings().storage_buffer = buffer; break;
    case GL_TRANSFORM_FEEDBACK_BUFFER: c.state().bindings().transform_feedback.buffer = buffer; break;
    default: break;
  }
}

// GL may have refused the index or the alignment.
void forget_range(Context& c, GLenum target, GLuint buffer) {
  follow_indexed(c, target, buffer);
  if (target == GL_SHADER_STORAGE_BUFFER || target == GL_TRANSFORM_FEEDBACK_BUFFER) {
    c.state().forget_bindings();
  }
}

void set_indexed(Context& c, GLenum target, GLuint index, const IndexedBuffer& binding) {
  if (target == GL_SHADER_STORAGE_BUFFER && index < c.state().bindings().storage.size()) {
    c.state().bindings().storage[index] = binding;
  }
}

}  // namespace

namespace hook {

// Programs bind buffers before every draw. So the most frequent target comes first, and the real call last, by a jump.
void BindBuffer(Context& c, GLenum target, GLuint buffer) {
  if (target == GL_ARRAY_BUFFER) {
    const std::uint64_t generation = c.share().buffers.generation(buffer);
    c.state().arrays().bound_buffers().array() = {surely_bound(c, buffer, generation), buffer, generation};
    c.gl().BindBuffer(target, buffer);
    return;
  }
  c.gl().BindBuffer(target, buffer);
  if (c.state().immediate().open()) {
    return;  // GL has refused
  }
  if (has_accepted(c, buffer)) {
    set_binding(c, target, buffer);
  }
  follow_binding(c, target, buffer);
  if (target == GL_EXTERNAL_VIRTUAL_MEMORY_BUFFER_AMD) {
    c.writes().never_trust_buffer(buffer);  // its contents are the application's memory
  }
}

void BindBufferBase(Context& c, GLenum target, GLuint index, GLuint buffer) {
  c.gl().BindBufferBase(target, index, buffer);
  if (c.state().immediate().open()) {
    return;  // GL has refused
  }
  if (has_accepted_index(c, target, index) && has_accepted(c, buffer)) {
    set_binding(c, target, buffer);
    set_indexed(c, target, index, {buffer, 0, 0});
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
