// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Reads OFF files as text: [ST][C][N][4][n]OFF. Each vertex and each face has a line of its own, as programs write them.
// Specification: Geomview, OFF files, https://www.geomview.org/docs/html/OFF.html
#pragma once

#include "glark/clients/geometry/geometry.h"
#include "glark/clients/geometry/parse/input.h"

namespace glark::geometry {

// Joins equal points of triangles. Colours of faces are not kept. Throws Error.
Reading read_off(Input& input, const ReadOptions& options);

}  // namespace glark::geometry
