// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/plan/programs/derived_key.h"

#include <algorithm>

#include "glark/core/capture/layout.h"
#include "glark/core/plan/polygons/quad_capture.h"
#include "glark/core/shape.h"
#include "glark/core/weld/weld.h"

namespace glark::core {

namespace {

// Whether a refined vertex shows which corner is the provoking vertex.
bool has_provoking_corner(const Program& program, const DerivedKey& key) {
  return key.flat_colors || program.traits.copies_provoking_vertex ||
         std::any_of(program.fields.begin(), program.fields.end(), [](const capture::Field& field) {
           return capture::is_integer(field.type) && !capture::is_constant_in_draw(field);
         });
}

}  // namespace

DerivedKey derived_key(const KeyState& state, const Program& program, const KeyRequest& request) {
  const Bindings& b = state.bindings;
  const bool transparent = state.options.transparent;
  const bool compatibility = state.capabilities.is_compatibility();
  const bool first =
      b.provoking_vertex == GL_FIRST_VERTEX_CONVENTION && !captures_last_vertex(b, state.capabilities, request.mode);
  DerivedKey key;
  key.refinement = request.refinement;
  key.flat_colors = compatibility && b.shade_model == GL_FLAT;
  if (first && has_provoking_corner(program, key)) {
    key.provoking_corner = 0;
  }
  key.clamp_colors = compatibility && b.clamp_vertex_color;
  key.tagged = request.tagged;
  key.welded = transparent ? state.options.weld : state.ark.weld;
  key.placed = request.placed;
  key.morphing = request.morphing;
  add_shape(state.options, state.ark, key);
  return key;
}

float crease_of(const ContextOptions& options) { return options.transparent ? options.crease : weld::no_crease; }

void add_welded_words(DerivedKey& key, bool turns) {
  key.turns = key.welded && turns;
  key.border = key.welded && key.displaced;
}

}  // namespace glark::core
