// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What depth hands to the later stages.
#pragma once

#include "glark/gl/types.h"

namespace glark::depth {

// Instances sorted by piece: each is a coarse record followed by its patch (vec4), `stride` bytes.
struct BinnedInstances {
  GLuint instances = 0;
  GLsizei stride = 0;
  GLuint commands = 0;  // buffer with a DrawElementsIndirectCommand for each piece
  GLintptr commands_offset = 0;
  GLsizei command_count = 0;
};

}  // namespace glark::depth
