// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Lets shaders read the words of buffers as texels. On llvmpipe, a load from a storage block takes each lane on its own
// and costs two to three times as much as texelFetch (Mesa 22.3).
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "glark/gl/dispatch.h"

namespace glark::core {

class BufferTexels {
 public:
  // The first texture unit. OpenGL 4.3 and ES 3.2 guarantee 96 of them, glslang expects 80. Programs begin at the other end.
  static constexpr GLuint first_unit = 78;
  static constexpr std::size_t most_ranges = 2;
  static constexpr std::int64_t alignment = 256;  // the most that GL_TEXTURE_BUFFER_OFFSET_ALIGNMENT may be

  // In bytes.
  struct Range {
    GLuint buffer = 0;
    std::int64_t offset = 0;  // a multiple of 4
    std::int64_t size = 0;
    GLenum format = GL_R32UI;
    bool operator==(const Range&) const = default;
  };

  explicit BufferTexels(const gl::Dispatch& gl) : gl_(gl) {}

  // Returns whether a range of this size can be read word by word.
  bool can_read(std::int64_t bytes) const;
  // Range i is read through a usamplerBuffer of unit first_unit + i. Its first word is word first_word() there. unbind() gives the
  // application its textures back.
  void bind(std::span<const Range> ranges);
  static GLint first_word(const Range& range) { return static_cast<GLint>(range.offset % alignment / 4); }
  void unbind();
  void release();

 private:
  struct Texture {
    GLuint name = 0;
    Range range;
    GLint of_application = 0;
  };
  void set_range(Texture& texture, const Range& range) const;

  const gl::Dispatch& gl_;
  std::array<Texture, most_ranges> textures_;
  std::size_t bound_ = 0;
  std::uint32_t deletions_ = 0;  // of buffers, when the ranges were set
  mutable GLint most_texels_ = 0;
};

}  // namespace glark::core
