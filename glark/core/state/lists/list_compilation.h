// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The display list that the application is compiling, if there is one. This class only records; the hooks
// (glark/core/track/lists) make the GL calls.
#pragma once

#include <cstdint>
#include <memory>

#include "glark/core/state/lists/display_list.h"
#include "glark/core/state/lists/list_primitive.h"

namespace glark::core {

class ListCompilation {
 public:
  // glNewList. `cutting`: into segments; otherwise the driver compiles the list alone.
  void begin(GLuint name, GLenum mode, bool cutting);
  // glEndList: the finished list.
  std::shared_ptr<DisplayList> end();

  bool compiling() const { return compiling_; }
  bool cutting() const { return cutting_; }
  // While a segment of the list is executed, calls are not compiled.
  void set_compiling(bool compiling) { compiling_ = compiling; }
  GLuint name() const { return name_; }
  GLenum mode() const { return mode_; }
  bool executes_too() const { return mode_ == GL_COMPILE_AND_EXECUTE; }

  // The effects of the calls in the open segment.
  SegmentEffects& effects() { return effects_; }
  const SegmentEffects& effects() const { return effects_; }
  void note_uniforms() { changes_uniforms_ = true; }
  void note_material(const MaterialChange& change, bool before_vertices);

  // Adds an effect of the whole list. Between glBegin and glEnd GL refuses these calls: then nothing is added, and the
  // result is false.
  bool add_stack_step(StackStep step);
  void add_loose_vertices(std::uint64_t vertices);
  // A call of another list: as a segment of its own, or between glBegin and glEnd.
  void add_call(ListSegment::Kind kind, GLuint list, bool joins = false);
  void add_vertex_list(VertexList list);

  // The GL list that takes the calls from now on.
  void open_segment(GLuint list) { open_list_ = list; }
  // Ends the open segment. No other segment ever has this `identity`.
  const ListSegment& close_segment(ListSegment segment, std::uint64_t identity);
  const ListSegment& last_segment() const { return list_->segments.back(); }

  ListPrimitive& primitive() { return primitive_; }
  const ListPrimitive& primitive() const { return primitive_; }
  // glBegin and glEnd of a list, or part of a list, that is not cut.
  void note_begin() { ++uncut_begins_; }
  void note_end() {
    list_->ends_primitive |= uncut_begins_ == 0;
    uncut_begins_ -= uncut_begins_ > 0 ? 1 : 0;
  }

 private:
  bool compiling_ = false;
  bool cutting_ = false;
  GLuint name_ = 0;
  GLenum mode_ = 0;
  std::shared_ptr<DisplayList> list_;
  GLuint open_list_ = 0;
  SegmentEffects effects_;  // of the open segment
  bool changes_uniforms_ = false;
  ListPrimitive primitive_;
  int uncut_begins_ = 0;
};

}  // namespace glark::core
