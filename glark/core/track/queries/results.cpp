// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Hooks that read results of queries. What our captures added is subtracted, in client memory and in buffers.
#include <algorithm>
#include <limits>
#include <utility>

#include "glark/core/objects/quiet.h"
#include "glark/core/track/track.h"

namespace glark::core {
namespace {

bool is_result(GLenum name) { return name == GL_QUERY_RESULT || name == GL_QUERY_RESULT_NO_WAIT; }

// As GL would give the result in this type.
template <typename Value>
Value without_surplus(std::int64_t counted, std::int64_t surplus) {
  const std::int64_t result = std::max<std::int64_t>(counted - surplus, 0);
  return std::cmp_less(std::numeric_limits<Value>::max(), result) ? std::numeric_limits<Value>::max()
                                                                  : static_cast<Value>(result);
}

// The right result. Waits for it.
template <typename Value>
Value right_result(const gl::Dispatch& gl, GLuint id, std::int64_t surplus) {
  GLuint64 counted = 0;
  gl.GetQueryObjectui64v(id, GL_QUERY_RESULT, &counted);
  return without_surplus<Value>(static_cast<std::int64_t>(counted), surplus);
}

// While it lives, another buffer is bound to GL_QUERY_BUFFER.
class QueryBufferBinding {
 public:
  QueryBufferBinding(Context& c, GLuint buffer) : gl_(c.gl()), previous_(c.state().bindings().query_buffer) {
    gl_.BindBuffer(GL_QUERY_BUFFER, buffer);
  }
  ~QueryBufferBinding() { gl_.BindBuffer(GL_QUERY_BUFFER, previous_); }
  QueryBufferBinding(const QueryBufferBinding&) = delete;
  QueryBufferBinding& operator=(const QueryBufferBinding&) = delete;

 private:
  const gl::Dispatch& gl_;
  GLuint previous_;
};

bool is_available(Context& c, GLuint id) {
  const QueryBufferBinding client_memory(c, 0);
  GLuint available = GL_FALSE;
  c.gl().GetQueryObjectuiv(id, GL_QUERY_RESULT_AVAILABLE, &available);
  return available != GL_FALSE;
}

// GL has written a result with our captures to the buffer, and the right one replaces it. glClearBufferSubData may write
// to any buffer, glBufferSubData may not.
template <typename Value>
void replace_result(Context& c, GLuint id, std::int64_t surplus, GLuint buffer, GLintptr offset) {
  constexpr GLenum format = sizeof(Value) == sizeof(GLuint) ? GL_R32UI : GL_RG32UI;
  constexpr GLenum components = sizeof(Value) == sizeof(GLuint) ? GL_RED_INTEGER : GL_RG_INTEGER;
  Value right = 0;
  {
    const QueryBufferBinding client_memory(c, 0);
    right = right_result<Value>(c.gl(), id, surplus);
  }
  const QueryBufferBinding bound(c, buffer);
  c.gl().ClearBufferSubData(GL_QUERY_BUFFER, format, offset, sizeof(Value), components, GL_UNSIGNED_INT, &right);
}

// Calls `get`, which writes the result to a buffer, and corrects it there. Nothing is corrected if GL refuses the call, or
// has no result yet (NO_WAIT).
template <typename Value, class Get>
void get_into_buffer(Context& c, GLuint id, GLenum name, GLuint buffer, GLintptr offset, const Get& get) {
  c.writes().to_buffer(buffer);
  const std::int64_t* surplus = c.state().query_surplus().find(id);
  if (surplus == nullptr || !is_result(name)) {
    get();
    return;
  }
  ErrorScope errors(c.pending_error());
  const Quiet quiet = c.state().quiet();
  quiet.interrupt();
  get();
  quiet.hush();
  if (const GLenum error = errors.take(); error != GL_NO_ERROR) {
    c.pending_error().raise(error);
    return;
  }
  if (name == GL_QUERY_RESULT_NO_WAIT && !is_available(c, id)) {
    return;
  }
  replace_result<Value>(c, id, *surplus, buffer, offset);
}

template <typename Value, class Get>
void get_result(Context& c, GLuint id, GLenum name, Value* result, const Get& get) {
  const GLuint buffer = c.capabilities().query_buffer ? c.state().bindings().query_buffer : 0;
  if (buffer != 0) {
    get_into_buffer<Value>(c, id, name, buffer, reinterpret_cast<GLintptr>(result), get);
    return;
  }
  const std::int64_t* surplus = c.state().query_surplus().find(id);
  if (surplus == nullptr || result == nullptr || !is_result(name)) {
    get();
    return;
  }
  ErrorScope errors(c.pending_error());
  const bool waits = name == GL_QUERY_RESULT;
  const bool written = waits || is_available(c, id);
  if (written) {
    get();
  }
  const GLenum error = errors.take();
  c.pending_error().raise(error);
  if (written && error == GL_NO_ERROR) {
    *result = without_surplus<Value>(static_cast<std::int64_t>(*result), *surplus);
  }
}

}  // namespace

namespace hook {

void GetQueryObjectiv(Context& c, GLuint id, GLenum name, GLint* result) {
  get_result(c, id, name, result, [&] { c.gl().GetQueryObjectiv(id, name, result); });
}

void GetQueryObjectuiv(Context& c, GLuint id, GLenum name, GLuint* result) {
  get_result(c, id, name, result, [&] { c.gl().GetQueryObjectuiv(id, name, result); });
}

void GetQueryObjecti64v(Context& c, GLuint id, GLenum name, GLint64* result) {
  get_result(c, id, name, result, [&] { c.gl().GetQueryObjecti64v(id, name, result); });
}

void GetQueryObjectui64v(Context& c, GLuint id, GLenum name, GLuint64* result) {
  get_result(c, id, name, result, [&] { c.gl().GetQueryObjectui64v(id, name, result); });
}

void GetQueryBufferObjectiv(Context& c, GLuint id, GLuint buffer, GLenum name, GLintptr offset) {
  get_into_buffer<GLint>(c, id, name, buffer, offset, [&] { c.gl().GetQueryBufferObjectiv(id, buffer, name, offset); });
}

void GetQueryBufferObjectuiv(Context& c, GLuint id, GLuint buffer, GLenum name, GLintptr offset) {
  get_into_buffer<GLuint>(c, id, name, buffer, offset,
                          [&] { c.gl().GetQueryBufferObjectuiv(id, buffer, name, offset); });
}

void GetQueryBufferObjecti64v(Context& c, GLuint id, GLuint buffer, GLenum name, GLintptr offset) {
  get_into_buffer<GLint64>(c, id, name, buffer, offset,
                           [&] { c.gl().GetQueryBufferObjecti64v(id, buffer, name, offset); });
}

void GetQueryBufferObjectui64v(Context& c, GLuint id, GLuint buffer, GLenum name, GLintptr offset) {
  get_into_buffer<GLuint64>(c, id, name, buffer, offset,
                            [&] { c.gl().GetQueryBufferObjectui64v(id, buffer, name, offset); });
}

}  // namespace hook
}  // namespace glark::core
