// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/objects/gpu_buffer.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <limits>

#include "glark/core/objects/buffer_names.h"

namespace glark::core {
namespace {

std::atomic<std::uint32_t> deleted{0};

}  // namespace

CopyWriteBinding::CopyWriteBinding(const gl::Dispatch& gl, GLuint buffer) : gl_(gl) {
  GLint previous = 0;
  gl.GetIntegerv(GL_COPY_WRITE_BUFFER_BINDING, &previous);
  previous_ = static_cast<GLuint>(previous);
  gl.BindBuffer(GL_COPY_WRITE_BUFFER, buffer);
}

CopyWriteBinding::~CopyWriteBinding() { gl_.BindBuffer(GL_COPY_WRITE_BUFFER, previous_); }

bool GpuBuffer::allocate(const gl::Dispatch& gl, std::int64_t size, const void* data, GLenum usage) {
  if (size > std::numeric_limits<GLsizeiptr>::max()) {
    return false;
  }
  GLuint fresh = 0;
  {
    const CopyWriteBinding binding(gl, 0);
    fresh = bind_new_buffer(gl);
    gl.BufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(size), data, usage);
  }
  if (gl.GetError() != GL_NO_ERROR) {
    gl.DeleteBuffers(1, &fresh);
    return false;
  }
  release(gl);
  name_ = fresh;
  size_ = size;
  return true;
}

bool GpuBuffer::reserve(const gl::Dispatch& gl, std::int64_t size, GLenum usage) {
  constexpr std::int64_t grain = 16;  // the sizes of bound ranges must be multiples of 4
  const std::int64_t wanted = (std::max(size, size_ + size_ / 2) + grain - 1) / grain * grain;
  return size <= size_ || allocate(gl, wanted, nullptr, usage);
}

void GpuBuffer::write(const gl::Dispatch& gl, std::int64_t offset, std::int64_t size, const void* data) const {
  const CopyWriteBinding binding(gl, name_);
  gl.BufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(size), data);
}

bool GpuBuffer::read(const gl::Dispatch& gl, std::int64_t offset, std::int64_t size, void* data) const {
  const CopyWriteBinding binding(gl, name_);
  const void* mapped = gl.MapBufferRange(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(offset),
                                         static_cast<GLsizeiptr>(size), GL_MAP_READ_BIT);
  if (mapped == nullptr) {
    return false;
  }
  std::memcpy(data, mapped, static_cast<std::size_t>(size));
  return gl.UnmapBuffer(GL_COPY_WRITE_BUFFER) == GL_TRUE;
}

void GpuBuffer::copy_from(const gl::Dispatch& gl, GLuint buffer, std::int64_t from, std::int64_t to,
                          std::int64_t size) const {
  const CopyWriteBinding binding(gl, name_);
  GLint previous = 0;
  gl.GetIntegerv(GL_COPY_READ_BUFFER_BINDING, &previous);
  gl.BindBuffer(GL_COPY_READ_BUFFER, buffer);
  gl.CopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(from),
                       static_cast<GLintptr>(to), static_cast<GLsizeiptr>(size));
  gl.BindBuffer(GL_COPY_READ_BUFFER, static_cast<GLuint>(previous));
}

void GpuBuffer::release(const gl::Dispatch& gl) {
  if (name_ != 0) {
    gl.DeleteBuffers(1, &name_);
    deleted.fetch_add(1, std::memory_order_relaxed);
    name_ = 0;
    size_ = 0;
  }
}

std::uint32_t GpuBuffer::deletions() { return deleted.load(std::memory_order_relaxed); }

}  // namespace glark::core
