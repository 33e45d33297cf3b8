// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What Dear ImGui drew last, so that a picture of it is painted only if it has changed.
#pragma once

#include <imgui.h>

#include <vector>

#include "shim/input/input.h"

namespace glark::shim {

class KeptLists {
 public:
  // Keeps the lists. Returns whether they differ from the kept ones.
  bool update(const ImDrawData& data);
  // The smallest rectangle that contains all that the lists draw, in pixels; empty if they draw nothing.
  const Area& area() const { return area_; }

 private:
  std::vector<ImDrawVert> vertices_;
  std::vector<ImDrawIdx> indices_;
  std::vector<ImVec4> clips_;
  std::vector<unsigned> counts_;  // of the indices of each command
  Area area_;
};

}  // namespace glark::shim
