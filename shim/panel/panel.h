// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The panel over one window of the program: its state, its context and its drawing.
#pragma once

#include <imgui.h>

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>

#include "glark/core/context.h"
#include "shim/contexts/contexts.h"
#include "shim/input/input.h"
#include "shim/panel/panel_context.h"
#include "shim/panel/view/panel_input.h"
#include "shim/panel/view/panel_view.h"
#include "shim/panel/view/renderer.h"

namespace glark::shim {

class Panel {
 public:
  // Draws the panel over the frame of the current context, which shows `surface`. False: it cannot be drawn here, or the
  // user closes it. Throws std::exception if it cannot be drawn any more.
  bool draw(core::Context& context, const Surface& surface);
  // The panel is closed: draws are no longer watched.
  void closed();

  void add(const InputEvent& event) { input_.add(event); }
  // What the panel takes of the input, after draw().
  InputShare share(bool keyboard) const;

 private:
  // Our context beside one of the program's. Nobody tells us when the program closes the display, so it is kept.
  struct Drawer {
    std::unique_ptr<PanelContext> context;
    std::unique_ptr<PanelRenderer> renderer;  // null: the panel cannot be drawn there
  };
  static constexpr std::size_t most_drawers = 32;

  static constexpr int settled_frames = 3;
  static constexpr std::chrono::milliseconds figures_interval{200};
  // When the panel is built again. In between, its last picture is drawn.
  struct Pace {
    using Clock = std::chrono::steady_clock;
    Clock::time_point last = {};       // when it was built
    std::uint64_t generation = 0;      // of the settings that it shows
    Size size;                         // of the window
    int frames_left = settled_frames;  // to be built without delay: Dear ImGui needs some to settle
    bool held = false;                 // a button is down, or a text is typed
  };

  void start_imgui();
  bool is_due();
  void build(PanelAnswer& answer);
  Drawer* drawer_for(const Surface& surface);
  bool draw_imgui(const Surface& surface, bool due, PanelAnswer& answer);
  void fill_model(const core::Context& context);
  void take_pick();
  void follow(const PanelAnswer& answer);
  void write();
  void change(const core::ContextOptions& wanted);

  ImGuiContext* imgui_ = nullptr;            // never destroyed, as the panel
  std::map<std::uint64_t, Drawer> drawers_;  // by the number of the program's context
  PanelInput input_;
  PanelModel model_;
  Area area_;
  Size size_;
  Pace pace_;
  bool wants_close_ = false;
  std::optional<core::ContextOptions> before_;  // as the configuration file has them
  int frames_to_pick_ = 0;                      // until the draws of the chosen pixel are known
};

}  // namespace glark::shim
