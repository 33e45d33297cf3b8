// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Everything that the capture and the sorted instances of a draw depend on. Draws with equal keys have the same ones,
// unless their buffers were written in between.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "glark/core/keep/client_arrays.h"
#include "glark/core/state/arrays/buffer_stamps.h"
#include "glark/core/state/arrays/current_values.h"
#include "glark/core/state/arrays/vertex_arrays.h"

namespace glark::core {

class DrawKey {
 public:
  void clear() {
    words_.clear();
    buffers_.clear();
  }
  void add(std::uint64_t word) { words_.push_back(word); }
  void add(std::uint64_t low, std::uint64_t high) { words_.push_back(low | high << 32); }
  // False: the array is in client memory, which may change unseen.
  bool add_source(int slot, const AttributeSource& source) {
    add_format(slot, source, 0x400U);
    add(source.relative_offset);
    add(static_cast<std::uint64_t>(source.offset));
    return add_buffer(source.buffer, source.generation);
  }
  // An array in client memory, by the hash of what the draw reads of it.
  void add_content(int slot, const AttributeSource& source, const ContentHash& content) {
    add_format(slot, source, 0x2000U);
    add_content(content);
  }
  void add_content(const ContentHash& content) {
    add(content.low);
    add(content.high);
  }
  bool add_buffer(GLuint buffer, std::uint64_t generation) {
    add(buffer);
    add(generation);
    if (std::find(buffers_.begin(), buffers_.end(), buffer) == buffers_.end()) {
      buffers_.push_back(buffer);
    }
    return buffer != 0;
  }
  void add_value(int slot, const CurrentValues& values) {
    const CurrentValue* value = values.find(slot);
    if (value == nullptr) {
      add(static_cast<std::uint64_t>(slot) | 0x800U);
      add(values.era());
      return;
    }
    add(static_cast<std::uint64_t>(slot) | 0x1000U, value->index);
    add(reinterpret_cast<std::uint64_t>(value->again));
    for (std::uint32_t at = 0; at < value->bytes; at += 8) {
      std::uint64_t word = 0;
      std::memcpy(&word, value->components.data() + at, std::min<std::size_t>(8, value->bytes - at));
      add(word);
    }
  }

  std::span<const std::uint64_t> words() const { return words_; }
  std::span<const GLuint> buffers() const { return buffers_; }

 private:
  void add_format(int slot, const AttributeSource& source, std::uint64_t kind) {
    add(static_cast<std::uint64_t>(slot) | (source.normalized ? 0x100U : 0U) | (source.integer ? 0x200U : 0U) | kind,
        source.type);
    add(static_cast<std::uint32_t>(source.size), source.divisor);
    add(static_cast<std::uint32_t>(source.stride));
  }

  std::vector<std::uint64_t> words_;
  std::vector<GLuint> buffers_;  // buffers that the draw reads
};

}  // namespace glark::core
