// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The result of the depth stage.
#pragma once

#include "glark/gl/types.h"

namespace glark::depth {

// Instances sorted by piece: their coarse records, and their patches (vec4), in the same order.
struct BinnedInstances {
  GLuint records = 0;
  GLintptr records_offset = 0;
  GLsizei record_stride = 0;  // bytes
  GLuint patches = 0;
  GLintptr patches_offset = 0;
  GLuint commands = 0;  // buffer with a DrawElementsIndirectCommand for each piece
  GLintptr commands_offset = 0;
  GLsizei command_count = 0;
};

}  // namespace glark::depth
