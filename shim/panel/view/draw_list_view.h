// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include "shim/panel/view/panel_view.h"

namespace glark::shim {

struct DrawListAnswer {
  bool options_changed = false;
  bool wants_pick = false;
};

// The classes of draws of the last frame: their colour, what was decided, and a switch for each.
DrawListAnswer show_draws(PanelModel& model);

}  // namespace glark::shim
