// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/state/lists/list_compilation.h"

#include <utility>

namespace glark::core {

void ListCompilation::begin(GLuint name, GLenum mode, bool cutting) {
  *this = ListCompilation{};
  compiling_ = true;
  cutting_ = cutting;
  name_ = name;
  mode_ = mode;
  list_ = std::make_shared<DisplayList>();
}

std::shared_ptr<DisplayList> ListCompilation::end() {
  list_->changes_uniforms |= changes_uniforms_;
  list_->refinable = cutting_ && !primitive_.open();  // a glBegin left open reaches into the next list
  list_->leaves_open = primitive_.open() || uncut_begins_ > 0;
  compiling_ = cutting_ = false;
  return std::exchange(list_, nullptr);
}

bool ListCompilation::add_stack_step(StackStep step) {
  if (!compiling_ || primitive_.open()) {
    return false;
  }
  list_->stack_steps.push_back(step);
  return true;
}

void ListCompilation::note_material(const MaterialChange& change, bool before_vertices) {
  if (!primitive_.open()) {
    list_->loose_materials.push_back(change);
    return;
  }
  effects_.materials.set = true;
  effects_.materials.varying |= before_vertices ? 0 : change.parameters();
}

void ListCompilation::add_loose_vertices(std::uint64_t vertices) {
  if (!primitive_.open()) {
    list_->loose_vertices += vertices;
  }
}

void ListCompilation::add_call(ListSegment::Kind kind, GLuint list, bool joins) {
  list_->calls_lists = true;
  list_->segments.push_back({.kind = kind, .list = list, .joins = joins});
}

void ListCompilation::add_vertex_list(VertexList list) {
  list_->calls_lists = true;
  primitive_.add(list);
}

const ListSegment& ListCompilation::close_segment(ListSegment segment, std::uint64_t identity) {
  segment.list = open_list_;
  segment.identity = identity;
  segment.effects = std::exchange(effects_, {});
  segment.effects.changes_uniforms = std::exchange(changes_uniforms_, false);
  list_->changes_uniforms |= segment.effects.changes_uniforms;
  list_->segments.push_back(std::move(segment));
  return list_->segments.back();
}

}  // namespace glark::core
