// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Calls of the application that go straight to GL, and what they change: state of the context, or of the display list
// that is being compiled.
#pragma once

#include <cstdint>

#include "glark/core/state/gl_state.h"

namespace glark::core {

class StateChanges {
 public:
  explicit StateChanges(GlState& state) : state_(state) {}

  // The call `again` sets a current attribute value.
  void set_current(int slot, CurrentValue::Again again, GLuint index, const void* components, std::uint32_t bytes) {
    if (state_.lists().compiling()) {
      record_current(slot, {again, index, bytes}, components);
    } else if (slot >= 0) {
      state_.arrays().current_values().set(slot, again, index, components, bytes);
    }
  }
  // A call sets current values in a way that is not followed.
  void forget_values() {
    forget_in_list();
    if (!state_.lists().compiling()) {
      state_.arrays().forget_current_values();
    }
  }
  // A call sets state that a list may set between glBegin and glEnd, and that is not followed.
  void forget_in_list() {
    if (state_.lists().compiling()) {
      state_.lists().effects().record_unknown(state_.immediate().before_vertices());
    }
  }
  void touch_fixed_function() {
    state_.fixed_function().touch();
    state_.lists().effects().touches_state = true;
  }
  void touch_matrices() {
    state_.fixed_function().matrices().touch(state_.bindings().matrix_mode);
    state_.lists().effects().touches_state = true;
  }
  void touch_assembly() {
    state_.programs().assembly().forget();
    state_.lists().effects().touches_state = true;
  }
  void touch_any_matrix() {
    state_.fixed_function().matrices().touch_all();
    state_.lists().effects().touches_state = true;
  }

 private:
  void record_current(int slot, CurrentValue value, const void* components);

  GlState& state_;
};

}  // namespace glark::core
