// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Reads OBJ, STL and glTF with Assimp.
#pragma once

#include "glark/clients/geometry/geometry.h"
#include "glark/clients/geometry/parse/input.h"

namespace glark::geometry {

enum class MeshFormat { obj, stl, gltf };

// Joins equal vertices of triangles. STL vertices must agree in the position, others in all attributes. The nodes of
// glTF are put into their places. A file that is compressed or piped must not name further files.
Reading read_by_assimp(Input& input, MeshFormat format, const ReadOptions& options);

}  // namespace glark::geometry
