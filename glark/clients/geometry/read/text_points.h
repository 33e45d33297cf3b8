// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Reads points as lines of numbers (XYZ, PTS, ASC, TXT, CSV): x y z, then an intensity, colours, normals, or colours
// and normals.
#pragma once

#include "glark/clients/geometry/geometry.h"
#include "glark/clients/geometry/parse/input.h"
#include "glark/clients/geometry/parse/text_row.h"

namespace glark::geometry {

Reading read_text_points(Input& input, TextPoints kind, const ReadOptions& options);
Summary summarise_text_points(Input& input, TextPoints kind, const ReadOptions& options);

}  // namespace glark::geometry
