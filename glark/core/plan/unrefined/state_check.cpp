// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/plan/unrefined/state_check.h"

namespace glark::core {
namespace {

bool culled(const Bindings& b, GLenum face) {
  return b.culling.enabled && (b.culling.face == face || b.culling.face == GL_FRONT_AND_BACK);
}

// A face that is culled is not drawn, whatever its polygon mode is.
bool shows_lines_or_points(const Bindings& b) {
  return (b.polygon_modes.front != GL_FILL && !culled(b, GL_FRONT)) ||
         (b.polygon_modes.back != GL_FILL && !culled(b, GL_BACK));
}

}  // namespace

std::optional<Cause> check_state(const DrawCall& call, const DrawConditions& conditions) {
  const Bindings& b = conditions.bindings;
  if (!is_triangle_mode(call.mode) || call.never_refined) {
    return Cause::not_triangles;
  }
  if (b.render_mode != GL_RENDER) {
    return Cause::render_mode;
  }
  if (b.transform_feedback.active && !b.transform_feedback.paused && !conditions.feedback_is_ours) {
    return Cause::transform_feedback;
  }
  if (conditions.transparent && b.queries.primitives()) {
    return Cause::primitive_query;
  }
  if (conditions.transparent && shows_lines_or_points(b)) {
    return Cause::polygon_mode;
  }
  // Without rasterization, transform feedback and a query of generated primitives still see refined triangles.
  const bool results_count = conditions.feedback_is_ours || conditions.plans_feedback || b.queries.generated() != 0;
  if (b.rasterizer_discard && !results_count) {
    return Cause::rasterizer_discard;
  }
  if (conditions.core_profile && b.vertex_array == 0) {
    return Cause::invalid_draw;
  }
  return std::nullopt;
}

}  // namespace glark::core
