// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include "glark/core/pattern/pool.h"

namespace glark::pattern {

// Appends the patterns that are pieces of their own. They have the triangles of the pieces that are in the pool already,
// in the same order. Vertices that these pieces have in common occur once.
void append_whole_pieces(Pool& pool);

}  // namespace glark::pattern
