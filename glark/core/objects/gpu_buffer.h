// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A buffer object of ours. Allocating it changes no binding. Sizes and offsets have 64 bits in programs of 32 bits, too:
// there, a GLsizeiptr is too small for what some draws would need.
#pragma once

#include <cstdint>

#include "glark/gl/dispatch.h"

namespace glark::core {

// Binds a buffer to GL_COPY_WRITE_BUFFER during its lifetime. It queries the old binding, so it is for rare paths only.
// OpenGL ES lacks the functions that need no binding (glNamedBufferData ...), although their addresses may be found
// there.
class CopyWriteBinding {
 public:
  CopyWriteBinding(const gl::Dispatch& gl, GLuint buffer);
  ~CopyWriteBinding();
  CopyWriteBinding(const CopyWriteBinding&) = delete;
  CopyWriteBinding& operator=(const CopyWriteBinding&) = delete;

 private:
  const gl::Dispatch& gl_;
  GLuint previous_;
};

class GpuBuffer {
 public:
  // Allocates, or allocates again; `data` may be null. False: GL has no memory or cannot express the size, and
  // the old storage is kept.
  // The caller has an ErrorScope.
  bool allocate(const gl::Dispatch& gl, std::int64_t size, const void* data, GLenum usage);
  // Grows to at least `size`, and by at least half. The contents are lost.
  bool reserve(const gl::Dispatch& gl, std::int64_t size, GLenum usage);
  void write(const gl::Dispatch& gl, std::int64_t offset, std::int64_t size, const void* data) const;
  // False: GL cannot map the buffer, and `data` stays.
  bool read(const gl::Dispatch& gl, std::int64_t offset, std::int64_t size, void* data) const;
  void copy_from(const gl::Dispatch& gl, GLuint buffer, std::int64_t from, std::int64_t to, std::int64_t size) const;
  void release(const gl::Dispatch& gl);

  // The number of buffers of ours that were deleted, in all contexts. Drivers give the name of a deleted buffer to a new
  // one, while a vertex array still holds the deleted one. So a remembered name is valid until this number changes.
  static std::uint32_t deletions();

  GLuint name() const { return name_; }
  std::int64_t size() const { return size_; }

 private:
  GLuint name_ = 0;
  std::int64_t size_ = 0;
};

}  // namespace glark::core
