// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/state/arrays/vertex_arrays.h"

#include "glark/core/objects/get_integer.h"

namespace glark::core {
namespace {

// GL is asked about greater names at every glBindVertexArray.
constexpr GLuint most_seen = 1 << 20;

struct ConventionalQueries {
  GLenum array, size, type, stride, pointer, buffer;
};

ConventionalQueries queries_of(int slot) {
  switch (slot) {
    case vertex_slot:
      return {GL_VERTEX_ARRAY,        GL_VERTEX_ARRAY_SIZE,    GL_VERTEX_ARRAY_TYPE,
              GL_VERTEX_ARRAY_STRIDE, GL_VERTEX_ARRAY_POINTER, GL_VERTEX_ARRAY_BUFFER_BINDING};
    case normal_slot:
      return {GL_NORMAL_ARRAY,         0,
              GL_NORMAL_ARRAY_TYPE,    GL_NORMAL_ARRAY_STRIDE,
              GL_NORMAL_ARRAY_POINTER, GL_NORMAL_ARRAY_BUFFER_BINDING};
    case color_slot:
      return {GL_COLOR_ARRAY,        GL_COLOR_ARRAY_SIZE,    GL_COLOR_ARRAY_TYPE,
              GL_COLOR_ARRAY_STRIDE, GL_COLOR_ARRAY_POINTER, GL_COLOR_ARRAY_BUFFER_BINDING};
    case secondary_color_slot:
      return {GL_SECONDARY_COLOR_ARRAY,         GL_SECONDARY_COLOR_ARRAY_SIZE,
              GL_SECONDARY_COLOR_ARRAY_TYPE,    GL_SECONDARY_COLOR_ARRAY_STRIDE,
              GL_SECONDARY_COLOR_ARRAY_POINTER, GL_SECONDARY_COLOR_ARRAY_BUFFER_BINDING};
    case fog_coordinate_slot:
      return {GL_FOG_COORD_ARRAY,         0,
              GL_FOG_COORD_ARRAY_TYPE,    GL_FOG_COORD_ARRAY_STRIDE,
              GL_FOG_COORD_ARRAY_POINTER, GL_FOG_COORD_ARRAY_BUFFER_BINDING};
    default:
      return {GL_TEXTURE_COORD_ARRAY,        GL_TEXTURE_COORD_ARRAY_SIZE,    GL_TEXTURE_COORD_ARRAY_TYPE,
              GL_TEXTURE_COORD_ARRAY_STRIDE, GL_TEXTURE_COORD_ARRAY_POINTER, GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING};
  }
}

AttributeSource read_conventional(const gl::Dispatch& gl, int slot) {
  const ConventionalQueries queries = queries_of(slot);
  const bool texture = slot >= texture_coordinate_slot;
  const auto active = static_cast<GLenum>(texture ? get_integer(gl, GL_CLIENT_ACTIVE_TEXTURE) : 0);
  if (texture) {
    gl.ClientActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(slot - texture_coordinate_slot));
  }
  AttributeSource source;
  source.enabled = gl.IsEnabled(queries.array) != GL_FALSE;
  source.size = queries.size != 0 ? get_integer(gl, queries.size) : 0;
  source.type = static_cast<GLenum>(get_integer(gl, queries.type));
  source.stride = get_integer(gl, queries.stride);
  source.buffer = static_cast<GLuint>(get_integer(gl, queries.buffer));
  void* pointer = nullptr;
  gl.GetPointerv(queries.pointer, &pointer);
  source.offset = reinterpret_cast<GLintptr>(pointer);
  if (texture) {
    gl.ClientActiveTexture(active);
  }
  return source;
}

// The address of an array in client memory. The offset of its binding has only 32 bits in Mesa 22. Where an attribute
// uses the binding of another one, the address is not known: 0.
GLintptr client_address(const gl::Dispatch& gl, GLuint index, const AttributeSource& source) {
  void* pointer = nullptr;
  if (source.binding == index && source.relative_offset == 0) {
    gl.GetVertexAttribPointerv(index, GL_VERTEX_ATTRIB_ARRAY_POINTER, &pointer);
  }
  return reinterpret_cast<GLintptr>(pointer);
}

AttributeSource read_generic(const gl::Dispatch& gl, GLuint index) {
  const auto attribute = [&](GLenum name) {
    GLint value = 0;
    gl.GetVertexAttribiv(index, name, &value);
    return value;
  };
  AttributeSource source;
  source.enabled = attribute(GL_VERTEX_ATTRIB_ARRAY_ENABLED) != 0;
  source.size = attribute(GL_VERTEX_ATTRIB_ARRAY_SIZE);
  source.type = static_cast<GLenum>(attribute(GL_VERTEX_ATTRIB_ARRAY_TYPE));
  source.normalized = attribute(GL_VERTEX_ATTRIB_ARRAY_NORMALIZED) != 0;
  source.integer = attribute(GL_VERTEX_ATTRIB_ARRAY_INTEGER) != 0;
  source.relative_offset = static_cast<GLuint>(attribute(GL_VERTEX_ATTRIB_RELATIVE_OFFSET));
  source.binding = static_cast<GLuint>(attribute(GL_VERTEX_ATTRIB_BINDING));
  source.buffer = static_cast<GLuint>(attribute(GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING));
  GLint value = 0;
  gl.GetIntegeri_v(GL_VERTEX_BINDING_STRIDE, source.binding, &value);
  source.stride = value;
  gl.GetIntegeri_v(GL_VERTEX_BINDING_DIVISOR, source.binding, &value);
  source.divisor = static_cast<GLuint>(value);
  GLint64 offset = 0;
  gl.GetInteger64i_v(GL_VERTEX_BINDING_OFFSET, source.binding, &offset);
  source.offset = source.buffer != 0 ? static_cast<GLintptr>(offset) : client_address(gl, index, source);
  return source;
}

}  // namespace

void VertexArrays::confirm(GLuint name) {
  if (name >= most_seen) {
    return;
  }
  if (name >= seen_.size()) {
    seen_.resize(name + 1, false);
  }
  seen_[name] = true;
}

void VertexArrays::erase(GLuint name) {
  arrays_.erase(name);
  current_ = nullptr;
  if (name < seen_.size()) {
    seen_[name] = false;
  }
}

VertexArray& VertexArrays::look_up(GLuint name) {
  current_ = &arrays_[name];
  if (current_->epoch != epoch_) {
    current_->epoch = epoch_;
    current_->known = 0;
    current_->elements.known = false;
    current_->version = ++versions_;
  }
  return *current_;
}

GLsizei packed_stride(GLint size, GLenum type) {
  switch (type) {
    case GL_BYTE:
    case GL_UNSIGNED_BYTE: return size;
    case GL_SHORT:
    case GL_UNSIGNED_SHORT:
    case GL_HALF_FLOAT: return 2 * size;
    case GL_INT:
    case GL_UNSIGNED_INT:
    case GL_FLOAT: return 4 * size;
    case GL_DOUBLE: return 8 * size;
    default: return 0;
  }
}

AttributeSource read_source(const gl::Dispatch& gl, int slot) {
  return slot < generic_slots ? read_generic(gl, static_cast<GLuint>(slot)) : read_conventional(gl, slot);
}

}  // namespace glark::core
