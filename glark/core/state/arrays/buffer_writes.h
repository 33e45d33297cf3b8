// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Notes that the application, or the GPU for it, writes to buffer objects. Each note is made after the write.
#pragma once

#include "glark/core/state/arrays/array_state.h"
#include "glark/core/state/arrays/buffer_stamps.h"
#include "glark/core/state/stamps.h"

namespace glark::core {

class BufferWrites {
 public:
  BufferWrites(ArrayState& arrays, Stamps& stamps, BufferStamps& buffers)
      : arrays_(arrays), stamps_(stamps), buffers_(buffers) {}

  void to_buffer(GLuint buffer) { buffers_.wrote(buffer, stamps_.next()); }
  void to_target(GLenum target) {
    const BoundBuffer* bound = arrays_.bound_buffers().at(target);
    bound != nullptr && bound->known ? to_buffer(bound->name) : to_asked(target);
  }
  void to_pack_buffer() { to_target(GL_PIXEL_PACK_BUFFER); }
  void by_gpu() { buffers_.gpu_wrote(stamps_.next()); }
  void gpu_may_write(GLuint buffer) { buffers_.gpu_may_write(buffer); }
  void never_trust_buffer(GLuint buffer) { buffers_.never_trust(buffer); }
  void never_trust_target(GLenum target) { buffers_.never_trust(arrays_.bound_buffer(target).name); }
  void deleted(GLuint buffer) { buffers_.deleted(buffer, stamps_.next()); }

 private:
  // To the buffer that GL says is bound; to any buffer if GL cannot be asked.
  // Not inline: the wrappers of frequent functions stay short.
  void to_asked(GLenum target);

  ArrayState& arrays_;
  Stamps& stamps_;
  BufferStamps& buffers_;
};

}  // namespace glark::core
