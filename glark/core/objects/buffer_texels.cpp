// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/objects/buffer_texels.h"

#include "glark/core/objects/gpu_buffer.h"

namespace glark::core {
namespace {

GLint integer(const gl::Dispatch& gl, GLenum name) {
  GLint value = 0;
  gl.GetIntegerv(name, &value);
  return value;
}

}  // namespace

bool BufferTexels::can_read(std::int64_t bytes) const {
  if (most_texels_ == 0) {
    most_texels_ = integer(gl_, GL_MAX_TEXTURE_BUFFER_SIZE);
  }
  return bytes + alignment <= std::int64_t{4} * most_texels_;
}

void BufferTexels::bind(std::span<const Range> ranges) {
  const auto active = static_cast<GLenum>(integer(gl_, GL_ACTIVE_TEXTURE));
  if (deletions_ != GpuBuffer::deletions()) {
    deletions_ = GpuBuffer::deletions();
    for (Texture& texture : textures_) {
      texture.range = {};
    }
  }
  for (bound_ = 0; bound_ < ranges.size(); ++bound_) {
    Texture& texture = textures_.at(bound_);
    gl_.ActiveTexture(GL_TEXTURE0 + first_unit + static_cast<GLenum>(bound_));
    texture.of_application = integer(gl_, GL_TEXTURE_BINDING_BUFFER);
    if (texture.name == 0) {
      gl_.GenTextures(1, &texture.name);
    }
    gl_.BindTexture(GL_TEXTURE_BUFFER, texture.name);
    set_range(texture, ranges[bound_]);
  }
  gl_.ActiveTexture(active);
}

// The texture is bound to the active unit.
void BufferTexels::set_range(Texture& texture, const Range& range) const {
  const std::int64_t begin = range.offset / alignment * alignment;
  const Range wanted{range.buffer, begin, range.offset - begin + range.size, range.format};
  if (texture.range == wanted) {
    return;
  }
  gl_.TexBufferRange(GL_TEXTURE_BUFFER, wanted.format, wanted.buffer, static_cast<GLintptr>(wanted.offset),
                     static_cast<GLsizeiptr>(wanted.size));
  texture.range = wanted;
}

void BufferTexels::unbind() {
  const auto active = static_cast<GLenum>(integer(gl_, GL_ACTIVE_TEXTURE));
  for (std::size_t i = 0; i < bound_; ++i) {
    gl_.ActiveTexture(GL_TEXTURE0 + first_unit + static_cast<GLenum>(i));
    gl_.BindTexture(GL_TEXTURE_BUFFER, static_cast<GLuint>(textures_.at(i).of_application));
  }
  gl_.ActiveTexture(active);
  bound_ = 0;
}

void BufferTexels::release() {
  for (Texture& texture : textures_) {
    gl_.DeleteTextures(1, &texture.name);
    texture = {};
  }
}

}  // namespace glark::core
