// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The coarse mesh of a model: a given one, a fine mesh with fewer triangles, a reconstruction, or the surfel strips of a
// sampling.
#pragma once

#include <glark/point_stream.h>

#include <cstddef>
#include <cstdint>
#include <string>

#include "glark/clients/geometry/geometry.h"
#include "glark/tool/scan/bake/saved_work.h"
#include "glark/tool/scan/files.h"

namespace glark::tool {

struct CoarseOptions {
  std::size_t triangles = 20000;  // the most
  std::uint64_t memory = 0;       // bytes, of the sampling
  unsigned threads = 0;
};

// Throws std::runtime_error if the file has no triangles.
geometry::Geometry read_coarse_mesh(const std::string& file, const Files& files);
geometry::Geometry simplify_to(geometry::Geometry fine, const CoarseOptions& options);
struct CoarseReconstruction {
  geometry::Geometry mesh;  // without triangles if no surface is found in the points
  double noise = 0;         // of the points, in their unit
};
CoarseReconstruction reconstruct_from(const geometry::Geometry& points, const CoarseOptions& options);
// Throws std::runtime_error if the points have no surface. work: keeps the sampling.
geometry::Geometry strip_sampling(const stream::Source& source, const CoarseOptions& options, bool skip_invalid,
                                  SavedWork& work);

}  // namespace glark::tool
