// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include "glark/core/context_options.h"
#include "glark/gl/types.h"

namespace glark::core {

enum class DepthSource { tag, uniform, measured };
enum class PolygonSplit { triangles, centroid };

// Refined positions move along their normals by scale * texel + bias.
struct Displacement {
  int unit = -1;         // texture image unit with a two-dimensional texture; -1: none
  unsigned channel = 0;  // of the texel
  int coordinate = -1;   // location of the attribute with the texture coordinate; -1: by its role
  float scale = 1;
  float bias = 0;
  bool on() const { return unit >= 0; }
  bool operator==(const Displacement&) const = default;
};

// The state of GL_ARK_adaptive_refinement ("New State" of the specification).
struct ArkState {
  bool enabled = false;
  int pool_level = -1;  // -1 before glARKinit
  Refinement refinement = Refinement::linear_inputs;
  ShapeNumbers shape_numbers = initial_shape_numbers();
  DepthSource depth_source = DepthSource::tag;
  GLuint uniform_level = 0;
  EdgeMeasure measure{.pixels = 8};
  GLint edge_pixels = 8;  // measure.pixels, not rounded
  GLuint tag_attribute = 15;
  GLuint discontinuity_attribute = 14;
  GLuint scalar_tag_attribute = 13;
  Displacement displacement;
  PolygonSplit polygon_split = PolygonSplit::triangles;
  bool smooth_interior = false;
  bool geomorph = false;
  bool weld = false;
  bool tag_array = false;
  bool operator==(const ArkState&) const = default;
};

// An application that uses the extension decides for itself; otherwise the user decides.
inline bool splits_polygons(const ContextOptions& options, const ArkState& ark) {
  return options.transparent ? options.centroids : ark.polygon_split == PolygonSplit::centroid;
}
inline bool geomorphs(const ContextOptions& options, const ArkState& ark) {
  return options.transparent ? options.geomorph : ark.geomorph;
}

}  // namespace glark::core
