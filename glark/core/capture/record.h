// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The layout of a coarse record: what one captured corner holds, in 4-byte words.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "glark/gl/types.h"

namespace glark::capture {

enum class Role { other, position, normal, texture_coordinate };

// An active input of the vertex stage, or a system value that it reads.
struct Field {
  std::string name;         // as glGetActiveAttrib reports it, without "[0]": "gl_Vertex", "position", "gl_VertexID"
  GLenum type = 0;          // GL_FLOAT, GL_FLOAT_VEC3, GL_FLOAT_MAT4, GL_INT_VEC2, GL_UNSIGNED_INT, ...
  int array_size = 1;       // elements when the input is an array
  bool is_array = false;    // declared as an array, even of one element
  int location = -1;        // generic attribute location; -1 for built-ins and system values
  bool made = false;        // no input: welding writes it (a normal from positions)
  bool unread = false;      // the vertex stage has no such input: a tag of the vertices that shapes the surface
  Role role = Role::other;  // which field PN triangles take as position and normal
  int offset = 0;           // first word within the corner record
  int words = 0;            // words of the whole input: array_size * columns * rows
};

// Bytes after the records of a buffer: the last vec4 chunk of the last record may read past its end.
inline constexpr std::int64_t chunk_overrun = 16;

// The words that welding writes to a corner: the control points of its edges, 3 b210 (vec3) towards the next corner,
// then towards the one before.
inline constexpr int control_words = 6;

// The words that welding writes to a corner for displacement on the border of a triangle. The normal (vec3) and the
// texture coordinate (vec2) of the position come first. Then come the texture coordinates (two vec2) at both ends of
// the edge to the next corner.
inline constexpr int border_words = 9;

// The words that welding adds to a corner, besides a depth tag that is there already.
struct WeldedWords {
  bool controls = false;
  bool turns = false;
  int displaced_by = -1;  // the field of the texture coordinate; -1: nothing is displaced
};

// A corner has its fields one after the other, then the depth tag (float) if `tagged`, then the words that welding
// adds: the control points, the half-edge of the greatest turn, and the words for displacement on the border.
struct Layout {
  std::vector<Field> fields;
  bool tagged = false;
  int corner_words = 0;  // stride of one corner; a coarse record is 3 * corner_words words
  int tag_offset = -1;
  int control_offset = -1;  // in a corner; < 0: edges are not welded
  // In a corner: the half-edge with the greatest turn of the normal, among all sides of the edge that begins at this
  // corner. It is the number of its first corner in the draw. < 0: each side is measured by itself.
  int turn_offset = -1;
  int border_offset = -1;      // in a corner; < 0: displacement uses each triangle's own values
  int coordinate_offset = -1;  // the texture coordinate for displacement, where there is a border

  bool welded() const { return control_offset >= 0; }
  bool joins_edges() const { return welded() || turn_offset >= 0 || displaced(); }
  bool displaced() const { return border_offset >= 0; }
  int triangle_words() const { return 3 * corner_words; }
  int chunk_count() const { return (triangle_words() + 3) / 4; }
  int corner_chunk_count() const { return (corner_words + 3) / 4; }
};

}  // namespace glark::capture
