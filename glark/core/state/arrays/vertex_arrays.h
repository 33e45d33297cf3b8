// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The state of the vertex array objects, as far as draws need it. It is read from GL when it is first needed. The hooks
// of the usual calls then keep it up to date; any other call makes it unknown.
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "glark/core/state/arrays/attribute_slots.h"
#include "glark/core/state/arrays/bound_buffers.h"
#include "glark/gl/dispatch.h"

namespace glark::core {

// The source of an attribute's values.
struct AttributeSource {
  bool enabled = false;
  bool normalized = false;
  bool integer = false;
  GLint size = 4;
  GLenum type = GL_FLOAT;
  GLuint relative_offset = 0;
  GLuint binding = 0;  // generic attributes only
  GLuint divisor = 0;
  GLuint buffer = 0;
  std::uint64_t generation = 0;  // generation of the buffer's name when it was attached
  GLintptr offset = 0;
  GLsizei stride = 0;
  bool operator==(const AttributeSource&) const = default;
};

struct VertexArray {
  std::uint64_t known = 0;  // slots whose source is valid
  std::uint64_t epoch = 0;
  std::uint64_t version = 0;  // another number after each change, of this or of any other array
  std::array<AttributeSource, slot_count> sources{};
  BoundBuffer elements;
};

class VertexArrays {
 public:
  // `name` is bound. False: GL must be asked whether there is such an object.
  bool bind(GLuint name) {
    current_ = nullptr;
    return name < seen_.size() && seen_[name];
  }
  void confirm(GLuint name);
  void erase(GLuint name);

  void forget_current() {
    if (current_ == nullptr) {
      forget_all();
      return;
    }
    current_->known = 0;
    current_->version = ++versions_;
  }
  void forget_elements() {
    if (current_ == nullptr) {
      forget_all();
      return;
    }
    current_->elements.known = false;
    current_->version = ++versions_;
  }
  void forget_all() {
    ++epoch_;
    current_ = nullptr;
  }
  // The array that is bound, which is `name`: to read it, or to fill in what GL says.
  VertexArray& current(GLuint name) { return current_ != nullptr ? *current_ : look_up(name); }
  // The same, for calls that change it.
  VertexArray& change(GLuint name) {
    VertexArray& array = current(name);
    array.version = ++versions_;
    return array;
  }

 private:
  VertexArray& look_up(GLuint name);

  std::unordered_map<GLuint, VertexArray> arrays_;
  std::vector<bool> seen_;  // names that GL is known to have objects for
  VertexArray* current_ = nullptr;
  std::uint64_t epoch_ = 1;
  std::uint64_t versions_ = 0;
};

// Bytes from one element to the next if the application gives a stride of 0; 0 for unknown types.
GLsizei packed_stride(GLint size, GLenum type);

// Queries GL for a source of the bound vertex array.
AttributeSource read_source(const gl::Dispatch& gl, int slot);

}  // namespace glark::core
