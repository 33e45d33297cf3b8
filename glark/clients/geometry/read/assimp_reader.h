// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Reads OBJ and STL with Assimp.
#pragma once

#include "glark/clients/geometry/geometry.h"
#include "glark/clients/geometry/read/input.h"

namespace glark::geometry {

enum class MeshFormat { obj, stl };

// Triangles share vertices that agree: in all attributes in OBJ, in the position in STL.
Reading read_by_assimp(Input& input, MeshFormat format, const ReadOptions& options);

}  // namespace glark::geometry
