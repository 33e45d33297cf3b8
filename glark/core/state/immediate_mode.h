// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The state between glBegin and glEnd. The vertices go straight to GL; here they are only counted.
#pragma once

#include <cstdint>
#include <utility>

#include "glark/core/state/fixed_function/vertex_materials.h"
#include "glark/core/state/vertex_sources.h"
#include "glark/gl/types.h"

namespace glark::core {

class ImmediateMode {
 public:
  // Between glBegin and glEnd, outside of display lists.
  bool open() const { return open_; }
  GLenum mode() const { return mode_; }
  // A refined draw captures the vertices.
  bool capturing() const { return capturing_; }

  // False inside another glBegin: GL refuses that call.
  bool begin(GLenum mode) {
    if (std::exchange(open_, true)) {
      return false;
    }
    mode_ = mode;
    tags_set_ = capturing_ = false;
    return true;
  }
  // True: a capture ends with it.
  bool end() {
    open_ = false;
    limit_ = UINT64_MAX;
    return std::exchange(capturing_, false);
  }
  // From here on a refined draw captures up to `limit` vertices; 0: no draw captures them.
  void capture(std::uint64_t limit) {
    capturing_ = limit > 0;
    limit_ = capturing_ ? limit : UINT64_MAX;
  }

  // The counts of vertices start at 0.
  void restart_counts() {
    vertices_ = vertices_before_ = triangles_before_ = 0;
    components_ = 0;
    limit_ = UINT64_MAX;
    restarted_ = false;
    uncertain_ = false;
  }
  bool full() const { return vertices_ == limit_; }
  // Whether the current capture has room for so many more.
  bool fits(std::uint64_t vertices) const { return limit_ == UINT64_MAX || vertices_ + vertices <= limit_; }
  void count(unsigned components) {
    ++vertices_;
    components_ |= 1U << components;
  }
  // A called list gives this many vertices.
  void count_called(std::uint64_t vertices) { vertices_ += vertices; }
  bool before_vertices() const { return vertices_ == 0 && vertices_before_ == 0; }
  // Since glBegin or the last restart.
  std::uint64_t vertices() const { return vertices_; }
  std::uint64_t all_vertices() const { return vertices_before_ + vertices_; }
  std::uint64_t triangles_before() const { return triangles_before_; }
  // Bits: the numbers of components that the vertices have.
  unsigned components() const { return components_; }

  // glPrimitiveRestartNV ends a primitive of `triangles` triangles. Each takes `step` vertices; 0: triangles share
  // vertices.
  void restart(std::uint64_t triangles, std::uint64_t step) {
    restarted_ = true;
    vertices_before_ += vertices_;
    triangles_before_ += triangles;
    if (limit_ != UINT64_MAX) {
      limit_ -= vertices_ / step * step;
    }
    vertices_ = 0;
  }
  bool restarted() const { return restarted_; }
  // glPrimitiveRestartIndexNV was called: from then on glArrayElement may restart.
  void note_elements_restart() { elements_restart_ = true; }
  bool elements_restart() const { return elements_restart_; }

  // Between glBegin and glEnd nothing can be asked: this is as it was before.
  void set_sources(const VertexSources& sources) { sources_ = sources; }
  const VertexSources& sources() const { return sources_; }
  // In a list: whether some counted calls give a vertex is known only when the list is called.
  void note_uncertain() { uncertain_ = true; }
  bool uncertain() const { return uncertain_; }

  VertexMaterials& materials() { return materials_; }
  const VertexMaterials& materials() const { return materials_; }

  // glDepthTag1i was called.
  void note_tag() { tags_set_ = true; }
  void forget_tags() { tags_set_ = false; }
  bool tags_set() const { return tags_set_; }

 private:
  bool open_ = false;
  bool capturing_ = false;
  bool tags_set_ = false;
  bool restarted_ = false;
  bool elements_restart_ = false;
  bool uncertain_ = false;
  VertexSources sources_;
  GLenum mode_ = 0;
  unsigned components_ = 0;
  std::uint64_t vertices_ = 0;
  std::uint64_t limit_ = UINT64_MAX;    // this many vertices fit the current capture
  std::uint64_t vertices_before_ = 0;   // of the primitives that a restart ended
  std::uint64_t triangles_before_ = 0;  // of the primitives that a restart ended
  VertexMaterials materials_;
};

}  // namespace glark::core
