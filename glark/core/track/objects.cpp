// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Hooks of buffers, vertex arrays, transform feedback and queries: the bindings that a refined draw changes and puts back.
#include <algorithm>

#include "glark/core/track/track.h"

namespace glark::core {
namespace {

// Whether GL took the name, as far as can be told without asking: in core contexts it refuses names that it did not give out.
bool surely_bound(const Context& c, GLuint buffer, std::uint64_t generation) {
  return !c.state().immediate().open && (buffer == 0 || c.capabilities().api != Capabilities::Api::core ||
                                         c.state().bound_buffers().confirmed(buffer, generation));
}

// What writes to `target` go to. If it is not sure, the first write asks.
void follow_binding(Context& c, GLenum target, GLuint buffer) {
  const std::uint64_t generation = c.share().buffers.generation(buffer);
  const BoundBuffer bound{surely_bound(c, buffer, generation), buffer, generation};
  if (target == GL_ELEMENT_ARRAY_BUFFER) {
    c.state().vertex_arrays().current(c.state().bindings().vertex_array).elements = bound;
  } else if (BoundBuffer* kept = c.state().bound_buffers().at(target); kept != nullptr) {
    *kept = bound;
  }
}

// Indexed bindings of other targets than uniform buffers are for writing.
void follow_indexed(Context& c, GLenum target, GLuint buffer) {
  if (BoundBuffer* kept = c.state().bound_buffers().at(target); kept != nullptr) {
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
    case GL_TRANSFORM_FEEDBACK_BUFFER: c.state().bindings().feedback_buffer = buffer; break;
    default: break;
  }
}

void set_indexed(Context& c, GLenum target, GLuint index, const IndexedBuffer& binding) {
  if (target == GL_SHADER_STORAGE_BUFFER && index < c.state().bindings().storage.size()) {
    c.state().bindings().storage[index] = binding;
  }
}

bool counts_primitives(GLenum target) {
  switch (target) {
    case GL_PRIMITIVES_GENERATED:
    case GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN:
    case GL_TRANSFORM_FEEDBACK_OVERFLOW:
    case GL_TRANSFORM_FEEDBACK_STREAM_OVERFLOW:
    case GL_VERTICES_SUBMITTED:
    case GL_PRIMITIVES_SUBMITTED:
    case GL_VERTEX_SHADER_INVOCATIONS:
    case GL_GEOMETRY_SHADER_INVOCATIONS:
    case GL_GEOMETRY_SHADER_PRIMITIVES_EMITTED:
    case GL_CLIPPING_INPUT_PRIMITIVES:
    case GL_CLIPPING_OUTPUT_PRIMITIVES:
    case GL_COMPUTE_SHADER_INVOCATIONS: return true;
    default: return false;
  }
}

// The slot that remembers which query counts triangles of stream 0; null for other targets.
GLuint* triangle_query(Context& c, GLenum target, GLuint index) {
  if (index != 0) {
    return nullptr;
  }
  return target == GL_PRIMITIVES_GENERATED                    ? &c.state().bindings().primitives_generated_query
         : target == GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN ? &c.state().bindings().primitives_written_query
                                                              : nullptr;
}

void query_begun(Context& c, GLenum target, GLuint index, GLuint id) {
  if (!counts_primitives(target)) {
    return;
  }
  ++c.state().bindings().primitive_queries;
  if (GLuint* slot = triangle_query(c, target, index); slot != nullptr && *slot == 0) {
    *slot = id;
    c.state().query_surplus().forget(id);
  }
}

void query_ended(Context& c, GLenum target, GLuint index) {
  if (!counts_primitives(target)) {
    return;
  }
  c.state().bindings().primitive_queries = std::max(0, c.state().bindings().primitive_queries - 1);
  if (GLuint* slot = triangle_query(c, target, index); slot != nullptr) {
    *slot = 0;
  }
}

// Takes what our captures added out of a result that GL has written to client memory.
template <typename Value>
void correct_result(Context& c, GLuint id, GLenum name, Value* result) {
  const BoundBuffer* bound = c.state().bound_buffers().at(GL_QUERY_BUFFER);
  if (c.capabilities().query_buffer && (!bound->known || bound->name != 0)) {
    c.writes().to_target(GL_QUERY_BUFFER);
  }
  const std::uint64_t* surplus = c.state().query_surplus().find(id);
  if (surplus == nullptr || result == nullptr || c.state().bindings().query_buffer != 0 ||
      (name != GL_QUERY_RESULT && name != GL_QUERY_RESULT_NO_WAIT)) {
    return;
  }
  *result -= std::min(*result, static_cast<Value>(*surplus));
}

}  // namespace

namespace hook {

// The most frequent target first, and the real call last, by a jump: programs bind before every draw.
void BindBuffer(Context& c, GLenum target, GLuint buffer) {
  if (target == GL_ARRAY_BUFFER) {
    const std::uint64_t generation = c.share().buffers.generation(buffer);
    c.state().bound_buffers().array() = {surely_bound(c, buffer, generation), buffer, generation};
  } else {
    set_binding(c, target, buffer);
    follow_binding(c, target, buffer);
  }
  if (target == GL_EXTERNAL_VIRTUAL_MEMORY_BUFFER_AMD) {
    c.writes().never_trust_buffer(buffer);  // its contents are the application's memory
  }
  c.gl().BindBuffer(target, buffer);
}

void BindBufferBase(Context& c, GLenum target, GLuint index, GLuint buffer) {
  c.gl().BindBufferBase(target, index, buffer);
  set_binding(c, target, buffer);
  set_indexed(c, target, index, {buffer, 0, 0});
  follow_indexed(c, target, buffer);
}

void BindBufferRange(Context& c, GLenum target, GLuint index, GLuint buffer, GLintptr offset, GLsizeiptr size) {
  c.gl().BindBufferRange(target, index, buffer, offset, size);
  follow_indexed(c, target, buffer);
  if (target == GL_SHADER_STORAGE_BUFFER) {
    c.state().forget_bindings();  // GL checks alignment: ask it what it took
  } else {
    set_binding(c, target, buffer);
  }
}

void BindBufferOffsetEXT(Context& c, GLenum target, GLuint index, GLuint buffer, GLintptr offset) {
  c.gl().BindBufferOffsetEXT(target, index, buffer, offset);
  follow_indexed(c, target, buffer);
  set_binding(c, target, buffer);
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
  c.state().forget_bindings();                 // deleting unbinds
  c.state().vertex_arrays().forget_current();  // from the bound vertex array too; other ones keep the object
  c.state().vertex_arrays().forget_elements();
  for (GLsizei i = 0; i < n && buffers != nullptr; ++i) {
    c.writes().deleted(buffers[i]);
    c.state().bound_buffers().unbind(buffers[i]);
  }
}

void BindVertexArray(Context& c, GLuint array) {
  c.gl().BindVertexArray(array);
  if (!c.state().vertex_arrays().bind(array) && array != 0) {
    if (c.state().immediate().open || c.gl().IsVertexArray(array) == GL_FALSE) {
      c.state().vertex_arrays().bind(c.state().bindings().vertex_array);  // GL has refused
      return;
    }
    c.state().vertex_arrays().confirm(array);
  }
  c.state().bindings().vertex_array = array;
}

void DeleteVertexArrays(Context& c, GLsizei n, const GLuint* arrays) {
  c.gl().DeleteVertexArrays(n, arrays);
  for (GLsizei i = 0; i < n && arrays != nullptr; ++i) {
    c.state().vertex_arrays().erase(arrays[i]);
    c.state().bindings().vertex_array =
        c.state().bindings().vertex_array == arrays[i] ? 0 : c.state().bindings().vertex_array;
  }
  c.state().forget_bindings();
}

void BindTransformFeedback(Context& c, GLenum target, GLuint id) {
  c.gl().BindTransformFeedback(target, id);
  c.state().forget_bindings();  // its activity comes with it
}

void DeleteTransformFeedbacks(Context& c, GLsizei n, const GLuint* ids) {
  c.gl().DeleteTransformFeedbacks(n, ids);
  c.state().forget_bindings();
}

void BeginTransformFeedback(Context& c, GLenum mode) {
  if (c.capabilities().refinable) {
    c.state().refresh();
    c.stages()->feedback().room().note();
  }
  if (!c.refining() || c.options().transparent || !c.stages()->feedback().begin(mode)) {
    c.gl().BeginTransformFeedback(mode);
    c.state().forget_bindings();  // GL may have refused
    if (c.capabilities().refinable && !c.options().transparent && !c.ark().enabled && c.ark().pool_level >= 0) {
      c.stages()->feedback().await(mode);
      c.update_refining();
    }
    return;
  }
  c.state().bindings().transform_feedback_active = true;
  c.state().bindings().transform_feedback_paused = false;
}

void EndTransformFeedback(Context& c) {
  c.gl().EndTransformFeedback();
  if (c.stages() != nullptr) {
    c.stages()->feedback().end();
    c.update_refining();
  }
  c.writes().by_gpu();
  c.state().forget_bindings();
}

void PauseTransformFeedback(Context& c) {
  if (c.stages() != nullptr && c.stages()->feedback().ours() && !c.state().bindings().transform_feedback_paused) {
    c.state().bindings().transform_feedback_paused = true;  // between our draws it is paused anyway
    return;
  }
  c.gl().PauseTransformFeedback();
  c.writes().by_gpu();
  c.state().forget_bindings();
}

void ResumeTransformFeedback(Context& c) {
  if (c.stages() != nullptr && c.stages()->feedback().ours() && c.state().bindings().transform_feedback_paused) {
    c.state().bindings().transform_feedback_paused = false;
    return;
  }
  c.gl().ResumeTransformFeedback();
  c.state().forget_bindings();
}

void BeginQuery(Context& c, GLenum target, GLuint id) {
  c.gl().BeginQuery(target, id);
  query_begun(c, target, 0, id);
}

void EndQuery(Context& c, GLenum target) {
  c.gl().EndQuery(target);
  query_ended(c, target, 0);
}

void BeginQueryIndexed(Context& c, GLenum target, GLuint index, GLuint id) {
  c.gl().BeginQueryIndexed(target, index, id);
  query_begun(c, target, index, id);
}

void EndQueryIndexed(Context& c, GLenum target, GLuint index) {
  c.gl().EndQueryIndexed(target, index);
  query_ended(c, target, index);
}

void GetQueryObjectiv(Context& c, GLuint id, GLenum name, GLint* result) {
  c.gl().GetQueryObjectiv(id, name, result);
  correct_result(c, id, name, result);
}

void GetQueryObjectuiv(Context& c, GLuint id, GLenum name, GLuint* result) {
  c.gl().GetQueryObjectuiv(id, name, result);
  correct_result(c, id, name, result);
}

void GetQueryObjecti64v(Context& c, GLuint id, GLenum name, GLint64* result) {
  c.gl().GetQueryObjecti64v(id, name, result);
  correct_result(c, id, name, result);
}

void GetQueryObjectui64v(Context& c, GLuint id, GLenum name, GLuint64* result) {
  c.gl().GetQueryObjectui64v(id, name, result);
  correct_result(c, id, name, result);
}

}  // namespace hook
}  // namespace glark::core
