// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/meshes/buffer_points.h"

#include <algorithm>
#include <cstring>
#include <span>

namespace glark::core {
namespace {

constexpr std::size_t most_points = 16384;
constexpr std::size_t point_bytes = sizeof(Point);

std::vector<std::byte> read_bytes(const gl::Dispatch& gl, std::size_t offset, std::size_t most) {
  GLint64 size = 0;
  gl.GetBufferParameteri64v(GL_COPY_READ_BUFFER, GL_BUFFER_SIZE, &size);
  const auto end = static_cast<std::size_t>(std::max<GLint64>(size, 0));
  std::vector<std::byte> bytes(offset < end ? std::min(end - offset, most) : 0);
  if (!bytes.empty()) {
    gl.GetBufferSubData(GL_COPY_READ_BUFFER, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes.size()),
                        bytes.data());
  }
  return bytes;
}

std::vector<Point> points_of(std::span<const std::byte> bytes, std::size_t stride) {
  std::vector<Point> points;
  for (std::size_t at = 0; at + point_bytes <= bytes.size() && points.size() < most_points; at += stride) {
    std::memcpy(points.emplace_back().data(), bytes.data() + at, point_bytes);
  }
  return points;
}

}  // namespace

bool has_points(const AttributeSource& source) {
  return source.enabled && source.buffer != 0 && source.type == GL_FLOAT && (source.size == 3 || source.size == 4);
}

std::vector<Point> read_points(const gl::Dispatch& gl, PendingError& errors, const AttributeSource& source) {
  if (gl.GetBufferSubData == nullptr || gl.GetBufferParameteri64v == nullptr) {
    return {};
  }
  const std::size_t stride = source.stride != 0 ? static_cast<std::size_t>(source.stride)
                                                : static_cast<std::size_t>(source.size) * sizeof(float);
  // Other draws read other parts of the buffer, so the first vertex is that of the whole buffer.
  const std::size_t offset = (static_cast<std::size_t>(source.offset) + source.relative_offset) % stride;
  ErrorScope scope(errors);
  GLint previous = 0;
  gl.GetIntegerv(GL_COPY_READ_BUFFER_BINDING, &previous);
  gl.BindBuffer(GL_COPY_READ_BUFFER, source.buffer);
  const std::vector<std::byte> bytes = read_bytes(gl, offset, most_points * stride);
  gl.BindBuffer(GL_COPY_READ_BUFFER, static_cast<GLuint>(previous));
  return scope.take() == GL_NO_ERROR ? points_of(bytes, stride) : std::vector<Point>{};
}

}  // namespace glark::core
