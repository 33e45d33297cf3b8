// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The queries that the application has begun and not ended, of the targets that our own passes would count into.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "glark/gl/types.h"

namespace glark::core {

class ActiveQueries {
 public:
  // Our captures would count into a query of this target.
  static bool counts_primitives(GLenum target) {
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
  // A pass that draws would count into it.
  static bool is_counted(GLenum target) {
    return counts_primitives(target) || target == GL_FRAGMENT_SHADER_INVOCATIONS;
  }

  void begin(GLenum target, GLuint index, GLuint id) {
    active_.push_back({target, index, id});
    set(target, index, id);
  }
  // Does nothing if there is no such query, as GL then refuses to end it.
  void end(GLenum target, GLuint index) {
    if (std::erase_if(active_, [&](const Query& q) { return q.target == target && q.index == index; }) != 0) {
      set(target, index, 0);
    }
  }
  // The application deleted a query, which ends it if it is active.
  void deleted(GLuint id) {
    const std::vector<Query> before = active_;
    for (const Query& query : before) {
      if (query.id == id) {
        end(query.target, query.index);
      }
    }
  }

  bool none() const { return active_.empty(); }
  bool primitives() const {
    return std::any_of(active_.begin(), active_.end(), [](const Query& q) { return counts_primitives(q.target); });
  }
  // The query of GL_PRIMITIVES_GENERATED of stream 0; 0: none.
  GLuint generated() const { return generated_; }
  // The query of GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN of stream 0; 0: none, or it is stopped.
  GLuint written() const { return written_; }
  // We end it for a while, to use its target ourselves. Returns its name.
  GLuint stop_written() { return std::exchange(written_, 0); }
  void resume_written(GLuint id) { written_ = id; }

 private:
  struct Query {
    GLenum target;
    GLuint index;  // of the vertex stream
    GLuint id;
  };

  void set(GLenum target, GLuint index, GLuint id) {
    if (index == 0 && target == GL_PRIMITIVES_GENERATED) {
      generated_ = id;
    } else if (index == 0 && target == GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN) {
      written_ = id;
    }
  }

  std::vector<Query> active_;
  GLuint generated_ = 0;
  GLuint written_ = 0;
};

}  // namespace glark::core
