// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <deque>

#include "shim/input/input.h"

namespace glark::shim {

// Hands events to Dear ImGui. A press and its release in one frame reach it in two frames, so that neither is lost.
class PanelInput {
 public:
  // Makes ImGui's current context follow keys. Once, before the first frame.
  static void start();
  void add(const InputEvent& event) { waiting_.push_back(event); }
  // Before ImGui::NewFrame().
  void feed();
  bool waits() const { return !waiting_.empty(); }
  void clear() { waiting_.clear(); }

 private:
  std::deque<InputEvent> waiting_;
};

}  // namespace glark::shim
