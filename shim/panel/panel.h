// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The panel over one window of the program: its state, its context and its drawing.
#pragma once

#include <imgui.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "glark/core/context.h"
#include "shim/contexts/contexts.h"
#include "shim/input/input.h"
#include "shim/panel/panel_context.h"
#include "shim/panel/panel_input.h"
#include "shim/panel/panel_view.h"
#include "shim/panel/renderer.h"

namespace glark::shim {

class Panel {
 public:
  Panel() = default;
  ~Panel();
  Panel(const Panel&) = delete;
  Panel& operator=(const Panel&) = delete;

  // Draws the panel over the frame of the current context, which shows `surface`. False: it cannot be drawn here, and
  // is closed.
  bool draw(core::Context& context, const Surface& surface);
  // The panel is closed: draws are no longer watched.
  void closed();

  void add(const InputEvent& event) { input_.add(event); }
  // What the panel takes of the input, after draw().
  InputShare share(bool keyboard) const;

 private:
  bool prepare(const Surface& surface);
  void start_imgui();
  void fill_model(const core::Context& context);
  void take_pick();
  void follow(const PanelAnswer& answer, Size size);
  void write();
  void change(const core::ContextOptions& wanted);

  ImGuiContext* imgui_ = nullptr;
  std::uint64_t program_context_ = 0;  // number of the context that ours was made for
  std::unique_ptr<PanelContext> context_;
  std::unique_ptr<PanelRenderer> renderer_;
  PanelInput input_;
  PanelModel model_;
  Area area_;
  Size size_;
  bool wants_close_ = false;
  std::optional<core::ContextOptions> before_;  // as the configuration file has them
  int frames_to_pick_ = 0;                      // until the draws of the chosen pixel are known
};

}  // namespace glark::shim
