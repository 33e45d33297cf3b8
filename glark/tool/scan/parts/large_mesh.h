// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A file that is larger than the memory, as a mesh or a set of points that fits.
#pragma once

#include <cstdint>

#include "glark/clients/geometry/geometry.h"
#include "glark/tool/scan/files.h"

namespace glark::tool {

struct PartsOptions {
  std::uint64_t memory = 0;  // bytes, of the whole process
  std::size_t target = 0;    // triangles, or points if there are no triangles; 0: as many as fit
  unsigned threads = 0;
};

struct LargeMesh {
  geometry::Geometry geometry;  // finer than the target if there are triangles
  Report contents;              // of the file
};

// Reads the file three times, a part at a time: twice to sample it, once for its triangles. Throws geometry::Error,
// stream::Error, and std::runtime_error if the memory is too small for the target.
LargeMesh read_in_parts(const Files& files, const PartsOptions& options);

// Samples of the points alone, as many as fit. Reads the file three times. Throws as read_in_parts().
LargeMesh sample_in_parts(const Files& files, const PartsOptions& options);

}  // namespace glark::tool
