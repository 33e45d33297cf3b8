// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Hooks that begin and end queries and conditional rendering. Queries that count primitives must not count our captures.
#include <algorithm>

#include "glark/core/track/track.h"

namespace glark::core {
namespace {

bool counts_primitives(GLenum target) {
  switch (target) {
    case GL_PRIMITIVES_GENERATED:
    case GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN:
    case GL_TRANSFORM_FEEDBACK_OVERFLOW:
    case GL_TRANSFORM_FEEDBACK_STREAM_OVERFLOW:
    case GL_VERTICES_SUBMITTED:
    case GL_PRIMITIVES_SUBMITTED:
    case GL_VERTEX_SHADER_INVOCATIONS:
    case GL_GEOMETRY_SHADER_INVOCATIONS:
    case GL_GEOMETRY_SHADER_PRIMITIVES_EMITTED:
    case GL_CLIPPING_INPUT_PRIMITIVES:
    case GL_CLIPPING_OUTPUT_PRIMITIVES:
    case GL_COMPUTE_SHADER_INVOCATIONS: return true;
    default: return false;
  }
}

// Returns the place of the query that counts triangles of stream 0; null for other targets.
GLuint* triangle_query(Context& c, GLenum target, GLuint index) {
  if (index != 0) {
    return nullptr;
  }
  return target == GL_PRIMITIVES_GENERATED                    ? &c.state().bindings().queries.generated
         : target == GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN ? &c.state().bindings().queries.written
                                                              : nullptr;
}

// The active query; 0 if there is none.
GLuint active_query(Context& c, GLenum target, GLuint index) {
  GLint id = 0;
  if (index == 0) {
    c.gl().GetQueryiv(target, GL_CURRENT_QUERY, &id);
  } else {
    c.gl().GetQueryIndexediv(target, index, GL_CURRENT_QUERY, &id);
  }
  return static_cast<GLuint>(id);
}

// Calls `begin`, which begins a query. GL refuses one that is active, or that belongs to another target.
template <class Begin>
void begin_query(Context& c, GLenum target, GLuint index, GLuint id, const Begin& begin) {
  const bool counts = counts_primitives(target);
  const bool was_active = counts && active_query(c, target, index) != 0;
  begin();
  if (!counts || was_active || active_query(c, target, index) != id) {
    return;
  }
  ++c.state().bindings().queries.active;
  if (GLuint* slot = triangle_query(c, target, index); slot != nullptr) {
    *slot = id;
    c.state().query_surplus().forget(id);
  }
}

void query_ended(Context& c, GLenum target, GLuint index) {
  if (!counts_primitives(target)) {
    return;
  }
  c.state().bindings().queries.active = std::max(0, c.state().bindings().queries.active - 1);
  if (GLuint* slot = triangle_query(c, target, index); slot != nullptr) {
    *slot = 0;
  }
}

}  // namespace

namespace hook {

void BeginQuery(Context& c, GLenum target, GLuint id) {
  begin_query(c, target, 0, id, [&] { c.gl().BeginQuery(target, id); });
}

void EndQuery(Context& c, GLenum target) {
  c.gl().EndQuery(target);
  query_ended(c, target, 0);
}

void BeginQueryIndexed(Context& c, GLenum target, GLuint index, GLuint id) {
  begin_query(c, target, index, id, [&] { c.gl().BeginQueryIndexed(target, index, id); });
}

void EndQueryIndexed(Context& c, GLenum target, GLuint index) {
  c.gl().EndQueryIndexed(target, index);
  query_ended(c, target, index);
}

// Deleting a query ends it. A query of any target may get its name.
void DeleteQueries(Context& c, GLsizei n, const GLuint* ids) {
  c.gl().DeleteQueries(n, ids);
  for (GLsizei i = 0; i < n && ids != nullptr; ++i) {
    c.state().query_surplus().forget(ids[i]);
    c.state().conditional_rendering().query_deleted(ids[i]);
    for (const GLenum target : {GL_PRIMITIVES_GENERATED, GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN}) {
      if (const GLuint* slot = triangle_query(c, target, 0); ids[i] != 0 && *slot == ids[i]) {
        query_ended(c, target, 0);
      }
    }
  }
}

void BeginConditionalRender(Context& c, GLuint id, GLenum mode) {
  if (c.state().lists().compiling()) {
    c.state().conditional_rendering().lose();
    c.gl().BeginConditionalRender(id, mode);
    return;
  }
  ErrorScope errors(c.pending_error());
  c.gl().BeginConditionalRender(id, mode);
  if (const GLenum error = errors.take(); error != GL_NO_ERROR) {
    c.pending_error().raise(error);
    return;
  }
  c.state().conditional_rendering().begin(id, mode);
}

void EndConditionalRender(Context& c) {
  c.gl().EndConditionalRender();
  if (c.state().lists().compiling()) {
    c.state().conditional_rendering().lose();
  } else {
    c.state().conditional_rendering().end();
  }
}

}  // namespace hook
}  // namespace glark::core
