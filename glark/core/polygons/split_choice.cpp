// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/polygons/split_choice.h"

#include <algorithm>

#include "glark/core/capture/layout.h"
#include "glark/core/polygons/decomposition.h"

namespace glark::polygons {
namespace {

// An input that does not vary linearly has no value at the centroid. Flat outputs take the value of the provoking
// vertex, which is a corner of only two of the triangles. An input that is constant in a draw is the same at all
// vertices.
bool gives_centroids(const core::Program& program) {
  return !program.traits.writes_flat_outputs &&
         std::none_of(program.fields.begin(), program.fields.end(), [](const capture::Field& field) {
           return capture::is_wide(field.type) ||
                  (capture::is_integer(field.type) && !capture::is_constant_in_draw(field));
         });
}

}  // namespace

bool splits_at_centroid(const core::DrawCall& call, const core::Program& program, const core::Bindings& bindings) {
  const bool told_apart =
      call.polygon_sides != nullptr || (call.whole_polygons && (call.exact || call.mode != GL_POLYGON));
  return is_polygon_mode(call.mode) && told_apart && bindings.shade_model != GL_FLAT && gives_centroids(program);
}

}  // namespace glark::polygons
