// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Notes that the application, or the GPU for it, writes to buffer objects. Each note is made after the write.
#pragma once

#include "glark/core/state/gl_state.h"

namespace glark::core {

class BufferWrites {
 public:
  BufferWrites(GlState& state, BufferStamps& stamps) : state_(state), stamps_(stamps) {}

  void to_buffer(GLuint buffer) { stamps_.wrote(buffer, state_.next_stamp()); }
  void to_target(GLenum target) {
    const BoundBuffer* bound = state_.bound_buffers().at(target);
    bound != nullptr && bound->known ? to_buffer(bound->name) : to_asked(target);
  }
  void to_pack_buffer() { to_target(GL_PIXEL_PACK_BUFFER); }
  void by_gpu() { stamps_.gpu_wrote(state_.next_stamp()); }
  void gpu_may_write(GLuint buffer) { stamps_.gpu_may_write(buffer); }
  void never_trust_buffer(GLuint buffer) { stamps_.never_trust(buffer); }
  void never_trust_target(GLenum target) { stamps_.never_trust(state_.bound_buffer(target).name); }
  void deleted(GLuint buffer) { stamps_.deleted(buffer, state_.next_stamp()); }

 private:
  // To the buffer that GL says is bound; to any buffer if GL cannot be asked.
  void to_asked(GLenum target) {
    const BoundBuffer bound = state_.bound_buffer(target);
    bound.known ? to_buffer(bound.name) : stamps_.wrote_any(state_.next_stamp());
  }

  GlState& state_;
  BufferStamps& stamps_;
};

}  // namespace glark::core
