// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "glark/tool/mpi/mpi_ranks.h"
#include "glark/tool/scan/parts/large_mesh.h"

namespace glark::tool {

// Folders of a mesh that several ranks read.
struct RankFolders {
  std::filesystem::path work;       // on the file system of all ranks: it is made, and removed at the end
  std::filesystem::path temporary;  // of this rank
};

// The same as read_in_parts(), by several ranks, with the same bits. All ranks count and sample a range of the points; each
// finds the samples of a range of the vertices, and reads a range of the triangles. Rank 0 reads the contents first, and it
// reads the triangles of a mesh that has other faces, too. The result is on rank 0; the others get an empty one.
// Errors: RanksError for those of read_in_parts(), on all ranks.
LargeMesh read_by_ranks(MpiRanks& ranks, const Files& files, const PartsOptions& options, const RankFolders& folders);

}  // namespace glark::tool
