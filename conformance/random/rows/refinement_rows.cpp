// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The extension's own state. Refined outputs give the unrefined picture whatever it is; so does any refinement of depth 0,
// and a linear or flat one of a stage that is affine.
#include "conformance/random/row.h"

namespace glark::conformance {
namespace {

constexpr const char* family = "refinement";

void set(GLenum name, GLint value) { gl.ARKParameteriARK(name, value); }

// The fixed function is never affine: its coordinates of fog, for example, are not.
void refinement(World& w) {
  set(GL_REFINEMENT_ARK, w.values.pick<GLint>({GL_LINEAR_OUTPUTS_ARK, GL_LINEAR_OUTPUTS_ARK, GL_LINEAR_INPUTS_ARK,
                                               GL_LINEAR_INPUTS_ARK, GL_CURVED_PN_ARK, GL_PHONG_ARK}));
  GLint chosen = 0;
  gl.GetIntegerv(GL_REFINEMENT_ARK, &chosen);
  if (w.is_affine() || chosen == GL_LINEAR_OUTPUTS_ARK) return;
  set(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  set(GL_UNIFORM_DEPTH_LEVEL_ARK, 0);
}

bool may_be_deep(const World& w) {
  GLint chosen = 0;
  gl.GetIntegerv(GL_REFINEMENT_ARK, &chosen);
  return w.is_affine() || chosen == GL_LINEAR_OUTPUTS_ARK;
}

void depth_source(World& w) {
  if (!may_be_deep(w)) set(GL_REFINEMENT_ARK, GL_LINEAR_OUTPUTS_ARK);
  set(GL_DEPTH_SOURCE_ARK,
      w.values.pick<GLint>({GL_UNIFORM_DEPTH_ARK, GL_DEPTH_TAG_ARK, GL_DEPTH_TAG_ARK, GL_MEASURED_DEPTH_ARK}));
}

void level(World& w) {
  GLint pool = 0;
  gl.GetIntegerv(GL_POOL_LEVEL_ARK, &pool);
  if (may_be_deep(w)) set(GL_UNIFORM_DEPTH_LEVEL_ARK, w.values.between(0, pool));
}

void tag_array(World& w) {
  const std::size_t which = w.values.below(w.places.size());
  gl.BindBuffer(GL_ARRAY_BUFFER, w.places[which]);
  switch (w.values.below(4)) {
    case 0: gl.DepthTagPointerARK(GL_FLOAT, place_bytes, reinterpret_cast<const void*>(tag_offset)); break;
    case 1: gl.DepthTagPointerARK(GL_UNSIGNED_BYTE, place_bytes, reinterpret_cast<const void*>(byte_tag_offset)); break;
    case 2:
      gl.DepthTagPointerARK(GL_UNSIGNED_SHORT, place_bytes, reinterpret_cast<const void*>(short_tag_offset));
      break;
    default:
      gl.DepthTagPointerARK(GL_UNSIGNED_INT, place_bytes, reinterpret_cast<const void*>(integer_tag_offset));
      break;
  }
  if (w.is_fixed()) gl.BindBuffer(GL_ARRAY_BUFFER, 0);
  gl.Enable(GL_DEPTH_TAG_ARRAY_ARK);
}

// Heights are 0, so nothing is displaced.
void displacement_unit(World& w) {
  gl.ARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, 0);
  gl.ARKParameterfARK(GL_DISPLACEMENT_BIAS_ARK, 0);
  set(GL_DISPLACEMENT_UNIT_ARK, w.values.between(-1, 1));
}

// Without a unit, scale and bias have no effect.
void set_without_unit(World& w, GLenum name) {
  set(GL_DISPLACEMENT_UNIT_ARK, -1);
  gl.ARKParameterfARK(name, w.values.number());
}

void pool(World& w) { gl.ARKinit(static_cast<GLuint>(w.values.between(1, 4))); }

}  // namespace

Rows refinement_rows() {
  using enum Where;
  return {
      {"ARKinit", family, everywhere, pool},
      {"REFINEMENT_ARK", family, everywhere, refinement},
      {"DEPTH_SOURCE_ARK", family, everywhere, depth_source},
      {"UNIFORM_DEPTH_LEVEL_ARK", family, everywhere, level},
      {"PATTERN_INTERIOR_ARK", family, everywhere,
       [](World& w) {
         set(GL_PATTERN_INTERIOR_ARK, w.values.pick<GLint>({GL_MINIMUM_INTERIOR_ARK, GL_SMOOTH_INTERIOR_ARK}));
       }},
      {"EDGE_PIXELS_ARK", family, everywhere,
       [](World& w) {
         set(GL_EDGE_PIXELS_ARK, w.values.pick({0, 4, 8, 30}));
       }},
      {"EDGE_DEGREES_ARK", family, everywhere,
       [](World& w) {
         set(GL_EDGE_DEGREES_ARK, w.values.pick({0, 5, 180}));
       }},
      {"SCREEN_ERROR_ARK", family, everywhere,
       [](World& w) { gl.ARKParameterfARK(GL_SCREEN_ERROR_ARK, w.values.fraction()); }},
      {"TRIANGLE_BUDGET_ARK", family, everywhere,
       [](World& w) {
         set(GL_TRIANGLE_BUDGET_ARK, w.values.pick({0, 100, 5000}));
       }},
      {"GEOMORPH_ARK", family, everywhere, [](World& w) { set(GL_GEOMORPH_ARK, w.values.between(0, 1)); }},
      {"WELD_ARK", family, everywhere, [](World& w) { set(GL_WELD_ARK, w.values.between(0, 1)); }},
      {"PHONG_SHAPE_ARK", family, everywhere,
       [](World& w) { gl.ARKParameterfARK(GL_PHONG_SHAPE_ARK, w.values.fraction()); }},
      {"POLYGON_SPLIT_ARK", family, shader,
       [](World& w) {
         set(GL_POLYGON_SPLIT_ARK, w.values.pick<GLint>({GL_POLYGON_TRIANGLES_ARK, GL_POLYGON_CENTROID_ARK}));
       }},
      {"DEPTH_TAG_ATTRIBUTE_ARK", family, shader,
       [](World& w) {
         set(GL_DEPTH_TAG_ATTRIBUTE_ARK, w.values.pick({15, 14, 13}));
       }},
      {"DISPLACEMENT_UNIT_ARK", family, shader, displacement_unit},
      {"DISPLACEMENT_SCALE_ARK", family, everywhere, [](World& w) { set_without_unit(w, GL_DISPLACEMENT_SCALE_ARK); }},
      {"DISPLACEMENT_BIAS_ARK", family, everywhere, [](World& w) { set_without_unit(w, GL_DISPLACEMENT_BIAS_ARK); }},
      {"DISPLACEMENT_CHANNEL_ARK", family, everywhere,
       [](World& w) {
         set(GL_DISPLACEMENT_CHANNEL_ARK, w.values.pick<GLint>({GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA}));
       }},
      {"DISPLACEMENT_COORDINATE_ARK", family, everywhere,
       [](World& w) {
         set(GL_DISPLACEMENT_COORDINATE_ARK, w.values.pick({-1, 3, 6}));
       }},
      {"DISCONTINUITY_ATTRIBUTE_ARK", family, everywhere,
       [](World& w) {
         set(GL_DISCONTINUITY_ATTRIBUTE_ARK, w.values.pick({14, 12}));
       }},
      {"SCALAR_TAG_ATTRIBUTE_ARK", family, everywhere,
       [](World& w) {
         set(GL_SCALAR_TAG_ATTRIBUTE_ARK, w.values.pick({13, 12}));
       }},
      {"DepthTag1i", family, within_begin, [](World& w) { gl.DepthTag1i(static_cast<GLuint>(w.values.between(0, 1))); },
       compat_only, 0, true, true},
      {"DepthTag1i outside of Begin", family, everywhere,
       [](World& w) { gl.DepthTag1i(static_cast<GLuint>(w.values.between(0, 1))); }},
      {"DepthTagPointerARK", family, shader, tag_array},
      {"DEPTH_TAG_ARRAY_ARK", family, everywhere, [](World&) { gl.Disable(GL_DEPTH_TAG_ARRAY_ARK); }},
      {"Enable(ARK)", family, everywhere, [](World&) { gl.Enable(GL_ARK); }},
  };
}

}  // namespace glark::conformance
