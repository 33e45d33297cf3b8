// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Which draws are welded by position, and what keeps their vertices apart.
#include <vector>

#include "glark/core/context.h"
#include "glark/core/pipeline.h"

namespace glark::core {
namespace {

// Instances have the same vertices, each in a place of its own.
std::vector<GLint> instance_words(Context& context, const capture::Layout& layout) {
  std::vector<GLint> words;
  const auto add = [&](int offset, int count) {
    for (int word = 0; word < count; ++word) {
      words.push_back(offset + word);
    }
  };
  const auto advances = [&](int location) { return context.state().attribute_source(location).divisor != 0; };
  for (const capture::Field& field : layout.fields) {
    if (field.name == "gl_InstanceID" || field.name == "gl_DrawID" ||
        (field.location >= 0 && advances(field.location))) {
      add(field.offset, field.words);
    }
  }
  if (layout.tagged && advances(static_cast<int>(context.ark().tag_attribute))) {
    add(layout.tag_offset, 1);
  }
  return words;
}

}  // namespace

// Where only a record that is not stored will do, or the tables would be too large, rather an unwelded draw than none.
void Pipeline::plan_weld(Plan& plan, DerivedKey key, std::uint64_t triangles) {
  if (plan.derived == nullptr || !key.welded) {
    return;
  }
  bool fits = weld_.can_hold(plan.derived->layout, triangles);
  const auto has_no_place = [&] { return !fits || (plan.derived->stored() && plan.pipeline != nullptr); };
  if (plan.derived->layout.displaced() && has_no_place()) {
    key.border = false;
    plan.derived = derived_program(plan, key);
    if (plan.derived == nullptr) {
      return;
    }
    fits = weld_.can_hold(plan.derived->layout, triangles);
  }
  if (plan.derived->layout.joins_edges() && has_no_place()) {
    key.welded = false;
    key.turns = key.turns && fits;
    plan.derived = derived_program(plan, key);
    plan.welded = plan.derived != nullptr && plan.derived->layout.joins_edges();
    return;
  }
  const capture::Layout& layout = plan.derived->layout;
  plan.welded = fits && (layout.joins_edges() ||
                         (layout.tagged && capture::find_role(layout.fields, capture::Role::position) != nullptr));
}

// Captured triangles, or those that polygons were split into: tags are welded before, edges after that.
void Pipeline::weld(const Plan& plan, const capture::CoarseTriangles& triangles, const GpuBuffer& count, bool split) {
  const bool edges = plan.layout->joins_edges() && split == plan.polygons.has_value();
  const bool tags = plan.layout->tagged && !split;
  if (!plan.welded || !(edges || tags)) {
    return;
  }
  const std::vector<GLint> keys = instance_words(context_, *plan.layout);
  weld_.run({plan.layout, triangles, keys, edges, tags}, count.name());
  storage_changed_ = true;
}

}  // namespace glark::core
