// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A buffer object of ours. Allocation leaves every binding point as it was.
#pragma once

#include "glark/gl/dispatch.h"

namespace glark::core {

// Binds to GL_COPY_WRITE_BUFFER for the life of the scope. Reads a binding back: for rare paths only. Functions without a binding
// (glNamedBufferData ...) are missing from OpenGL ES, where their addresses may nevertheless be had.
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
  // (Re)allocates; contents are `data` or undefined. False if GL has no memory: the old storage is then kept.
  // The caller wraps this in an ErrorScope.
  bool allocate(const gl::Dispatch& gl, GLsizeiptr size, const void* data, GLenum usage);
  // Grows to at least `size`, by at least half; contents are lost.
  bool reserve(const gl::Dispatch& gl, GLsizeiptr size, GLenum usage);
  void write(const gl::Dispatch& gl, GLintptr offset, GLsizeiptr size, const void* data) const;
  void read(const gl::Dispatch& gl, GLintptr offset, GLsizeiptr size, void* data) const;
  void copy_from(const gl::Dispatch& gl, GLuint buffer, GLintptr from, GLintptr to, GLsizeiptr size) const;
  void release(const gl::Dispatch& gl);

  GLuint name() const { return name_; }
  GLsizeiptr size() const { return size_; }

 private:
  GLuint name_ = 0;
  GLsizeiptr size_ = 0;
};

}  // namespace glark::core
