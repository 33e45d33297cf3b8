// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "glark/core/capture/record.h"

namespace glark::core {

// Returns which inputs are the same at all corners of a triangle, because each of their locations has a divisor: bit i
// stands for the input at location i. `has_divisor`: whether the array at a location is
// enabled and has a divisor. No GL.
std::uint32_t instanced_inputs(std::span<const capture::Field> fields, const std::function<bool(int)>& has_divisor);

}  // namespace glark::core
