// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The pieces whose edges have different depths: skirts, smooth skirts and fans.
#pragma once

#include "glark/core/pattern/pool.h"

namespace glark::pattern {

// Appends one block of vertices that they all share, and each piece's indices. pool.max_level is set.
void append_border_pieces(Pool& pool);

}  // namespace glark::pattern
