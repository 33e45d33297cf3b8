// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

namespace glark::shim {

// Ends a frame of the calling thread's context. Call it before the buffers are swapped.
void frame_ended();

}  // namespace glark::shim
