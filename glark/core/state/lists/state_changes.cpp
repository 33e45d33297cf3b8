// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/state/lists/state_changes.h"

#include <cstring>

namespace glark::core {

void StateChanges::record_current(int slot, CurrentValue value, const void* components) {
  std::memcpy(value.components.data(), components, value.bytes);
  state_.lists().effects().record(slot, value, state_.immediate().before_vertices());
}

}  // namespace glark::core
