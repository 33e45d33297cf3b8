// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The captured triangles of a draw, as later stages see them.
#pragma once

#include <cstdint>

#include "glark/gl/types.h"

namespace glark::capture {

// The place of a draw's coarse records. Records in the ring of the capture stage are valid until the next capture,
// records in the cache until their entry is dropped.
struct CoarseTriangles {
  GLuint buffer = 0;
  GLintptr offset = 0;
  std::uint32_t count = 0;  // exact, or a bound if `count_on_gpu`
  bool count_on_gpu = false;
};

// A DrawElementsIndirectCommand. If the CPU does not know the number of triangles, the GPU writes it to the instance
// count.
struct CountCommand {
  std::uint32_t index_count = 0;
  std::uint32_t instance_count = 0;
  std::uint32_t first_index = 0;
  std::int32_t base_vertex = 0;
  std::uint32_t base_instance = 0;
};

}  // namespace glark::capture
