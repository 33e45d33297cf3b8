// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The current attribute values (glColor, glNormal, glVertexAttrib ...). The call that set a value represents it: the
// same call with the same arguments gives the same value. When an unseen call may have changed values, a new era
// begins, and older values are unknown.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>

#include "glark/core/state/arrays/attribute_slots.h"
#include "glark/gl/dispatch.h"

namespace glark::core {

struct CurrentValue {
  // Makes the call again; also identifies the call. Null: no call that we saw has set the value.
  using Again = void (*)(const gl::Dispatch& gl, GLuint index, const void* components);
  static constexpr std::size_t most_bytes = 32;  // four doubles

  Again again = nullptr;
  GLuint index = 0;  // first argument of glVertexAttrib and glMultiTexCoord
  std::uint32_t bytes = 0;
  std::uint64_t era = 0;
  alignas(8) std::array<unsigned char, most_bytes> components{};
};

// The same call with the same arguments.
inline bool is_same_call(const CurrentValue& a, const CurrentValue& b) {
  return a.again == b.again && a.index == b.index && a.bytes == b.bytes &&
         std::memcmp(a.components.data(), b.components.data(), a.bytes) == 0;
}

// CurrentValue::Again of glDepthTag1i.
inline void set_tag(const gl::Dispatch& gl, GLuint attribute, const void* tag) {
  GLuint d = 0;
  std::memcpy(&d, tag, sizeof(d));
  gl.VertexAttrib4f(attribute, static_cast<GLfloat>(d), 0.0F, 0.0F, 1.0F);
}

class CurrentValues {
 public:
  void set(int slot, CurrentValue::Again again, GLuint index, const void* components, std::uint32_t bytes) {
    CurrentValue& value = values_[static_cast<std::size_t>(slot)];
    value.again = again;
    value.index = index;
    value.bytes = bytes;
    value.era = era_;
    std::memcpy(value.components.data(), components, bytes);
  }
  void set(int slot, const CurrentValue& value) {
    set(slot, value.again, value.index, value.components.data(), value.bytes);
  }
  // Something may have changed all values. `era`: a number that never comes again.
  void forget(std::uint64_t era) { era_ = era; }
  const CurrentValue* find(int slot) const {
    const CurrentValue& value = values_[static_cast<std::size_t>(slot)];
    return value.again != nullptr && value.era == era_ ? &value : nullptr;
  }
  std::uint64_t era() const { return era_; }

 private:
  std::array<CurrentValue, slot_count> values_{};
  std::uint64_t era_ = 0;
};

}  // namespace glark::core
