// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Lists of draws without empty ones, for captures; the application's own call stays as it is. zink and virpipe
// (Mesa 22 to 25) lose the quads and polygons that follow an empty draw of one glMultiDraw call. They keep them if the
// draw has one vertex, from which GL makes no polygon either. The number of draws stays, and so does gl_DrawID.
#pragma once

#include <vector>

#include "glark/gl/types.h"

namespace glark::core::track {

class FilledDraws {
 public:
  // In `mode`, draw i has count[i] vertices. Does nothing if no draw is empty, if all are, or if one has a negative
  // count, which is an error.
  FilledDraws(GLenum mode, const GLsizei* count, GLsizei draws);
  bool needed() const { return !from_.empty(); }
  const GLsizei* counts() const { return counts_.data(); }
  // The arguments, with those of an empty draw replaced by arguments of a draw that has vertices.
  template <typename Value>
  std::vector<Value> arguments(const Value* each) const {
    std::vector<Value> result;
    result.reserve(from_.size());
    for (const GLsizei draw : from_) {
      result.push_back(each[draw]);
    }
    return result;
  }

 private:
  std::vector<GLsizei> counts_;
  std::vector<GLsizei> from_;  // for each draw, the draw that has its arguments
};

}  // namespace glark::core::track
