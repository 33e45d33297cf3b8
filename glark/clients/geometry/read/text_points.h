// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Reads points as lines of numbers (XYZ, PTS, ASC, TXT, CSV): x y z, then an intensity, colours, normals, or colours
// and normals.
#pragma once

#include "glark/clients/geometry/geometry.h"
#include "glark/clients/geometry/read/input.h"

namespace glark::geometry {

enum class TextPoints {
  xyz,  // six columns are a position and a normal if all of these have unit length or none or one is negative, else a
        // colour
  pts,  // the first line may be the number of points; six columns are a position and a colour
};

Reading read_text_points(Input& input, TextPoints kind, const ReadOptions& options);

}  // namespace glark::geometry
