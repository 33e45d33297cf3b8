// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A hash table from keys of cells to numbers.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace glark::reconstruct {

class CellTable {
 public:
  static constexpr std::uint32_t absent = 0xFFFFFFFF;

  explicit CellTable(std::size_t expected = 16)
      : slots_(std::bit_ceil(2 * expected + 16)), shift_(64 - std::countr_zero(slots_.size())) {}

  std::uint32_t find(std::uint64_t key) const {
    for (std::size_t i = start(key);; i = (i + 1) & (slots_.size() - 1)) {
      if (slots_[i].number == absent || slots_[i].key == key) return slots_[i].number;
    }
  }

  // Returns the number of the key. A new key gets `number`.
  std::uint32_t insert(std::uint64_t key, std::uint32_t number) {
    if (2 * (count_ + 1) > slots_.size()) grow();
    for (std::size_t i = start(key);; i = (i + 1) & (slots_.size() - 1)) {
      if (slots_[i].number == absent) {
        slots_[i] = {key, number};
        ++count_;
        return number;
      }
      if (slots_[i].key == key) return slots_[i].number;
    }
  }

 private:
  struct Slot {
    std::uint64_t key = 0;
    std::uint32_t number = absent;
  };

  std::size_t start(std::uint64_t key) const { return static_cast<std::size_t>((key * 0x9E3779B97F4A7C15U) >> shift_); }

  void grow() {
    CellTable larger(2 * slots_.size());
    for (const Slot& slot : slots_) {
      if (slot.number != absent) larger.insert(slot.key, slot.number);
    }
    *this = std::move(larger);
  }

  std::vector<Slot> slots_;
  int shift_;
  std::size_t count_ = 0;
};

}  // namespace glark::reconstruct
