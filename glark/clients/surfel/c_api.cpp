// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/c/surfel.h>
#include <glark/surfel.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <new>
#include <vector>

#include "glark/clients/common/c_boundary.h"

using glark::c::array_of;
using glark::c::needed;
using glark::c::span_of;
namespace surfel = glark::surfel;

struct glark_surfel_strips {
  surfel::Strips strips;
  std::vector<surfel::Range> changed = {};  // by the last update
};
struct glark_surfel_frame {
  surfel::Frame frame;
};

namespace {

// Nodes and ranges are given out as they are.
static_assert(sizeof(glark_surfel_node) == sizeof(surfel::Node));
static_assert(offsetof(glark_surfel_node, cone_sine) == offsetof(surfel::Node, cone_sine));
static_assert(offsetof(glark_surfel_node, representative) == offsetof(surfel::Node, representative));
static_assert(sizeof(glark_surfel_range) == sizeof(surfel::Range));
static_assert(offsetof(glark_surfel_range, count) == offsetof(surfel::Range, count));
static_assert(static_cast<int>(surfel::Element::view) == GLARK_SURFEL_VIEW);

template <class Step>
glark_code guarded(glark_error* error, const Step& step) {
  return glark::c::guarded<surfel::Error>(error, step);
}

surfel::Cloud cloud_of(const glark_surfel_cloud& cloud) {
  return {.positions = span_of(cloud.positions, "positions"), .normals = span_of(cloud.normals, "normals")};
}

surfel::Options options_of(const glark_surfel_options& options) {
  return {.leaf_points = options.leaf_points,
          .delta_a = options.delta_a,
          .delta_d = options.delta_d,
          .inflation = options.inflation,
          .reach = options.reach,
          .turn_edges = options.turn_edges,
          .levels = options.levels,
          .threads = options.threads};
}

surfel::View view_of(const glark_surfel_view& view) {
  surfel::View result{.width = view.width,
                      .height = view.height,
                      .cull_frustum = view.cull_frustum,
                      .cull_back_faces = view.cull_back_faces,
                      .point_pixels = view.point_pixels,
                      .level_pixels = view.level_pixels};
  std::ranges::copy(view.clip_from_object, result.clip_from_object.begin());
  return result;
}

}  // namespace

glark_surfel_options glark_surfel_default_options(void) {
  const surfel::Options options;
  return {options.leaf_points, options.delta_a,    options.delta_d, options.inflation,
          options.reach,       options.turn_edges, options.levels,  options.threads};
}

glark_surfel_view glark_surfel_default_view(void) {
  const surfel::View view;
  glark_surfel_view result{};
  result.cull_frustum = view.cull_frustum;
  result.cull_back_faces = view.cull_back_faces;
  result.point_pixels = view.point_pixels;
  result.level_pixels = view.level_pixels;
  return result;
}

glark_code glark_surfel_strips_create(const glark_surfel_cloud* cloud, const glark_surfel_options* options,
                                      glark_surfel_strips** strips, glark_error* error) {
  return guarded(error, [&] {
    const surfel::Cloud given = cloud_of(needed(cloud, "cloud"));
    glark_surfel_strips*& result = needed(strips, "strips");
    const surfel::Options wanted = options == nullptr ? surfel::Options{} : options_of(*options);
    result = std::make_unique<glark_surfel_strips>(glark_surfel_strips{surfel::Strips(given, wanted)}).release();
  });
}

void glark_surfel_strips_free(glark_surfel_strips* strips) { std::unique_ptr<glark_surfel_strips>{strips}; }

size_t glark_surfel_strips_point_count(const glark_surfel_strips* strips) {
  if (strips == nullptr) return {};
  return strips->strips.point_count();
}
glark_indices glark_surfel_strips_indices(const glark_surfel_strips* strips) {
  if (strips == nullptr) return {};
  return array_of(strips->strips.indices());
}
unsigned glark_surfel_strips_level_count(const glark_surfel_strips* strips) {
  if (strips == nullptr) return {};
  return strips->strips.level_count();
}

glark_code glark_surfel_strips_nodes(const glark_surfel_strips* strips, unsigned level, glark_surfel_nodes* nodes,
                                     glark_error* error) {
  return guarded(error, [&] {
    glark_surfel_nodes& result = needed(nodes, "nodes");
    const auto found = needed(strips, "strips").strips.nodes(level);
    result = {reinterpret_cast<const glark_surfel_node*>(found.data()), found.size()};
  });
}

glark_code glark_surfel_strips_counts(const glark_surfel_strips* strips, unsigned level, glark_surfel_counts* counts,
                                      glark_error* error) {
  return guarded(error, [&] {
    glark_surfel_counts& result = needed(counts, "counts");
    const surfel::Counts found = needed(strips, "strips").strips.counts(level);
    result = {found.outer,  found.redundant, found.dual,    found.valid,       found.out_of_reach,
              found.turned, found.strips,    found.indices, found.loose_points};
  });
}

glark_surfel_frame* glark_surfel_frame_create(void) { return new (std::nothrow) glark_surfel_frame; }
void glark_surfel_frame_free(glark_surfel_frame* frame) { std::unique_ptr<glark_surfel_frame>{frame}; }

glark_code glark_surfel_strips_select(const glark_surfel_strips* strips, const glark_surfel_view* view,
                                      glark_surfel_frame* frame, glark_error* error) {
  return guarded(error, [&] {
    needed(strips, "strips").strips.select(view_of(needed(view, "view")), needed(frame, "frame").frame);
  });
}

int32_t glark_surfel_frame_draws(const glark_surfel_frame* frame) {
  if (frame == nullptr) return {};
  return frame->frame.draws();
}
const int32_t* glark_surfel_frame_counts(const glark_surfel_frame* frame) {
  return frame == nullptr ? nullptr : frame->frame.counts.data();
}
const void* const* glark_surfel_frame_offsets(const glark_surfel_frame* frame) {
  return frame == nullptr ? nullptr : frame->frame.offsets.data();
}
glark_indices glark_surfel_frame_points(const glark_surfel_frame* frame) {
  if (frame == nullptr) return {};
  return array_of(frame->frame.points);
}

glark_surfel_frame_statistics glark_surfel_frame_numbers(const glark_surfel_frame* frame) {
  if (frame == nullptr) return {};
  const surfel::Frame& numbers = frame->frame;
  return {numbers.level, numbers.indices, numbers.strips, numbers.visited, numbers.out_of_frustum, numbers.back_faces};
}

glark_code glark_surfel_strips_update(glark_surfel_strips* strips, const glark_surfel_cloud* cloud, glark_indices moved,
                                      glark_surfel_ranges* ranges, glark_error* error) {
  return guarded(error, [&] {
    glark_surfel_strips& updated = needed(strips, "strips");
    updated.changed = updated.strips.update(cloud_of(needed(cloud, "cloud")), span_of(moved, "moved"));
    if (ranges != nullptr) {
      *ranges = {reinterpret_cast<const glark_surfel_range*>(updated.changed.data()), updated.changed.size()};
    }
  });
}
