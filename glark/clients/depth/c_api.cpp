// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/c/depth.h>
#include <glark/depth.h>

#include <memory>

#include "glark/clients/common/c_boundary.h"

using glark::c::enumeration_of;
using glark::c::needed;
using glark::c::span_of;
namespace depth = glark::depth;

struct glark_depth_tagger {
  depth::Tagger tagger;
};

namespace {

static_assert(static_cast<int>(depth::EdgeRule::geomorph) == GLARK_DEPTH_GEOMORPH);

template <class Step>
glark_code guarded(glark_error* error, const Step& step) {
  return glark::c::guarded<depth::Error>(error, step);
}

depth::Vector vector_of(const float (&v)[3]) { return {v[0], v[1], v[2]}; }

depth::View view_of(const glark_depth_view& view) {
  return {.eye = vector_of(view.eye), .pixels_at_one = view.pixels_at_one, .nearest = view.nearest};
}

depth::EdgeRule rule_of(glark_depth_edge_rule rule) { return enumeration_of(rule, depth::EdgeRule::geomorph, "rule"); }

depth::Tagger& tagger_of(glark_depth_tagger* tagger) { return needed(tagger, "tagger").tagger; }
const depth::Tagger& tagger_of(const glark_depth_tagger* tagger) { return needed(tagger, "tagger").tagger; }

}  // namespace

glark_depth_distance_range glark_depth_default_distance_range(void) {
  const depth::DistanceRange range;
  return {
      {range.point[0], range.point[1], range.point[2]}, range.nearest, range.farthest, range.finest, range.coarsest};
}

glark_depth_view glark_depth_default_view(void) {
  const depth::View view;
  return {{view.eye[0], view.eye[1], view.eye[2]}, view.pixels_at_one, view.nearest};
}

glark_code glark_depth_tagger_create(size_t vertices, glark_indices triangles, unsigned max_level,
                                     glark_depth_tagger** tagger, glark_error* error) {
  return guarded(error, [&] {
    glark_depth_tagger*& result = needed(tagger, "tagger");
    result = std::make_unique<glark_depth_tagger>(
                 glark_depth_tagger{depth::Tagger(vertices, span_of(triangles, "triangles"), max_level)})
                 .release();
  });
}

void glark_depth_tagger_free(glark_depth_tagger* tagger) { std::unique_ptr<glark_depth_tagger>{tagger}; }

glark_code glark_depth_manual(const glark_depth_tagger* tagger, glark_floats wanted, glark_float_output tags,
                              glark_error* error) {
  return guarded(error, [&] { tagger_of(tagger).manual(span_of(wanted, "wanted"), span_of(tags, "tags")); });
}

glark_code glark_depth_by_distance(const glark_depth_tagger* tagger, glark_floats positions,
                                   const glark_depth_distance_range* range, glark_float_output tags,
                                   glark_error* error) {
  return guarded(error, [&] {
    const glark_depth_distance_range& given = needed(range, "range");
    tagger_of(tagger).by_distance(span_of(positions, "positions"),
                                  {.point = vector_of(given.point),
                                   .nearest = given.nearest,
                                   .farthest = given.farthest,
                                   .finest = given.finest,
                                   .coarsest = given.coarsest},
                                  span_of(tags, "tags"));
  });
}

glark_code glark_depth_by_edge_length(glark_depth_tagger* tagger, glark_floats positions, const glark_depth_view* view,
                                      float pixels, glark_float_output tags, glark_error* error) {
  return guarded(error, [&] {
    tagger_of(tagger).by_edge_length(span_of(positions, "positions"), view_of(needed(view, "view")), pixels,
                                     span_of(tags, "tags"));
  });
}

glark_code glark_depth_by_curvature(glark_depth_tagger* tagger, glark_floats positions, glark_floats normals,
                                    float tolerance, glark_float_output tags, glark_error* error) {
  return guarded(error, [&] {
    tagger_of(tagger).by_curvature(span_of(positions, "positions"), span_of(normals, "normals"), tolerance,
                                   span_of(tags, "tags"));
  });
}

glark_code glark_depth_by_curvature_on_screen(glark_depth_tagger* tagger, glark_floats positions, glark_floats normals,
                                              const glark_depth_view* view, float pixels, glark_float_output tags,
                                              glark_error* error) {
  return guarded(error, [&] {
    tagger_of(tagger).by_curvature(span_of(positions, "positions"), span_of(normals, "normals"),
                                   view_of(needed(view, "view")), pixels, span_of(tags, "tags"));
  });
}

glark_code glark_depth_by_displacement(glark_depth_tagger* tagger, glark_floats coordinates,
                                       const glark_depth_height_map* map, float tolerance, glark_float_output tags,
                                       glark_error* error) {
  return guarded(error, [&] {
    const glark_depth_height_map& given = needed(map, "map");
    tagger_of(tagger).by_displacement(
        span_of(coordinates, "coordinates"),
        {.heights = span_of(given.heights, "heights"), .width = given.width, .height = given.height}, tolerance,
        span_of(tags, "tags"));
  });
}

glark_code glark_depth_principal_curvatures(glark_depth_tagger* tagger, glark_floats positions, glark_floats normals,
                                            glark_float_output greater, glark_float_output lesser, glark_error* error) {
  return guarded(error, [&] {
    tagger_of(tagger).principal_curvatures(span_of(positions, "positions"), span_of(normals, "normals"),
                                           span_of(greater, "greater"), span_of(lesser, "lesser"));
  });
}

glark_code glark_depth_take_greater(const glark_depth_tagger* tagger, glark_floats other, glark_float_output tags,
                                    glark_error* error) {
  return guarded(error, [&] { tagger_of(tagger).take_greater(span_of(other, "other"), span_of(tags, "tags")); });
}

glark_code glark_depth_take_lesser(const glark_depth_tagger* tagger, glark_floats other, glark_float_output tags,
                                   glark_error* error) {
  return guarded(error, [&] { tagger_of(tagger).take_lesser(span_of(other, "other"), span_of(tags, "tags")); });
}

glark_code glark_depth_blend(const glark_depth_tagger* tagger, glark_floats other, float weight,
                             glark_float_output tags, glark_error* error) {
  return guarded(error, [&] { tagger_of(tagger).blend(span_of(other, "other"), weight, span_of(tags, "tags")); });
}

glark_code glark_depth_refined_triangles(const glark_depth_tagger* tagger, glark_floats tags,
                                         glark_depth_edge_rule rule, uint64_t* triangles, glark_error* error) {
  return guarded(error, [&] {
    uint64_t& result = needed(triangles, "triangles");
    result = tagger_of(tagger).refined_triangles(span_of(tags, "tags"), rule_of(rule));
  });
}

glark_code glark_depth_keep_budget(const glark_depth_tagger* tagger, uint64_t triangles, glark_float_output tags,
                                   glark_depth_edge_rule rule, glark_depth_budget* budget, glark_error* error) {
  return guarded(error, [&] {
    glark_depth_budget& result = needed(budget, "budget");
    const depth::Budget kept = tagger_of(tagger).keep_budget(triangles, span_of(tags, "tags"), rule_of(rule));
    result = {kept.bias, kept.triangles, kept.kept};
  });
}
