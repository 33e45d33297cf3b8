// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Reads PLY. No library in Debian fits our files. Some keep only floats, which are too short for georeferenced scans.
// Some need faces. Some take tens of times the memory of the points.
#pragma once

#include "glark/clients/geometry/geometry.h"
#include "glark/clients/geometry/parse/input.h"

namespace glark::geometry {

Reading read_ply(Input& input, const ReadOptions& options);
Summary summarise_ply(Input& input, const ReadOptions& options);

}  // namespace glark::geometry
