// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "glark/core/draw_rule.h"

namespace glark::core {

// Returns the first rule that the draw matches, or null. No GL.
const DrawRule* find_rule(std::span<const DrawRule> rules, const DrawState& state);

}  // namespace glark::core
