// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include "glark/core/ark_state.h"
#include "glark/core/objects/error_scope.h"
#include "glark/core/objects/programs/compilation.h"
#include "glark/core/state/capabilities.h"
#include "glark/core/state/gl_state.h"
#include "glark/core/state/share_group.h"
#include "glark/gl/dispatch.h"

namespace glark::core {

// The parts of a context that the stages of a draw may see. They outlive the stages.
struct Environment {
  const gl::Dispatch& gl;  // without functions that the context does not offer
  const Capabilities& capabilities;
  const ContextOptions& options;
  const ArkState& ark;
  GlState& state;
  PendingError& errors;
  ShareGroup& share;
  Compilation& compilation;

  const Bindings& bindings() const { return state.bindings(); }
};

}  // namespace glark::core
