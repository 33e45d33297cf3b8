// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/state/gl_state.h"

namespace glark::core {

GlState::GlState(const gl::Dispatch& gl, const Capabilities& capabilities, ShareGroup& share, PendingError& pending,
                 ProgramWatcher& watcher)
    : gl_(gl),
      capabilities_(capabilities),
      stamps_(share.contexts_made),
      arrays_({gl, capabilities, bindings_, immediate_, share.buffers, stamps_}),
      programs_(gl, capabilities, share, pending, watcher) {}

void GlState::forget() {
  forget_bindings();
  arrays_.vertex_arrays().forget_current();
  framebuffers_ = {};
  textures_.changed();
  fixed_function_.touch();
  lists_.effects().touches_state = true;
}

Quiet GlState::quiet() {
  refresh();
  return {gl_, bindings_.debug_output};
}

void GlState::read() {
  bindings_.stale = false;
  programs_.subroutines().forget();
  read_bindings(gl_, capabilities_, bindings_);
  arrays_.vertex_arrays().bind(bindings_.vertex_array);
  if (capabilities_.is_compatibility()) {
    fixed_function_.matrices().touch_all();
    programs_.assembly().forget();
    lists_.effects().touches_state = true;
  }
  if (programs_.current() == nullptr ? bindings_.program != 0 : programs_.current()->name != bindings_.program) {
    programs_.adopt(bindings_.program);
  }
}

}  // namespace glark::core
