// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/support/counted.h"

namespace glark::conformance {

GLuint count_generated(const std::function<void()>& draw) {
  GLuint query = 0;
  GLuint count = 0;
  gl.GenQueries(1, &query);
  gl.BeginQuery(GL_PRIMITIVES_GENERATED, query);
  draw();
  gl.EndQuery(GL_PRIMITIVES_GENERATED);
  gl.GetQueryObjectuiv(query, GL_QUERY_RESULT, &count);
  gl.DeleteQueries(1, &query);
  return count;
}

}  // namespace glark::conformance
