// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A checksum that is the same in every run. Source: G. Fowler, L. Noll, K.-P. Vo, FNV-1a of 64 bits (RFC 9923).
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace glark::common {

inline constexpr std::uint64_t fnv_of_nothing = 0xCBF29CE484222325;

inline std::uint64_t add_to_fnv(std::uint64_t sum, std::string_view bytes) {
  for (const char byte : bytes) sum = (sum ^ static_cast<unsigned char>(byte)) * 0x100000001B3;
  return sum;
}

// Adds the number of values, and their bytes. They have no bytes that mean nothing.
template <class Value>
std::uint64_t add_array_to_fnv(std::uint64_t sum, std::span<const Value> values) {
  const std::uint64_t count = values.size();
  sum = add_to_fnv(sum, {reinterpret_cast<const char*>(&count), sizeof(count)});
  return add_to_fnv(sum, {reinterpret_cast<const char*>(values.data()), values.size_bytes()});
}

}  // namespace glark::common
