// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/live/pixel_reader.h"

namespace glark::core {
namespace {

// While it lives, glReadPixels reads the draw framebuffer into client memory, tightly packed.
class PixelState {
 public:
  explicit PixelState(const Environment& environment) : gl_(environment.gl) {
    gl_.GetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &framebuffer_);
    gl_.GetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &buffer_);
    for (std::size_t i = 0; i < names.size(); ++i) {
      gl_.GetIntegerv(names[i], &values_[i]);
      gl_.PixelStorei(names[i], 0);
    }
    gl_.GetIntegerv(GL_PACK_ALIGNMENT, &alignment_);
    gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, environment.state.framebuffers().bound_name());
    gl_.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  }
  ~PixelState() {
    gl_.BindBuffer(GL_PIXEL_PACK_BUFFER, static_cast<GLuint>(buffer_));
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(framebuffer_));
    gl_.PixelStorei(GL_PACK_ALIGNMENT, alignment_);
    for (std::size_t i = 0; i < names.size(); ++i) {
      gl_.PixelStorei(names[i], values_[i]);
    }
  }
  PixelState(const PixelState&) = delete;
  PixelState& operator=(const PixelState&) = delete;

 private:
  static constexpr std::array<GLenum, 3> names{GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS};

  const gl::Dispatch& gl_;
  GLint framebuffer_ = 0;
  GLint buffer_ = 0;
  GLint alignment_ = 4;
  std::array<GLint, names.size()> values_{};
};

}  // namespace

PixelValue read_pixel(const Environment& environment, const std::array<int, 2>& pixel) {
  const gl::Dispatch& gl = environment.gl;
  ErrorScope errors(environment.errors);
  const PixelState state(environment);
  PixelValue value;
  gl.ReadPixels(pixel[0], pixel[1], 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, value.color.data());
  if (environment.capabilities.api != Capabilities::Api::es) {  // OpenGL ES reads no depth
    gl.ReadPixels(pixel[0], pixel[1], 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &value.depth);
  }
  return value;
}

}  // namespace glark::core
