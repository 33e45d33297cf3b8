// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The buffer object that is bound to each target: functions such as glBufferSubData write to it.
// GL_ELEMENT_ARRAY_BUFFER belongs to the vertex array (vertex_arrays.h).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "glark/gl/types.h"

namespace glark::core {

struct BoundBuffer {
  bool known = false;
  GLuint name = 0;
  std::uint64_t generation = 0;  // generation of the name when it was bound
};

class BoundBuffers {
 public:
  // Null for targets that are not kept.
  BoundBuffer* at(GLenum target) {
    const int index = index_of(target);
    return index < 0 ? nullptr : &bound_[static_cast<std::size_t>(index)];
  }
  BoundBuffer& array() { return bound_[0]; }
  void forget() { bound_ = {}; }
  // GL has an object with that name and generation.
  void confirm(GLuint name, std::uint64_t generation) {
    if (name < most_confirmed) {
      if (name >= confirmed_.size()) {
        confirmed_.resize(name + 1, no_generation);
      }
      confirmed_[name] = generation;
    }
  }
  bool confirmed(GLuint name, std::uint64_t generation) const {
    return name < confirmed_.size() && confirmed_[name] == generation;
  }
  // Deletion unbinds in the current context.
  void unbind(GLuint name) {
    for (BoundBuffer& bound : bound_) {
      if (bound.name == name) {
        bound = {bound.known, 0, 0};
      }
    }
  }

 private:
  static constexpr int index_of(GLenum target) {
    switch (target) {
      case GL_ARRAY_BUFFER: return 0;
      case GL_UNIFORM_BUFFER: return 1;
      case GL_COPY_WRITE_BUFFER: return 2;
      case GL_COPY_READ_BUFFER: return 3;
      case GL_PIXEL_PACK_BUFFER: return 4;
      case GL_PIXEL_UNPACK_BUFFER: return 5;
      case GL_SHADER_STORAGE_BUFFER: return 6;
      case GL_TRANSFORM_FEEDBACK_BUFFER: return 7;
      case GL_TEXTURE_BUFFER: return 8;
      case GL_ATOMIC_COUNTER_BUFFER: return 9;
      case GL_DRAW_INDIRECT_BUFFER: return 10;
      case GL_DISPATCH_INDIRECT_BUFFER: return 11;
      case GL_QUERY_BUFFER: return 12;
      case GL_PARAMETER_BUFFER: return 13;
      default: return -1;
    }
  }

  static constexpr GLuint most_confirmed = 1 << 16;
  static constexpr std::uint64_t no_generation = ~std::uint64_t{0};
  std::array<BoundBuffer, 14> bound_{};
  std::vector<std::uint64_t> confirmed_;  // by name: the generation that GL confirmed
};

// The name that queries the binding of a target; 0 for targets that OpenGL does not have.
constexpr GLenum binding_of(GLenum target) {
  switch (target) {
    case GL_ARRAY_BUFFER: return GL_ARRAY_BUFFER_BINDING;
    case GL_ELEMENT_ARRAY_BUFFER: return GL_ELEMENT_ARRAY_BUFFER_BINDING;
    case GL_UNIFORM_BUFFER: return GL_UNIFORM_BUFFER_BINDING;
    case GL_COPY_WRITE_BUFFER: return GL_COPY_WRITE_BUFFER_BINDING;
    case GL_COPY_READ_BUFFER: return GL_COPY_READ_BUFFER_BINDING;
    case GL_PIXEL_PACK_BUFFER: return GL_PIXEL_PACK_BUFFER_BINDING;
    case GL_PIXEL_UNPACK_BUFFER: return GL_PIXEL_UNPACK_BUFFER_BINDING;
    case GL_SHADER_STORAGE_BUFFER: return GL_SHADER_STORAGE_BUFFER_BINDING;
    case GL_TRANSFORM_FEEDBACK_BUFFER: return GL_TRANSFORM_FEEDBACK_BUFFER_BINDING;
    case GL_TEXTURE_BUFFER: return GL_TEXTURE_BUFFER_BINDING;
    case GL_ATOMIC_COUNTER_BUFFER: return GL_ATOMIC_COUNTER_BUFFER_BINDING;
    case GL_DRAW_INDIRECT_BUFFER: return GL_DRAW_INDIRECT_BUFFER_BINDING;
    case GL_DISPATCH_INDIRECT_BUFFER: return GL_DISPATCH_INDIRECT_BUFFER_BINDING;
    case GL_QUERY_BUFFER: return GL_QUERY_BUFFER_BINDING;
    case GL_PARAMETER_BUFFER: return GL_PARAMETER_BUFFER_BINDING;
    default: return 0;
  }
}

}  // namespace glark::core
