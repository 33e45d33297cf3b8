// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include "glark/clients/vstree/simplify/clusters.h"

namespace glark::vstree {

// Returns whether a result has many more connected parts than its input. Clusters that are wider than a wall is thick take
// points of both of its sides, and the wall falls into pieces.
bool falls_apart(const Surface& from, const Simplified& result);

}  // namespace glark::vstree
