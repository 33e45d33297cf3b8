// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The application's GL state in one context. The hooks (glark/core/track) keep it up to date; what they cannot follow
// is marked as stale and read again from GL when it is needed.
#pragma once

#include "glark/core/objects/error_scope.h"
#include "glark/core/objects/quiet.h"
#include "glark/core/state/arrays/array_state.h"
#include "glark/core/state/bindings.h"
#include "glark/core/state/capabilities.h"
#include "glark/core/state/conditional_rendering.h"
#include "glark/core/state/fixed_function/fixed_function_changes.h"
#include "glark/core/state/framebuffers.h"
#include "glark/core/state/immediate_mode.h"
#include "glark/core/state/lists/list_compilation.h"
#include "glark/core/state/programs/programs.h"
#include "glark/core/state/query_surplus.h"
#include "glark/core/state/share_group.h"
#include "glark/core/state/stamps.h"
#include "glark/core/state/textures/texture_bindings.h"
#include "glark/gl/dispatch.h"

namespace glark::core {

class GlState {
 public:
  GlState(const gl::Dispatch& gl, const Capabilities& capabilities, ShareGroup& share, PendingError& pending,
          ProgramWatcher& watcher);

  Bindings& bindings() { return bindings_; }
  const Bindings& bindings() const { return bindings_; }
  // A call that the hooks cannot follow (a display list, glPopAttrib) may have changed the bindings.
  void forget_bindings() { bindings_.stale = true; }
  // Reads the bindings again if they are stale.
  void refresh() {
    if (bindings_.stale) {
      read();
    }
  }
  // Everything may have changed unseen.
  void forget();
  // Switches debug output off for the time of our own GL calls.
  Quiet quiet();

  ArrayState& arrays() { return arrays_; }
  const ArrayState& arrays() const { return arrays_; }
  // Another framebuffer is bound, or attachments of framebuffers have changed.
  void framebuffer_bound(GLuint framebuffer) {
    framebuffers_.bind(framebuffer);
    bindings_.stale |= bindings_.clamps_by_framebuffer;
  }
  void attachments_changed() {
    framebuffers_.forget_attachments();
    bindings_.stale |= bindings_.clamps_by_framebuffer;
  }
  Framebuffers& framebuffers() { return framebuffers_; }
  TextureBindings& textures() { return textures_; }
  FixedFunctionChanges& fixed_function() { return fixed_function_; }
  Programs& programs() { return programs_; }
  const Programs& programs() const { return programs_; }

  // Calls that a display list may take instead of the context.
  ListCompilation& lists() { return lists_; }
  const ListCompilation& lists() const { return lists_; }
  ImmediateMode& immediate() { return immediate_; }
  const ImmediateMode& immediate() const { return immediate_; }
  QuerySurplus& query_surplus() { return query_surplus_; }
  ConditionalRendering& conditional_rendering() { return conditional_rendering_; }
  Stamps& stamps() { return stamps_; }

 private:
  void read();

  const gl::Dispatch& gl_;
  const Capabilities& capabilities_;
  Stamps stamps_;
  Bindings bindings_;
  ImmediateMode immediate_;
  ArrayState arrays_;
  Framebuffers framebuffers_;
  TextureBindings textures_;
  FixedFunctionChanges fixed_function_;
  Programs programs_;
  ListCompilation lists_;
  QuerySurplus query_surplus_;
  ConditionalRendering conditional_rendering_;
};

}  // namespace glark::core
