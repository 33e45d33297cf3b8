// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The display list that the application compiles at the moment.
#pragma once

#include <memory>
#include <vector>

#include "glark/core/state/lists/display_list.h"

namespace glark::core {

struct ListCompilation {
  bool compiling = false;         // between glNewList and glEndList
  bool changes_uniforms = false;  // a uniform call went into the open segment
  bool cutting = false;           // into segments; otherwise the driver compiles it alone
  GLuint name = 0;
  GLenum mode = 0;
  std::shared_ptr<DisplayList> list;
  GLuint open_segment = 0;
  SegmentEffects segment;                // effects of the open segment
  GLenum begun_mode = 0;                 // of a glBegin that is open in a draw segment
  std::vector<VertexList> vertex_lists;  // called since the open glBegin
  bool in_draw = false;
  bool in_begin = false;
};

}  // namespace glark::core
