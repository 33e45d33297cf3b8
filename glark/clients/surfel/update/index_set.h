// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

namespace glark::surfel {

// A set of numbers in the order in which they were added.
class IndexSet {
 public:
  void add(std::uint32_t number) {
    if (number >= flags_.size()) flags_.resize(number + 1, 0);
    if (flags_[number] != 0) return;
    flags_[number] = 1;
    list_.push_back(number);
  }
  bool has(std::uint32_t number) const { return number < flags_.size() && flags_[number] != 0; }
  std::vector<std::uint32_t>& list() { return list_; }
  const std::vector<std::uint32_t>& list() const { return list_; }

 private:
  std::vector<std::uint8_t> flags_;
  std::vector<std::uint32_t> list_;
};

}  // namespace glark::surfel
