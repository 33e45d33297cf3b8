// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What is known between glBegin and glEnd.
#pragma once

#include <cstdint>

#include "glark/gl/types.h"

namespace glark::core {

struct ImmediateDraw {
  bool open = false;       // between glBegin and glEnd
  bool capturing = false;  // by the pipeline
  GLenum mode = 0;
  bool tags_set = false;
  bool restarted = false;              // by glPrimitiveRestartNV
  std::uint64_t vertices_before = 0;   // of the primitives that it ended
  std::uint64_t triangles_before = 0;  // and their triangles
};

}  // namespace glark::core
