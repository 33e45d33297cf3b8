// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/state/arrays/array_state.h"

namespace glark::core {
namespace {

GLuint get_name(const gl::Dispatch& gl, GLenum binding) {
  GLint name = 0;
  gl.GetIntegerv(binding, &name);
  return static_cast<GLuint>(name);
}

}  // namespace

// The generation of an object that GL names and that was attached at an unknown time. A name that was never deleted has
// only one generation, the first. Any other name gets a number that no generation has.
std::uint64_t ArrayState::generation_of(GLuint name) {
  const std::uint64_t unique = of_.stamps.next();
  return of_.buffers.generation(name) == 0 ? 0 : unique;
}

// GL says that `name` is bound. If the hooks thought so too, they also know since when.
void ArrayState::confirm(BoundBuffer& bound, GLuint name) {
  if (bound.name != name) {
    bound = {false, name, generation_of(name)};
  }
  bound.known = true;
  if (bound.generation == of_.buffers.generation(name)) {  // not an object whose name was deleted
    bound_buffers_.confirm(name, bound.generation);
  }
}

BoundBuffer ArrayState::bound_buffer(GLenum target) {
  const bool can_ask = !of_.immediate.open() && of_.capabilities.refinable;
  if (target == GL_ELEMENT_ARRAY_BUFFER) {
    return can_ask ? element_buffer() : BoundBuffer();
  }
  BoundBuffer* kept = bound_buffers_.at(target);
  if (kept != nullptr && kept->known) {
    return *kept;
  }
  // Between glBegin and glEnd GL answers no queries, and old versions do not answer for every target.
  if (kept == nullptr || !can_ask) {
    return {};
  }
  confirm(*kept, get_name(of_.gl, binding_of(target)));
  return *kept;
}

const AttributeSource& ArrayState::attribute_source(int slot) {
  VertexArray& array = current();
  AttributeSource& source = array.sources[static_cast<std::size_t>(slot)];
  if ((array.known & slot_bit(slot)) == 0) {
    source = read_source(of_.gl, slot);
    source.generation = generation_of(source.buffer);
    array.known |= slot_bit(slot);
  }
  return source;
}

const BoundBuffer& ArrayState::element_buffer() {
  BoundBuffer& elements = current().elements;
  if (!elements.known) {
    confirm(elements, get_name(of_.gl, GL_ELEMENT_ARRAY_BUFFER_BINDING));
  }
  return elements;
}

void ArrayState::read_client_state() {
  of_.bindings.vertex_array = get_name(of_.gl, GL_VERTEX_ARRAY_BINDING);
  client_texture_ = of_.capabilities.is_compatibility() ? get_name(of_.gl, GL_CLIENT_ACTIVE_TEXTURE) : 0;
}

}  // namespace glark::core
