// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/state/draw_state.h"

namespace glark::core {

DrawState read_draw_state(const Environment& environment, const Program* program) {
  const Bindings& b = environment.bindings();
  const bool color = environment.state.framebuffers().bound_has_colors(environment.gl, environment.errors);
  DrawState state;
  state.program = program != nullptr ? program->hash : 0;
  state.fixed_function = program != nullptr && program->fixed_function;
  state.depth_test = b.depth_test;
  state.depth_writes = b.depth_test && b.depth_writes;
  state.depth_function = b.depth_function;
  state.blend = b.blend;
  state.color_writes = b.color_writes;
  state.depth_only = !b.color_writes || !color;
  state.viewport = {static_cast<unsigned>(b.viewport[0]), static_cast<unsigned>(b.viewport[1])};
  return state;
}

}  // namespace glark::core
