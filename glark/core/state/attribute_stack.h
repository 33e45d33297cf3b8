// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The stack of glPushAttrib, as far as it saves GL_ARK, which belongs to the group of GL_ENABLE_BIT.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "glark/gl/types.h"

namespace glark::core {

class AttributeStack {
 public:
  // Nothing is pushed onto a stack of `limit` entries: GL refuses that call.
  void push(GLbitfield mask, bool ark_enabled, std::size_t limit) {
    if (entries_.size() < limit) {
      entries_.push_back({(mask & GL_ENABLE_BIT) != 0, (mask & GL_TEXTURE_BIT) != 0, ark_enabled});
    }
  }
  // Returns whether pop() gives textures and their bindings the values of earlier. True also without an entry.
  bool restores_textures() const { return entries_.empty() || entries_.back().has_textures; }
  // The value of GL_ARK to restore, if the entry has saved one.
  std::optional<bool> pop() {
    if (entries_.empty()) {
      return std::nullopt;
    }
    const Entry top = entries_.back();
    entries_.pop_back();
    return top.has_enables ? std::optional(top.ark_enabled) : std::nullopt;
  }

 private:
  struct Entry {
    bool has_enables;
    bool has_textures;
    bool ark_enabled;
  };
  std::vector<Entry> entries_;
};

}  // namespace glark::core
