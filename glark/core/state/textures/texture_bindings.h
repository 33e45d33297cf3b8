// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Which texture and which sampler a unit has. GL is asked again only after a call that may have bound others.
#pragma once

#include <cstdint>

#include "glark/gl/dispatch.h"

namespace glark::core {

class TextureBindings {
 public:
  struct Unit {
    GLuint texture = 0;  // of GL_TEXTURE_2D
    GLuint sampler = 0;
  };
  void changed() { ++changes_; }
  Unit at(const gl::Dispatch& gl, GLuint unit) {
    if (read_at_ != changes_ || unit != unit_) {
      read(gl, unit);
    }
    return found_;
  }

 private:
  void read(const gl::Dispatch& gl, GLuint unit);

  std::uint64_t changes_ = 1;
  std::uint64_t read_at_ = 0;
  GLuint unit_ = 0;
  Unit found_;
};

}  // namespace glark::core
