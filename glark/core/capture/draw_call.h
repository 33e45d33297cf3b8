// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// One draw of the application, as the stages see it.
#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>

#include "glark/core/state/fixed_function/material_parameters.h"
#include "glark/core/state/lists/polygon_sides.h"
#include "glark/gl/types.h"

namespace glark::core {

// A reference to a callable, for the duration of a call.
class Issue {
 public:
  template <typename Callable>
  requires(!std::is_same_v<std::remove_cvref_t<Callable>, Issue>)
      Issue(Callable&& callable)  // NOLINT(google-explicit-constructor): stands for the callable
      : object_(const_cast<void*>(static_cast<const void*>(&callable))),
        call_([](void* object) { (*static_cast<std::remove_reference_t<Callable>*>(object))(); }) {}
  void operator()() const { call_(object_); }

 private:
  void* object_;
  void (*call_)(void*);
};

struct ListSegment;

// The arguments that decide what a draw of vertex arrays captures.
struct ArrayDraw {
  GLenum mode = 0;
  GLint first = 0;
  GLsizei count = 0;
  GLenum index_type = 0;  // 0: not indexed
  const void* indices = nullptr;
  GLint base_vertex = 0;
  GLsizei instances = 1;
  GLuint base_instance = 0;
  auto operator<=>(const ArrayDraw&) const = default;
};

struct DrawCall {
  GLenum mode = 0;
  std::uint64_t triangles = 0;  // their number in the whole call, or a bound if !exact
  bool exact = true;
  bool tags_vary = false;       // glDepthTag1i was called between its vertices
  bool whole_polygons = false;  // its triangles are those of GL's quads, or of one GL_POLYGON alone
  const PolygonSides* polygon_sides =
      nullptr;                        // sizes of several GL_POLYGONs, if they are known; for a bound, the greatest ones
  MaterialSet materials = 0;          // parameters of the material that the vertices have as attributes
  bool never_refined = false;         // a rectangle, or a mesh of evaluators
  bool from_arrays = false;           // its vertices come from vertex arrays
  bool indexed = false;               // in the order of an index array
  std::uint64_t list_segment = 0;     // or from this ListSegment::identity; 0: from neither
  bool calls_vertex_lists = false;    // the segment calls lists that give vertices: GL draws them as those of glBegin
  const ArrayDraw* arrays = nullptr;  // set, or a segment is, if the capture may be kept
  const ListSegment* segment = nullptr;
  std::span<const std::uint32_t> commands =
      {};       // words of the indirect commands; `arrays` has only mode and index type
  Issue issue;  // makes the application's own call
  const Issue* captured =
      nullptr;  // if set, the call while it is captured: the same triangles, by what drivers get right
};

inline bool is_triangle_mode(GLenum mode) {
  return mode == GL_TRIANGLES || mode == GL_TRIANGLE_STRIP || mode == GL_TRIANGLE_FAN || mode == GL_QUADS ||
         mode == GL_QUAD_STRIP || mode == GL_POLYGON;
}

// Returns whether the polygons of `primitives` commands can be told apart. Each quad is two triangles; a GL_POLYGON has
// any number.
inline bool tells_polygons_apart(GLenum mode, std::uint64_t primitives) {
  return mode != GL_POLYGON || primitives == 1;
}

// Triangles that GL makes of `vertices` in `mode` (OpenGL 4.6 compatibility, 10.1); primitive restart can only lower
// it.
inline std::uint64_t triangles_of(GLenum mode, std::uint64_t vertices) {
  switch (mode) {
    case GL_TRIANGLES: return vertices / 3;
    case GL_TRIANGLE_STRIP:
    case GL_TRIANGLE_FAN:
    case GL_POLYGON: return vertices < 3 ? 0 : vertices - 2;
    case GL_QUADS: return 2 * (vertices / 4);
    case GL_QUAD_STRIP: return vertices < 4 ? 0 : 2 * ((vertices - 2) / 2);
    default: return 0;
  }
}

}  // namespace glark::core
