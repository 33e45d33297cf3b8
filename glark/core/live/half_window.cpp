// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/live/half_window.h"

#include <algorithm>

namespace glark::core {
namespace {

// glScissor sets the boxes of all viewports, so the indexed functions are used where they exist.
void set_box(const gl::Dispatch& gl, const Box& box) {
  if (gl.ScissorIndexed != nullptr) {
    gl.ScissorIndexed(0, box[0], box[1], box[2], box[3]);
  } else {
    gl.Scissor(box[0], box[1], box[2], box[3]);
  }
}

void enable_test(const gl::Dispatch& gl, bool on) {
  if (gl.ScissorIndexed != nullptr) {
    on ? gl.Enablei(GL_SCISSOR_TEST, 0) : gl.Disablei(GL_SCISSOR_TEST, 0);
  } else {
    on ? gl.Enable(GL_SCISSOR_TEST) : gl.Disable(GL_SCISSOR_TEST);
  }
}

}  // namespace

Box left_of(const Box& box, GLint middle) { return {box[0], box[1], std::clamp(middle - box[0], 0, box[2]), box[3]}; }

Box right_of(const Box& box, GLint middle) {
  const GLint first = std::clamp(middle, box[0], box[0] + box[2]);
  return {first, box[1], box[0] + box[2] - first, box[3]};
}

HalfWindow::HalfWindow(const Environment& environment, bool on) : env_(environment), on_(on) {
  if (!on_) {
    return;
  }
  const LiveView& view = env_.options.live;
  middle_ = static_cast<GLint>(view.window[0] / 2);
  enabled_ = env_.gl.IsEnabled(GL_SCISSOR_TEST) != GL_FALSE;
  env_.gl.GetIntegerv(GL_SCISSOR_BOX, scissor_.data());
  limits_ = enabled_ ? scissor_ : Box{0, 0, static_cast<GLint>(view.window[0]), static_cast<GLint>(view.window[1])};
}

HalfWindow::~HalfWindow() {
  if (!on_) {
    return;
  }
  set_box(env_.gl, scissor_);
  enable_test(env_.gl, enabled_);
}

bool HalfWindow::splits(const Environment& environment) {
  const LiveView& view = environment.options.live;
  const std::array<float, 2>& viewport = environment.bindings().viewport;
  return view.split &&
         (environment.state.framebuffers().bound_name() == 0 ||
          (viewport[0] == static_cast<float>(view.window[0]) && viewport[1] == static_cast<float>(view.window[1])));
}

void HalfWindow::select(const Box& box) const {
  set_box(env_.gl, box);
  enable_test(env_.gl, true);
}

}  // namespace glark::core
