// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Numbers that never repeat in a share group: for writes, for list segments, and for other things that a context has to
// tell apart.
#pragma once

#include <atomic>
#include <cstdint>

namespace glark::core {

class Stamps {
 public:
  // `contexts_made` counts the contexts of the share group: each of them has a range of numbers of its own.
  explicit Stamps(std::atomic<std::uint64_t>& contexts_made)
      : last_((contexts_made.fetch_add(1, std::memory_order_relaxed) + 1) << range_bits) {}
  std::uint64_t next() { return ++last_; }

 private:
  static constexpr int range_bits = 40;
  std::uint64_t last_;
};

}  // namespace glark::core
