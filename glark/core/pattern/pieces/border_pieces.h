// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The pieces whose edges have different depths: skirts, smooth skirts and fans.
#pragma once

#include "glark/core/pattern/pool.h"

namespace glark::pattern {

// Appends one block of vertices that all these pieces share, and the indices of each piece. Needs pool.max_level.
void append_border_pieces(Pool& pool);

}  // namespace glark::pattern
