// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Notes calls that write or bind textures, or change how they are sampled. Each note is made after the call.
#pragma once

#include "glark/core/state/gl_state.h"
#include "glark/core/state/textures/texture_stamps.h"

namespace glark::core {

class TextureWrites {
 public:
  TextureWrites(const gl::Dispatch& gl, GlState& state, TextureStamps& textures)
      : gl_(gl), state_(state), textures_(textures) {}

  void to_texture(GLuint texture) {
    note_list();
    if (textures_.watched()) {
      textures_.wrote(texture, state_.stamps().next());
    }
  }
  // To the texture that is bound to `target` of the active unit.
  void to_target(GLenum target) {
    note_list();
    if (textures_.watched() && target == GL_TEXTURE_2D) {
      to_bound();
    }
  }
  // To a texture or a sampler that the call does not name. Its name may be given to another object.
  void to_any() {
    bound();
    if (textures_.watched()) {
      textures_.wrote_any(state_.stamps().next());
    }
  }
  // Units may have other textures or samplers.
  void bound() {
    note_list();
    state_.textures().changed();
  }
  // The texture is attached to a framebuffer, so draws may write it.
  void attached(GLuint texture) {
    state_.attachments_changed();
    textures_.never_trust(texture);
  }
  void deleted() {
    state_.attachments_changed();
    to_any();
  }
  void never_trust(GLuint texture) { textures_.never_trust(texture); }
  void never_trust_any() { textures_.never_trust_any(); }

 private:
  // A list would repeat the call unseen.
  void note_list() {
    if (state_.lists().compiling()) {
      textures_.never_trust_any();
    }
  }
  void to_bound();

  const gl::Dispatch& gl_;
  GlState& state_;
  TextureStamps& textures_;
};

}  // namespace glark::core
