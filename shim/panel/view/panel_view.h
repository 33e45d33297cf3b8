// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What the panel shows, and what the user does in it. Calls Dear ImGui only.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "glark/core/context_options.h"
#include "glark/core/live/frame_watch.h"
#include "shim/input/input.h"
#include "shim/report/statistics.h"

namespace glark::shim {

struct PanelModel {
  core::ContextOptions options;  // the user changes them
  FrameFigures figures;
  std::vector<core::WatchedClass> classes;  // draws of the last frame
  std::int64_t kept_bytes = 0;
  std::string title;     // of the window
  std::string file;      // where settings are written
  std::string message;   // of the last attempt to write them; empty: there was none
  bool picking = false;  // the next click chooses a pixel of the window
};

struct PanelAnswer {
  bool options_changed = false;
  bool wants_pick = false;
  bool wants_write = false;
  bool wants_close = false;
  Area area;                                      // of the panel in the window, in pixels
  std::optional<std::array<int, 2>> picked = {};  // a pixel, from the lower left corner of the window
};

// Between ImGui::NewFrame() and ImGui::Render().
PanelAnswer show_panel(PanelModel& model);

}  // namespace glark::shim
