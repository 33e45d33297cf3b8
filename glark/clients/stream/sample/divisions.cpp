// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/sample/divisions.h"

#include <algorithm>
#include <bit>

namespace glark::stream {
namespace {

// Errors of one class begin with the same bits. For positive floats, the order of the bits is the order of the numbers.
constexpr unsigned class_shift = 13;  // steps of 2^-10
constexpr std::size_t classes = std::size_t{1} << (31 - class_shift);
std::size_t class_of(float error) { return (std::bit_cast<std::uint32_t>(error) & 0x7FFFFFFFU) >> class_shift; }

float greatest_of_class(std::size_t error_class) {
  return std::bit_cast<float>(static_cast<std::uint32_t>(((error_class + 1) << class_shift) - 1));
}

}  // namespace

Divisions::Divisions() : more_(classes) {}

void Divisions::add(float error, std::uint32_t more) { more_[class_of(error)] += more; }

Cut Divisions::cut_for(std::uint64_t target) const {
  std::uint64_t count = 1;
  std::size_t last = classes;
  while (last > 0 && count + more_[last - 1] <= target) count += more_[--last];
  if (last == 0) return {-1, -1, 0};
  return {greatest_of_class(last - 1), last == 1 ? -1 : greatest_of_class(last - 2), target - std::min(target, count)};
}

}  // namespace glark::stream
