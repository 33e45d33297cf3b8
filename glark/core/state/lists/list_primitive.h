// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glBegin..glEnd in a display list that is cut into segments.
#pragma once

#include <utility>
#include <vector>

#include "glark/core/state/lists/display_list.h"

namespace glark::core {

class ListPrimitive {
 public:
  // `draws`: a draw segment begins.
  void begin(GLenum mode, bool draws) {
    open_ = true;
    draws_ = draws;
    mode_ = mode;
    vertex_lists_.clear();
  }
  // True: a draw segment ends.
  bool end() {
    open_ = false;
    return std::exchange(draws_, false);
  }
  void add(VertexList list) { vertex_lists_.push_back(list); }

  bool open() const { return open_; }
  GLenum mode() const { return mode_; }
  // Lists called since glBegin.
  const std::vector<VertexList>& vertex_lists() const { return vertex_lists_; }

 private:
  bool open_ = false;
  bool draws_ = false;
  GLenum mode_ = 0;
  std::vector<VertexList> vertex_lists_;
};

}  // namespace glark::core
