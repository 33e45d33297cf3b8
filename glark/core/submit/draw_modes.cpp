// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/submit/draw_modes.h"

#include <algorithm>
#include <utility>

#include "glark/core/capture/draw_capture.h"

namespace glark::submit {

// Every edge of a refined triangle is a boundary edge. Our vertex arrays have no edge flags, so GL uses the current
// one.
void DrawModes::raise_edge_flag() {
  const bool wireframe = env_.capabilities.is_compatibility() && env_.options.wireframe;
  if (!capture::takes_edge_flags(env_) && !wireframe) {
    return;
  }
  core::CurrentValues& values = env_.state.arrays().current_values();
  const core::CurrentValue* known = values.find(core::edge_flag_slot);
  if (known == nullptr) {
    GLboolean flag = GL_TRUE;
    env_.gl.GetBooleanv(GL_EDGE_FLAG, &flag);
    const auto set = [](const gl::Dispatch& gl, GLuint, const void* components) {
      gl.EdgeFlag(*static_cast<const GLboolean*>(components));
    };
    values.set(core::edge_flag_slot, set, 0, &flag, sizeof(flag));
    known = values.find(core::edge_flag_slot);
  }
  edge_flag_raised_ = std::all_of(known->components.begin(), known->components.begin() + known->bytes,
                                  [](unsigned char part) { return part == 0; });
  if (edge_flag_raised_) {
    env_.gl.EdgeFlag(GL_TRUE);
  }
}

void DrawModes::set_point_size(bool by_program) const {
  by_program ? env_.gl.Enable(GL_PROGRAM_POINT_SIZE) : env_.gl.Disable(GL_PROGRAM_POINT_SIZE);
}

void DrawModes::set(const ModeChanges& changes, const refine::FixedFunctionState& state) {
  raise_edge_flag();
  if (changes.two_side) {
    env_.gl.Enable(GL_VERTEX_PROGRAM_TWO_SIDE);
  }
  if (changes.color_sum) {
    env_.gl.Enable(GL_COLOR_SUM);
  }
  if (changes.point_size) {
    set_point_size(state.point_size);
  }
  if (draws_wireframe()) {
    env_.gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  }
}

void DrawModes::reset_polygon_mode() const {
  const core::Bindings& b = env_.bindings();
  if (env_.capabilities.is_compatibility()) {
    env_.gl.PolygonMode(GL_FRONT, b.polygon_modes.front);
    env_.gl.PolygonMode(GL_BACK, b.polygon_modes.back);
  } else {
    env_.gl.PolygonMode(GL_FRONT_AND_BACK, b.polygon_modes.front);
  }
}

void DrawModes::reset(const ModeChanges& changes, const refine::FixedFunctionState& state) {
  if (std::exchange(edge_flag_raised_, false)) {
    env_.gl.EdgeFlag(GL_FALSE);
  }
  if (draws_wireframe()) {
    reset_polygon_mode();
  }
  if (changes.two_side) {
    env_.gl.Disable(GL_VERTEX_PROGRAM_TWO_SIDE);
  }
  if (changes.color_sum) {
    env_.gl.Disable(GL_COLOR_SUM);
  }
  if (changes.point_size) {
    set_point_size(state.program_point_size);
  }
}

}  // namespace glark::submit
