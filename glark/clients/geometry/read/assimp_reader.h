// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Reads OBJ and STL with Assimp.
#pragma once

#include "glark/clients/geometry/geometry.h"
#include "glark/clients/geometry/read/input.h"

namespace glark::geometry {

enum class MeshFormat { obj, stl };

// Joins equal vertices of triangles. OBJ vertices must agree in all attributes, STL vertices in the position.
Reading read_by_assimp(Input& input, MeshFormat format, const ReadOptions& options);

}  // namespace glark::geometry
