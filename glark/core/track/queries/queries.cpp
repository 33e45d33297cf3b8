// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Hooks that begin and end queries and conditional rendering. Queries that count primitives must not count our captures.
#include "glark/core/track/track.h"

namespace glark::core {
namespace {

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
  const bool counted = ActiveQueries::is_counted(target);
  const bool was_active = counted && active_query(c, target, index) != 0;
  begin();
  if (counted && !was_active && active_query(c, target, index) == id) {
    c.state().bindings().queries.begin(target, index, id);
    c.state().query_surplus().forget(id);
  }
}

void query_ended(Context& c, GLenum target, GLuint index) {
  if (!c.state().immediate().open()) {  // there GL refuses to end queries
    c.state().bindings().queries.end(target, index);
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
    if (ids[i] != 0) {
      c.state().bindings().queries.deleted(ids[i]);
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
