// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// When each buffer object of a share group was last written. Any thread may call these functions; there are no locks.
// After a write, the writer leaves a new stamp. Before reading the buffer, a reader takes its stamps. Names that differ
// by a multiple of the table's size share a stamp: a write to one counts as a write to the other, too. That costs a
// capture and is never wrong.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

#include "glark/gl/types.h"

namespace glark::core {

class BufferStamps {
 public:
  void wrote(GLuint buffer, std::uint64_t stamp) { at(buffer).stamp.store(stamp, std::memory_order_relaxed); }
  void wrote_any(std::uint64_t stamp) { all_.store(stamp, std::memory_order_relaxed); }
  // Shaders or transform feedback wrote: perhaps to any buffer that was ever bound for that.
  void gpu_wrote(std::uint64_t stamp) { gpu_.store(stamp, std::memory_order_relaxed); }
  void gpu_may_write(GLuint buffer) { set(buffer, gpu_writable); }
  // The buffer can be written unseen by OpenGL: by other interfaces or through GPU addresses.
  void never_trust(GLuint buffer) { set(buffer, untrusted); }
  // The name may be given to another object.
  void deleted(GLuint buffer, std::uint64_t stamp) {
    at(buffer).generation.fetch_add(1, std::memory_order_relaxed);
    wrote(buffer, stamp);
  }

  // Equal states mean that nothing was written to the buffer in between.
  struct State {
    std::uint64_t own = 0;
    std::uint64_t gpu = 0;
    std::uint64_t all = 0;
    bool operator==(const State&) const = default;
  };
  State state(GLuint buffer) const {
    const Entry& entry = at(buffer);
    const bool gpu = (entry.flags.load(std::memory_order_relaxed) & gpu_writable) != 0;
    return {entry.stamp.load(std::memory_order_relaxed), gpu ? gpu_.load(std::memory_order_relaxed) : 0,
            all_.load(std::memory_order_relaxed)};
  }
  bool trusted(GLuint buffer) const { return (at(buffer).flags.load(std::memory_order_relaxed) & untrusted) == 0; }
  // Tells apart objects that have the same name one after the other.
  std::uint64_t generation(GLuint buffer) const { return at(buffer).generation.load(std::memory_order_relaxed); }

 private:
  static constexpr std::size_t table_size = 16384;
  static constexpr std::uint32_t gpu_writable = 1;
  static constexpr std::uint32_t untrusted = 2;
  struct Entry {
    std::atomic<std::uint64_t> stamp{0};
    std::atomic<std::uint32_t> generation{0};
    std::atomic<std::uint32_t> flags{0};
  };

  Entry& at(GLuint buffer) { return table_[buffer % table_size]; }
  const Entry& at(GLuint buffer) const { return table_[buffer % table_size]; }
  void set(GLuint buffer, std::uint32_t flag) {
    Entry& entry = at(buffer);
    if ((entry.flags.load(std::memory_order_relaxed) & flag) == 0) {
      entry.flags.fetch_or(flag, std::memory_order_relaxed);
    }
  }

  std::array<Entry, table_size> table_;
  std::atomic<std::uint64_t> gpu_{0};
  std::atomic<std::uint64_t> all_{0};
};

}  // namespace glark::core
