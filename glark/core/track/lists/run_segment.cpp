// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Runs the segments of a display list when it is called. A draw need not be executed if its capture is kept.
#include <vector>

#include "glark/core/track/lists/lists.h"
#include "glark/core/track/track.h"

namespace glark::core::track {
namespace {

// The vertices of the segment have materials that no attribute carries, or that the vertex program does not see yet.
bool materials_unknown(Context& c, const SegmentMaterials& materials) {
  if (!materials.set) {
    return false;
  }
  if (materials.attributes != material_attributes(materials.carried, c.ark())) {
    return true;  // the extension's attributes have moved since
  }
  c.state().refresh();
  return !replaces_fixed_function(c) || (materials.inherited() && c.gl().IsEnabled(GL_LIGHTING) != GL_FALSE);
}

// NVIDIA (580) refuses to call an empty list during transform feedback that is not paused.
void call_without_feedback(Context& c, GLuint list) {
  c.state().refresh();
  const TransformFeedbackBindings& feedback = c.state().bindings().transform_feedback;
  const bool pause = feedback.active && !feedback.paused && !feedback.ours;
  if (pause) {
    c.gl().PauseTransformFeedback();
  }
  c.gl().CallList(list);
  if (pause) {
    c.gl().ResumeTransformFeedback();
  }
}

}  // namespace

void apply_effects(Context& c, const SegmentEffects& effects) {
  if (effects.opaque) {
    c.state().arrays().forget_current_values();
  }
  for (const SegmentEffects::Value& last : effects.values) {
    c.state().arrays().current_values().set(last.slot, last.value);
  }
}

void run_state(Context& c, const ListSegment& segment) {
  if (segment.effects.draws_shapes) {
    track::hand_back_feedback(c);
  }
  if (segment.effects.none()) {
    call_without_feedback(c, segment.list);
    return;
  }
  c.gl().CallList(segment.list);
  if (segment.effects.touches_state) {
    c.state().forget_bindings();
    c.state().fixed_function().touch();
    c.state().programs().subroutines().forget();
    c.changes().touch_any_matrix();
  }
  if (segment.effects.changes_uniforms) {
    c.state().programs().uniforms_changed_unseen();
  }
  apply_effects(c, segment.effects);
}

void run_draw(Context& c, const ListSegment& segment, std::uint64_t triangles) {
  bool issued = false;
  const bool watched = !segment.effects.opaque && segment.vertex_lists.empty();
  const auto issue = [&] {
    c.gl().CallList(segment.list);
    issued = true;
  };
  const DrawCall call{.mode = segment.mode,
                      .triangles = triangles,
                      .exact = segment.exact,
                      .tags_vary = segment.sets_tags,
                      .whole_polygons = segment.whole_polygons,
                      .polygon_sides = segment.polygon_sides.empty() ? nullptr : &segment.polygon_sides,
                      .materials = segment.effects.materials.varying,
                      .list_segment = segment.identity,
                      .calls_vertex_lists = !segment.vertex_lists.empty(),
                      .segment = watched ? &segment : nullptr,
                      .issue = issue};
  const std::vector<CurrentValue> displaced = values_under_materials(c, segment.effects);
  materials_unknown(c, segment.effects.materials) ? leave(c, call, Cause::materials_vary) : refine(c, call);
  if (!watched) {
    c.state().arrays().forget_current_values();
  }
  if (!issued) {  // its capture was kept: set the current values that its calls leave behind
    for (const SegmentEffects::Value& last : segment.effects.values) {
      last.value.again(c.gl(), last.value.index, last.value.components.data());
    }
  }
  for (const CurrentValue& value : displaced) {
    value.again(c.gl(), value.index, value.components.data());
  }
  apply_effects(c, segment.effects);
}

}  // namespace glark::core::track
