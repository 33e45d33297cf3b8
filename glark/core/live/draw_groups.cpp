// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/live/draw_groups.h"

namespace glark::core {

DrawGroup group_of(const DrawVerdict& verdict, bool kept) {
  if (!verdict.cause) {
    return kept ? DrawGroup::kept : DrawGroup::refined;
  }
  switch (*verdict.cause) {
    case Cause::mesh_waits:
    case Cause::compiling: return DrawGroup::waits;
    case Cause::no_surface:
    case Cause::mesh_flat:
    case Cause::unknown_partner: return DrawGroup::flat;
    case Cause::screen_quad:
    case Cause::overlay:
    case Cause::orthographic: return DrawGroup::interface;
    case Cause::level_zero:
    case Cause::left_shader:
    case Cause::rule:
    case Cause::blended:
    case Cause::no_depth_test:
    case Cause::no_depth_writes:
    case Cause::budget: return DrawGroup::user;
    default: return DrawGroup::impossible;
  }
}

}  // namespace glark::core
