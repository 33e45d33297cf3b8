// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/plan/programs/compile_choice.h"

namespace glark::core {

CompilePace compile_pace(const ContextOptions& options, const ArkState& ark, bool has_shown_frame) {
  const bool may_wait = options.transparent && !options.wait && !ark.enabled;
  return may_wait && (options.smooth || has_shown_frame) ? CompilePace::spread : CompilePace::at_once;
}

}  // namespace glark::core
