// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/plan/inputs/instanced_inputs.h"

#include "glark/core/capture/layout.h"

namespace glark::core {

std::uint32_t instanced_inputs(std::span<const capture::Field> fields, const std::function<bool(int)>& has_divisor) {
  constexpr int most_locations = 32;
  std::uint32_t result = 0;
  for (const capture::Field& field : fields) {
    const int end = field.location + capture::columns_of(field.type) * field.array_size;
    bool instanced = field.location >= 0 && end <= most_locations;
    for (int location = field.location; instanced && location < end; ++location) {
      instanced = has_divisor(location);
    }
    result |= instanced ? 1U << static_cast<unsigned>(field.location) : 0U;
  }
  return result;
}

}  // namespace glark::core
