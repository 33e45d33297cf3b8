// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A display list cut into segments: runs of state changes, and draws. The application's list is compiled as a list of calls of
// our segment lists, so that it works unchanged with ARK off; with ARK on each draw segment is captured and refined at
// call time.
#pragma once

#include <cstdint>
#include <vector>

#include "glark/gl/types.h"

namespace glark::core {

// A list called between glBegin and glEnd: it gives vertices.
struct VertexList {
  GLuint list = 0;
  bool offset = false;  // `list` is added to glListBase
};

struct ListSegment {
  enum class Kind { state, draw, call, call_offset };
  Kind kind = Kind::state;
  GLuint list = 0;             // our list to call; for `call` the application's list; call_offset: added to glListBase
  GLenum mode = GL_TRIANGLES;  // of a draw segment
  std::uint64_t vertices = 0;  // of a draw segment
  std::uint64_t triangles = 0;
  bool exact = true;                          // `triangles` is the count, not a bound
  bool sets_tags = false;                     // glDepthTag1i was called inside
  bool whole_polygons = false;                // as in DrawCall
  std::vector<VertexList> vertex_lists = {};  // `vertices` are without theirs
};

struct DisplayList {
  std::vector<ListSegment> segments;
  bool refinable = false;  // false: call the application's list as it is
  bool changes_uniforms = false;
  bool calls_lists = false;
  std::uint64_t loose_vertices = 0;  // outside glBegin and glEnd; those of lists that it calls not counted
};

}  // namespace glark::core
