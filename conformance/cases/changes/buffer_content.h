// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What the changes of buffers write.
#pragma once

#include <cstring>

#include "conformance/changes/changed_draw.h"

namespace glark::conformance {

// Another buffer with the other colours, bound to the target.
inline GLuint source_of(Scene& s, GLenum target) {
  s.made.push_back(make_buffer(target, s.new_colours().data(), static_cast<std::size_t>(s.all_colour_bytes())));
  return s.made.back();
}

inline constexpr std::uint32_t one_colour = 0xff30c0f0;

// Writes the other colours to the mapped buffer.
inline void write_mapped(Scene& s, void* mapped) {
  if (mapped == nullptr) return;  // the change then does not show, which is a failure
  std::memcpy(mapped, s.new_colours().data(), static_cast<std::size_t>(s.colour_bytes()));
}

}  // namespace glark::conformance
