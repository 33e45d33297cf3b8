// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Sheets that an edge collapse brings together.
#pragma once

#include "glark/clients/vstree/simplify/clusters.h"

namespace glark::vstree {

// Makes at most two triangles meet in an edge, where vertices at one position count as one. Removes pairs of triangles
// that cover each other, and moves the vertices of touching sheets a little apart. Edges between points where the
// surface itself has more than two triangles at an edge stay as they are.
void part_touching_sheets(const Surface& surface, Simplified& result);

}  // namespace glark::vstree
