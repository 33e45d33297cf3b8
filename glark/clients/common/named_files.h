// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Temporary files that have a name for a while. A program that a signal ends can remove them first.
#pragma once

#include <unistd.h>

#include <array>
#include <atomic>
#include <cstring>
#include <string>

namespace glark::common {

class NamedFiles {
 public:
  // Notes a file. Several threads may call it. A name that is too long is not noted, nor is one beyond the sixteenth.
  static void add(const std::string& path) {
    if (path.size() >= longest) return;
    for (Slot& slot : slots()) {
      State is_free = State::free;
      if (!slot.state.compare_exchange_strong(is_free, State::changing)) continue;
      std::memcpy(slot.path.data(), path.c_str(), path.size() + 1);
      slot.state = State::used;
      return;
    }
  }
  // The file is gone, or has its final name.
  static void remove(const std::string& path) {
    for (Slot& slot : slots()) {
      State used = State::used;
      if (slot.state == State::used && path == slot.path.data()) slot.state.compare_exchange_strong(used, State::free);
    }
  }
  // Removes all files that are noted. A signal handler may call it.
  static void unlink_all() {
    for (const Slot& slot : slots())
      if (slot.state == State::used) unlink(slot.path.data());
  }

 private:
  static constexpr std::size_t longest = 4096, most = 16;
  enum class State { free, changing, used };
  struct Slot {
    std::atomic<State> state = State::free;
    std::array<char, longest> path{};
  };
  static_assert(std::atomic<State>::is_always_lock_free);
  static std::array<Slot, most>& slots() {
    static constinit std::array<Slot, most> all{};
    return all;
  }
};

}  // namespace glark::common
