// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace glark::common {

// A hash that gives different numbers different values.
// Source: C. Wellons, Prospecting for Hash Functions, 2018 (lowbias32).
inline std::uint32_t mixed_bits(std::uint32_t bits) {
  bits = (bits ^ bits >> 16) * 0x7FEB352DU;
  bits = (bits ^ bits >> 15) * 0x846CA68BU;
  return bits ^ bits >> 16;
}

}  // namespace glark::common
