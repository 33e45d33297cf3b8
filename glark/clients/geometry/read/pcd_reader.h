// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Reads PCD, the point clouds of the Point Cloud Library: text, or binary without compression.
#pragma once

#include "glark/clients/geometry/geometry.h"
#include "glark/clients/geometry/parse/input.h"

namespace glark::geometry {

// Keeps x, y, z, the normal and rgb or rgba. Throws Error.
Reading read_pcd(Input& input, const ReadOptions& options);
Summary summarise_pcd(Input& input, const ReadOptions& options);

}  // namespace glark::geometry
