// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Coarse meshes of blocks.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace lesson {

struct BlockMesh {
  std::vector<float> positions;          // x y z of every vertex; a block has side 1, the middle is the origin
  std::vector<std::uint32_t> triangles;  // three vertices each, counter-clockwise seen from outside
};

// `drawing` has lines of equal length: an X is a block, one block thick; any other character is none. The mesh is the
// surface of all blocks together: blocks side by side share their vertices, and have no wall between them.
BlockMesh make_blocks(std::string_view drawing);

}  // namespace lesson
