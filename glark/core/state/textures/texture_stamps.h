// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// When each texture of a share group was last written. Stamps are made from the first draw on that asks for them. Any
// thread may call these functions.
#pragma once

#include <atomic>
#include <cstdint>

#include "glark/core/state/arrays/buffer_stamps.h"

namespace glark::core {

class TextureStamps {
 public:
  using State = BufferStamps::State;

  // Stamps are needed from now on.
  void watch() {
    if (!watched()) {
      watched_.store(true, std::memory_order_relaxed);
    }
  }
  bool watched() const { return watched_.load(std::memory_order_relaxed); }

  void wrote(GLuint texture, std::uint64_t stamp) { objects_.wrote(texture, stamp); }
  void wrote_any(std::uint64_t stamp) { objects_.wrote_any(stamp); }
  // Draws, shaders or other interfaces may write the texture, without a call that says so.
  void never_trust(GLuint texture) { objects_.never_trust(texture); }
  void never_trust_any() { distrusted_.store(true, std::memory_order_relaxed); }

  // Equal states mean that neither the texture nor a sampler was changed in between.
  State state(GLuint texture) const { return objects_.state(texture); }
  bool trusted(GLuint texture) const {
    return !distrusted_.load(std::memory_order_relaxed) && objects_.trusted(texture);
  }

 private:
  BufferStamps objects_;
  std::atomic<bool> watched_{false};
  std::atomic<bool> distrusted_{false};
};

}  // namespace glark::core
