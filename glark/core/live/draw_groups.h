// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The groups of decisions that false colours tell apart, one row each.
#pragma once

#include <array>
#include <string_view>

#include "glark/core/report/draw_classes.h"

namespace glark::core {

enum class DrawGroup {
  refined,    // refined in this frame
  kept,       // refined in an earlier frame
  waits,      // refined as soon as its programs are compiled and its mesh is known
  flat,       // smooth refinement: nothing curves this mesh
  interface,  // user interfaces and full-screen passes
  user,       // the user's settings and rules
  impossible  // everything else
};

struct DrawGroupText {
  std::string_view name;
  std::array<float, 3> color;  // the draw's colours are multiplied by it
  std::array<bool, 3> mask;    // a blended draw changes these channels only
};

// In the order of DrawGroup.
inline constexpr std::array<DrawGroupText, 7> draw_groups{{
    {"refined", {0.35F, 1.0F, 0.35F}, {false, true, false}},
    {"refined earlier and kept", {0.3F, 0.8F, 1.0F}, {false, true, true}},
    {"waits", {1.0F, 0.6F, 0.2F}, {true, true, false}},
    {"no curved surface", {1.0F, 0.95F, 0.3F}, {true, true, false}},
    {"user interface or full-screen pass", {0.5F, 0.5F, 0.6F}, {false, false, true}},
    {"left alone by your settings", {1.0F, 0.4F, 1.0F}, {true, false, true}},
    {"cannot be refined", {1.0F, 0.3F, 0.3F}, {true, false, false}},
}};
inline constexpr DrawGroupText marked_group{"marked", {0.25F, 0.35F, 1.0F}, {false, false, true}};

constexpr const DrawGroupText& text_of(DrawGroup group) { return draw_groups[static_cast<std::size_t>(group)]; }

// `kept`: the refined vertices of an earlier frame are drawn.
DrawGroup group_of(const DrawVerdict& verdict, bool kept);

}  // namespace glark::core
