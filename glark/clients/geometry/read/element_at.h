// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace glark::geometry {

// The element that a glTF file names by its number; null for a number that no element has.
template <class Value>
const Value* element_at(const std::vector<Value>& values, int index) {
  return index >= 0 && static_cast<std::size_t>(index) < values.size() ? &values[static_cast<std::size_t>(index)]
                                                                       : nullptr;
}

}  // namespace glark::geometry
