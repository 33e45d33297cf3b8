// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// OBJ and STL, by Assimp.
#pragma once

#include "glark/clients/geometry/geometry.h"
#include "glark/clients/geometry/read/input.h"

namespace glark::geometry {

enum class MeshFormat { obj, stl };

// Vertices are shared between triangles where they agree: in all attributes with OBJ, in the position with STL.
Reading read_by_assimp(Input& input, MeshFormat format, const ReadOptions& options);

}  // namespace glark::geometry
