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
  // Six columns are a position and a normal if all normals have length 1 or 0, or if a number is negative. Otherwise
  // they are a position and a colour.
  xyz,
  // The first line may be the number of points. Six columns are a position and a colour.
  pts,
};

Reading read_text_points(Input& input, TextPoints kind, const ReadOptions& options);

}  // namespace glark::geometry
