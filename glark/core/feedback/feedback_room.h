// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// How many vertices the application's transform feedback objects can hold. This bounds draws of their captured
// vertices.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>

#include "glark/core/state/environment.h"

namespace glark::core {

class FeedbackRoom {
 public:
  explicit FeedbackRoom(const Environment& environment) : env_(environment) {}

  // glBeginTransformFeedback: notes the room of the buffers that are bound.
  void note();
  // Returns nothing if glark has not seen the object's glBeginTransformFeedback.
  std::optional<std::uint64_t> vertices(GLuint object) const;

 private:
  GLuint capturing_program() const;

  const Environment& env_;
  std::unordered_map<GLuint, std::uint64_t> vertices_;  // by transform feedback object
};

}  // namespace glark::core
