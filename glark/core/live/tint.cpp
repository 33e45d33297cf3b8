// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/live/tint.h"

namespace glark::core {
namespace {

constexpr std::array<GLenum, 4> factor_names{GL_BLEND_SRC_RGB, GL_BLEND_DST_RGB, GL_BLEND_SRC_ALPHA,
                                             GL_BLEND_DST_ALPHA};
constexpr std::array<GLenum, 2> equation_names{GL_BLEND_EQUATION_RGB, GL_BLEND_EQUATION_ALPHA};

}  // namespace

Tint::Tint(const Environment& environment, const DrawGroupText& group)
    : env_(environment), blends_(environment.bindings().blend) {
  blends_ ? set_mask(group.mask) : set_blending(group.color);
}

Tint::~Tint() {
  if (blends_) {
    env_.gl.ColorMaski(0, mask_[0], mask_[1], mask_[2], mask_[3]);
  } else {
    reset_blending();
  }
}

void Tint::set_blending(const std::array<float, 3>& color) {
  const gl::Dispatch& gl = env_.gl;
  gl.GetFloatv(GL_BLEND_COLOR, constant_.data());
  for (std::size_t i = 0; i < factor_names.size(); ++i) {
    gl.GetIntegeri_v(factor_names[i], 0, &factors_[i]);
  }
  for (std::size_t i = 0; i < equation_names.size(); ++i) {
    gl.GetIntegeri_v(equation_names[i], 0, &equations_[i]);
  }
  gl.BlendColor(color[0], color[1], color[2], 1);
  gl.BlendEquationSeparatei(0, GL_FUNC_ADD, GL_FUNC_ADD);
  gl.BlendFuncSeparatei(0, GL_CONSTANT_COLOR, GL_ZERO, GL_ONE, GL_ZERO);
  gl.Enablei(GL_BLEND, 0);
}

void Tint::reset_blending() const {
  const gl::Dispatch& gl = env_.gl;
  gl.Disablei(GL_BLEND, 0);
  gl.BlendFuncSeparatei(0, static_cast<GLenum>(factors_[0]), static_cast<GLenum>(factors_[1]),
                        static_cast<GLenum>(factors_[2]), static_cast<GLenum>(factors_[3]));
  gl.BlendEquationSeparatei(0, static_cast<GLenum>(equations_[0]), static_cast<GLenum>(equations_[1]));
  gl.BlendColor(constant_[0], constant_[1], constant_[2], constant_[3]);
}

void Tint::set_mask(const std::array<bool, 3>& channels) {
  env_.gl.GetBooleani_v(GL_COLOR_WRITEMASK, 0, mask_.data());
  std::array<GLboolean, 3> mask{};
  for (std::size_t i = 0; i < mask.size(); ++i) {
    mask[i] = mask_[i] != GL_FALSE && channels[i] ? GL_TRUE : GL_FALSE;
  }
  env_.gl.ColorMaski(0, mask[0], mask[1], mask[2], mask_[3]);
}

}  // namespace glark::core
