// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Keys and the panel over the program's windows.
#pragma once

namespace glark::core {
class Context;
}

namespace glark::shim {

// Call it at the end of a frame that the current context shows in a window, before the buffers are swapped. Follows the
// keys, and draws the panel if it is open. The program's GL state and errors do not change. Costs nothing unless
// --overlay or --toggle-key was given.
void overlay_frame(core::Context& context);

}  // namespace glark::shim
