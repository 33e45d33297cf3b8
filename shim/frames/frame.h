// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

namespace glark::shim {

// The calling thread's context has drawn a frame; called before the buffers are swapped.
void frame_ended();

}  // namespace glark::shim
