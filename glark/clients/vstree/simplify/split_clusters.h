// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include "glark/clients/vstree/simplify/clusters.h"

namespace glark::vstree {

// Halves the largest clusters until there are `wanted`, or until the points of each have one position. The nodes of a
// tree have up to eight children, so the divisions of a tree miss a small target by several clusters.
void split_largest(const Surface& surface, std::size_t wanted, Clusters& clusters);

}  // namespace glark::vstree
