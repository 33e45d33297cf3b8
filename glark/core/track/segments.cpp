// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The segments of a display list at call time: draws, which need not be executed when their capture is kept, and what lies in
// between.
#include "glark/core/track/track.h"

namespace glark::core::track {

// What a segment that GL has just executed did to the current values.
void apply_effects(Context& c, const SegmentEffects& effects) {
  if (effects.opaque) {
    c.current_values.forget(c.next_stamp());
  }
  for (const SegmentEffects::Value& last : effects.values) {
    c.current_values.set(last.slot, last.value);
  }
}

void forget_uniforms(Context& c) {
  if (c.current_program != nullptr) {
    const std::lock_guard lock(c.current_program->mutex);
    c.current_program->uniforms_stale = c.share->any_derived.load(std::memory_order_relaxed);
  }
}

void run_state(Context& c, const ListSegment& segment) {
  if (segment.effects.draws_shapes) {
    c.pipeline->hand_back_feedback();
  }
  c.gl.CallList(segment.list);
  if (segment.effects.touches_state) {
    c.bindings_stale = true;
    c.fixed_function_stale = true;
    c.subroutines_known = false;
    c.touch_any_matrix();
  }
  if (segment.effects.changes_uniforms) {
    forget_uniforms(c);
  }
  apply_effects(c, segment.effects);
}

void run_draw(Context& c, const ListSegment& segment, std::uint64_t triangles) {
  bool issued = false;
  const bool watched = !segment.effects.opaque && segment.vertex_lists.empty();
  c.pipeline->draw({.mode = segment.mode,
                    .triangles = triangles,
                    .exact = segment.exact,
                    .tags_vary = segment.sets_tags,
                    .whole_polygons = segment.whole_polygons,
                    .polygon_sides = segment.polygon_sides.empty() ? nullptr : &segment.polygon_sides,
                    .segment = watched ? &segment : nullptr,
                    .issue = [&] {
                      c.gl.CallList(segment.list);
                      issued = true;
                    }});
  if (!watched) {
    c.current_values.forget(c.next_stamp());
  }
  if (!issued) {  // kept: what its calls leave behind is still to be done
    for (const SegmentEffects::Value& last : segment.effects.values) {
      last.value.again(c.gl, last.value.index, last.value.components.data());
    }
  }
  apply_effects(c, segment.effects);
}

}  // namespace glark::core::track
