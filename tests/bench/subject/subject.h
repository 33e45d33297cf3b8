// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A mesh in buffer objects, and ways to draw it.
#pragma once

#include <cstdint>
#include <vector>

#include "tests/bench/interleave.h"
#include "tests/bench/subject/mesh.h"
#include "tests/bench/subject/subject_programs.h"

namespace glark::bench {

class Subject {
 public:
  // tags: one per vertex, or none.
  Subject(const Mesh& mesh, Shading shading, View view, const std::vector<std::uint8_t>& tags = {});
  ~Subject();
  Subject(const Subject&) = delete;
  Subject& operator=(const Subject&) = delete;

  // A competitor refers to the subject, which must outlive it.
  Competitor as_is() const;
  Competitor refined(unsigned level) const;  // all edges have the same level
  Competitor tagged() const;                 // refined by the tags
  Competitor measured(float pixels) const;   // refined until edges leave their segments by so many pixels
  Competitor tessellated(unsigned level) const;
  // Writes a few bytes of the vertices before each draw, so that nothing can be cached.
  Competitor touched(const Competitor& competitor) const;

  // Moves the camera a little before each draw, so that depths are measured again.
  Competitor moving(const Competitor& competitor) const;

  // Draws one of several objects with the current program. Uses the object's vertex array, or vertex array 0 with all
  // pointers set again.
  void draw_by_array() const;
  void draw_by_pointers() const;

 private:
  void bind(bool refined) const;
  void draw() const;
  void set_pointers() const;

  Shading shading_;
  View view_;
  GLsizei index_count_;  // 0: not indexed
  GLsizei vertex_count_;
  Vertex first_vertex_;
  GLuint array_ = 0;
  GLuint buffers_[3] = {};  // vertices, indices, tags
};

}  // namespace glark::bench
