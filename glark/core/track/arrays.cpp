// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Hooks of vertex arrays. Most are called only while the context refines, because programs call these functions all the
// time. If GL may refuse the arguments, the state of the array becomes unknown: the next draw asks GL for it.
#include "glark/core/track/track.h"

namespace glark::core {
namespace {

// OpenGL's own minimum of GL_MAX_VERTEX_ATTRIB_STRIDE.
constexpr GLsizei surely_valid_stride = 2048;

// The vertex array that the call changes; null if its state becomes unknown.
VertexArray* followed(Context& c) {
  if (c.state().immediate().open()) {
    c.state().arrays().vertex_arrays().forget_current();
    return nullptr;
  }
  c.state().refresh();
  return &c.state().arrays().vertex_arrays().change(c.state().bindings().vertex_array);
}

struct Pointer {
  GLint size;
  GLenum type;
  bool normalized = false;
  bool integer = false;
  GLsizei stride;
  const void* pointer;
};

// glVertexPointer and similar functions use the buffer that is bound to GL_ARRAY_BUFFER.
bool attach(Context& c, AttributeSource& source, const Pointer& to) {
  const BoundBuffer bound = c.state().arrays().bound_buffer(GL_ARRAY_BUFFER);
  const bool es_double = to.type == GL_DOUBLE && c.capabilities().api == Capabilities::Api::es;
  const GLsizei packed = es_double ? 0 : packed_stride(to.size, to.type);
  if (!bound.known || packed == 0 || to.stride < 0 || to.stride > surely_valid_stride ||
      (bound.name == 0 && !c.capabilities().is_compatibility())) {
    return false;
  }
  source.size = to.size;
  source.type = to.type;
  source.normalized = to.normalized;
  source.integer = to.integer;
  source.relative_offset = 0;
  source.buffer = bound.name;
  source.generation = bound.generation;
  source.offset = reinterpret_cast<GLintptr>(to.pointer);
  source.stride = to.stride;
  return true;
}

bool is_size(GLint size) { return size >= 1 && size <= 4; }

void point_conventional(Context& c, int slot, bool valid, const Pointer& to) {
  VertexArray* array = followed(c);
  if (array == nullptr) {
    return;
  }
  if (slot == no_slot || !valid || !attach(c, array->sources[static_cast<std::size_t>(slot)], to)) {
    array->known = 0;
  }
}

void point_generic(Context& c, GLuint index, const Pointer& to) {
  VertexArray* array = followed(c);
  if (array == nullptr) {
    return;
  }
  // The call uses binding `index`, which may feed other attributes, too. The divisor belongs to the binding.
  std::uint64_t changed = 0;
  for (GLuint other = 0; other < generic_slots; ++other) {
    changed |= array->sources[other].binding == index || other == index ? slot_bit(static_cast<int>(other)) : 0;
  }
  const bool keeps_divisor = index < generic_slots && array->sources[index].binding == index;
  if (keeps_divisor && is_size(to.size) && attach(c, array->sources[index], to)) {
    array->sources[index].stride = to.stride != 0 ? to.stride : packed_stride(to.size, to.type);
    changed &= ~slot_bit(static_cast<int>(index));
  }
  array->known &= ~changed;
}

void enable_generic(Context& c, GLuint index, bool enabled) {
  VertexArray* array = followed(c);
  if (array != nullptr && index < generic_slots) {
    array->sources[index].enabled = enabled;
  }
}

}  // namespace

namespace hook {

void BindVertexArray(Context& c, GLuint array) {
  c.gl().BindVertexArray(array);
  if (!c.state().arrays().vertex_arrays().bind(array) && array != 0) {
    if (c.gl().IsVertexArray(array) == GL_FALSE) {
      c.state().arrays().vertex_arrays().bind(c.state().bindings().vertex_array);  // GL has refused
      return;
    }
    c.state().arrays().vertex_arrays().confirm(array);
  }
  c.state().bindings().vertex_array = array;
}

void DeleteVertexArrays(Context& c, GLsizei n, const GLuint* arrays) {
  c.gl().DeleteVertexArrays(n, arrays);
  for (GLsizei i = 0; i < n && arrays != nullptr; ++i) {
    c.state().arrays().vertex_arrays().erase(arrays[i]);
    c.state().bindings().vertex_array =
        c.state().bindings().vertex_array == arrays[i] ? 0 : c.state().bindings().vertex_array;
  }
  c.state().forget_bindings();
}

void VertexAttribPointer(Context& c, GLuint index, GLint size, GLenum type, GLboolean normalized, GLsizei stride,
                         const void* pointer) {
  c.gl().VertexAttribPointer(index, size, type, normalized, stride, pointer);
  point_generic(
      c, index,
      {.size = size, .type = type, .normalized = normalized != GL_FALSE, .stride = stride, .pointer = pointer});
}

void VertexAttribIPointer(Context& c, GLuint index, GLint size, GLenum type, GLsizei stride, const void* pointer) {
  c.gl().VertexAttribIPointer(index, size, type, stride, pointer);
  const bool integer = type != GL_FLOAT && type != GL_DOUBLE && type != GL_HALF_FLOAT;  // GL refuses other types
  point_generic(c, index,
                {.size = integer ? size : 0, .type = type, .integer = true, .stride = stride, .pointer = pointer});
}

void BindVertexBuffer(Context& c, GLuint binding, GLuint buffer, GLintptr offset, GLsizei stride) {
  c.gl().BindVertexBuffer(binding, buffer, offset, stride);
  VertexArray* array = followed(c);
  if (array == nullptr) {
    return;
  }
  const bool valid = (c.capabilities().is_compatibility() || c.state().bindings().vertex_array != 0) && offset >= 0 &&
                     stride >= 0 && stride <= surely_valid_stride && c.gl().IsBuffer(buffer) != GL_FALSE;
  for (GLuint i = 0; i < generic_slots; ++i) {
    AttributeSource& source = array->sources[i];
    if (source.binding != binding) {
      continue;
    }
    if (!valid) {
      array->known &= ~slot_bit(static_cast<int>(i));
    } else {
      source.buffer = buffer;
      source.generation = c.share().buffers.generation(buffer);
      source.offset = offset;
      source.stride = stride;
    }
  }
}

void EnableVertexAttribArray(Context& c, GLuint index) {
  c.gl().EnableVertexAttribArray(index);
  enable_generic(c, index, true);
}

void DisableVertexAttribArray(Context& c, GLuint index) {
  c.gl().DisableVertexAttribArray(index);
  enable_generic(c, index, false);
}

void VertexPointer(Context& c, GLint size, GLenum type, GLsizei stride, const void* pointer) {
  c.gl().VertexPointer(size, type, stride, pointer);
  const bool valid = size >= 2 && size <= 4 && type != GL_BYTE && type != GL_UNSIGNED_BYTE &&
                     type != GL_UNSIGNED_SHORT && type != GL_UNSIGNED_INT;
  point_conventional(c, vertex_slot, valid, {.size = size, .type = type, .stride = stride, .pointer = pointer});
}

void NormalPointer(Context& c, GLenum type, GLsizei stride, const void* pointer) {
  c.gl().NormalPointer(type, stride, pointer);
  const bool valid = type != GL_UNSIGNED_BYTE && type != GL_UNSIGNED_SHORT && type != GL_UNSIGNED_INT;
  point_conventional(c, normal_slot, valid, {.size = 3, .type = type, .stride = stride, .pointer = pointer});
}

void ColorPointer(Context& c, GLint size, GLenum type, GLsizei stride, const void* pointer) {
  c.gl().ColorPointer(size, type, stride, pointer);
  point_conventional(c, color_slot, size == 3 || size == 4,
                     {.size = size, .type = type, .stride = stride, .pointer = pointer});
}

void TexCoordPointer(Context& c, GLint size, GLenum type, GLsizei stride, const void* pointer) {
  c.gl().TexCoordPointer(size, type, stride, pointer);
  const bool valid = is_size(size) && type != GL_BYTE && type != GL_UNSIGNED_BYTE && type != GL_UNSIGNED_SHORT &&
                     type != GL_UNSIGNED_INT;
  point_conventional(c, texture_slot(c.state().arrays().client_texture()), valid,
                     {.size = size, .type = type, .stride = stride, .pointer = pointer});
}

void ClientActiveTexture(Context& c, GLenum texture) {
  c.gl().ClientActiveTexture(texture);
  c.state().arrays().set_client_texture(!c.state().immediate().open() && texture_slot(texture) != no_slot ? texture
                                                                                                          : 0);
}

}  // namespace hook
}  // namespace glark::core
