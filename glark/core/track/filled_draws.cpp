// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/track/filled_draws.h"

#include <algorithm>

namespace glark::core::track {

FilledDraws::FilledDraws(GLenum mode, const GLsizei* count, GLsizei draws) {
  if ((mode != GL_QUADS && mode != GL_QUAD_STRIP && mode != GL_POLYGON) || draws <= 0) {
    return;
  }
  const GLsizei* const end = count + draws;
  const GLsizei* const filled = std::find_if(count, end, [](GLsizei vertices) { return vertices > 0; });
  const bool has_error = std::any_of(count, end, [](GLsizei vertices) { return vertices < 0; });
  if (has_error || filled == end || std::find(count, end, 0) == end) {
    return;
  }
  for (GLsizei draw = 0; draw < draws; ++draw) {
    counts_.push_back(std::max(count[draw], 1));
    from_.push_back(count[draw] > 0 ? draw : static_cast<GLsizei>(filled - count));
  }
}

}  // namespace glark::core::track
