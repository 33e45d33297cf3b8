// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What capture hands to the later stages.
#pragma once

#include <cstdint>

#include "glark/gl/types.h"

namespace glark::capture {

// Where the coarse records of a draw are. The buffer belongs to the capture stage; the records of the ring
// are valid until the next capture, those of the cache until their entry is dropped.
struct CoarseTriangles {
  GLuint buffer = 0;
  GLintptr offset = 0;
  std::uint32_t count = 0;  // exact, or a bound if `count_on_gpu`
  bool count_on_gpu = false;
};

// A DrawElementsIndirectCommand: its instance count is where the GPU writes a count that the CPU does not know.
struct CountCommand {
  std::uint32_t index_count = 0;
  std::uint32_t instance_count = 0;
  std::uint32_t first_index = 0;
  std::int32_t base_vertex = 0;
  std::uint32_t base_instance = 0;
};

}  // namespace glark::capture
