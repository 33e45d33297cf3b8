// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What Assimp does not tell about the vertices of an OBJ file.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace glark::geometry {

struct ObjVertices {
  std::size_t with_colour = 0, without_colour = 0;
  // The positions of vertices that no face, line or point has. Empty if there are no faces, because then Assimp keeps all
  // vertices.
  std::vector<std::array<double, 3>> loose;
};

// with_loose: looks for loose vertices, too.
ObjVertices obj_vertices(std::string_view text, bool with_loose);

}  // namespace glark::geometry
