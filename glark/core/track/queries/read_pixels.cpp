// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Hooks of glReadPixels: it writes to the pack buffer, and ends the frame of a program that shows its pictures nowhere.
#include "glark/core/track/track.h"

namespace glark::core {
namespace {

void pixels_read(Context& c) {
  c.writes().to_pack_buffer();
  if (c.stages() != nullptr) {
    c.stages()->pixels_read();
  }
}

}  // namespace

namespace hook {

void ReadPixels(Context& c, GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type, void* pixels) {
  c.gl().ReadPixels(x, y, width, height, format, type, pixels);
  pixels_read(c);
}

void ReadnPixels(Context& c, GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type, GLsizei size,
                 void* pixels) {
  c.gl().ReadnPixels(x, y, width, height, format, type, size, pixels);
  pixels_read(c);
}

}  // namespace hook
}  // namespace glark::core
