// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/frames/read_frame.h"

#include <array>
#include <cstddef>

#include "shim/contexts/contexts.h"

namespace glark::shim {
namespace {

// The parameters that control the layout of glReadPixels: name, value while we read, whether OpenGL ES has it.
struct PackParameter {
  GLenum name;
  GLint value;
  bool in_es;
};
constexpr std::array pack_parameters{
    PackParameter{GL_PACK_ALIGNMENT, 4, true},     PackParameter{GL_PACK_ROW_LENGTH, 0, true},
    PackParameter{GL_PACK_SKIP_ROWS, 0, true},     PackParameter{GL_PACK_SKIP_PIXELS, 0, true},
    PackParameter{GL_PACK_SWAP_BYTES, 0, false},   PackParameter{GL_PACK_LSB_FIRST, 0, false},
    PackParameter{GL_PACK_IMAGE_HEIGHT, 0, false}, PackParameter{GL_PACK_SKIP_IMAGES, 0, false},
};

// The pixel transfer of colours, which only the compatibility profile has.
struct TransferParameter {
  GLenum name;
  GLfloat value;
};
constexpr std::array transfer_parameters{
    TransferParameter{GL_MAP_COLOR, 0},  TransferParameter{GL_RED_SCALE, 1},   TransferParameter{GL_GREEN_SCALE, 1},
    TransferParameter{GL_BLUE_SCALE, 1}, TransferParameter{GL_ALPHA_SCALE, 1}, TransferParameter{GL_RED_BIAS, 0},
    TransferParameter{GL_GREEN_BIAS, 0}, TransferParameter{GL_BLUE_BIAS, 0},   TransferParameter{GL_ALPHA_BIAS, 0},
};

// During its lifetime, the state that glReadPixels depends on has the values that we need.
class ReadState {
 public:
  explicit ReadState(core::Context& context)
      : gl_(context.gl()), api_(context.capabilities().api), version_(context.capabilities().version) {
    const bool es = api_ == core::Capabilities::Api::es;
    separate_read_ = version_ >= 30;
    has_read_buffer_ = !es || version_ >= 30;
    if (version_ >= 21) swap_pack_buffer();
    for (std::size_t i = 0; i < pack_parameters.size(); ++i) {
      if (es && (!pack_parameters[i].in_es || (version_ < 30 && i > 0))) continue;
      gl_.GetIntegerv(pack_parameters[i].name, &pack_[i]);
      gl_.PixelStorei(pack_parameters[i].name, pack_parameters[i].value);
    }
    if (context.capabilities().is_compatibility()) save_transfer();
    select_default_framebuffer(es);
  }

  ~ReadState() {
    const bool es = api_ == core::Capabilities::Api::es;
    if (has_read_buffer_) gl_.ReadBuffer(static_cast<GLenum>(read_buffer_));
    if (separate_read_) gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(framebuffer_));
    if (api_ == core::Capabilities::Api::compatibility)
      for (std::size_t i = 0; i < transfer_parameters.size(); ++i)
        gl_.PixelTransferf(transfer_parameters[i].name, transfer_[i]);
    for (std::size_t i = 0; i < pack_parameters.size(); ++i)
      if (!es || (pack_parameters[i].in_es && (version_ >= 30 || i == 0)))
        gl_.PixelStorei(pack_parameters[i].name, pack_[i]);
    if (version_ >= 21) gl_.BindBuffer(GL_PIXEL_PACK_BUFFER, static_cast<GLuint>(pack_buffer_));
  }

  ReadState(const ReadState&) = delete;
  ReadState& operator=(const ReadState&) = delete;

 private:
  void swap_pack_buffer() {
    gl_.GetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &pack_buffer_);
    gl_.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  }

  void save_transfer() {
    for (std::size_t i = 0; i < transfer_parameters.size(); ++i) {
      gl_.GetFloatv(transfer_parameters[i].name, &transfer_[i]);
      gl_.PixelTransferf(transfer_parameters[i].name, transfer_parameters[i].value);
    }
  }

  // A context without a surface has no default framebuffer; there the picture is the framebuffer that the program reads
  // from.
  void select_default_framebuffer(bool es) {
    if (separate_read_) {
      gl_.GetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &framebuffer_);
      if (current_provider() == Provider::osmesa || !current_is_offscreen())
        gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    }
    if (!has_read_buffer_) return;
    gl_.GetIntegerv(GL_READ_BUFFER, &read_buffer_);
    if (current_is_offscreen()) return;
    GLboolean double_buffered = GL_TRUE;
    if (!es) gl_.GetBooleanv(GL_DOUBLEBUFFER, &double_buffered);
    gl_.ReadBuffer(double_buffered ? GL_BACK : GL_FRONT);
  }

  const gl::Dispatch& gl_;
  core::Capabilities::Api api_;
  int version_;
  bool separate_read_ = false;
  bool has_read_buffer_ = false;
  GLint pack_buffer_ = 0;
  GLint framebuffer_ = 0;
  GLint read_buffer_ = GL_BACK;
  std::array<GLint, pack_parameters.size()> pack_{};
  std::array<GLfloat, transfer_parameters.size()> transfer_{};
};

}  // namespace

std::vector<unsigned char> read_frame(core::Context& context, Size size) {
  const auto width = static_cast<std::size_t>(size.width);
  const auto height = static_cast<std::size_t>(size.height);
  std::vector<unsigned char> rgba(width * height * 4);
  {
    const core::ErrorScope errors(context.pending_error());
    const ReadState state(context);
    context.gl().ReadPixels(0, 0, size.width, size.height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  }
  std::vector<unsigned char> rgb;
  rgb.reserve(width * height * 3);
  for (std::size_t y = height; y-- > 0;)
    for (std::size_t x = 0; x < width; ++x) {
      const unsigned char* pixel = &rgba[(y * width + x) * 4];
      rgb.insert(rgb.end(), pixel, pixel + 3);
    }
  return rgb;
}

}  // namespace glark::shim
