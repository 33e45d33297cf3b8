// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A checksum that is the same in every run. Source: G. Fowler, L. Noll, K.-P. Vo, FNV-1a of 64 bits (RFC 9923).
#pragma once

#include <cstdint>
#include <string_view>

namespace glark::common {

inline constexpr std::uint64_t fnv_of_nothing = 0xCBF29CE484222325;

inline std::uint64_t add_to_fnv(std::uint64_t sum, std::string_view bytes) {
  for (const char byte : bytes) sum = (sum ^ static_cast<unsigned char>(byte)) * 0x100000001B3;
  return sum;
}

}  // namespace glark::common
