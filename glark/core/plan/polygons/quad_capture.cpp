// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/plan/polygons/quad_capture.h"

namespace glark::core {
namespace {

bool is_quad_mode(GLenum mode) { return mode == GL_QUADS || mode == GL_QUAD_STRIP; }

}  // namespace

bool captures_last_vertex(const Bindings& bindings, const Capabilities& capabilities, GLenum mode) {
  return bindings.provoking_vertex == GL_FIRST_VERTEX_CONVENTION && !capabilities.quads_follow_convention &&
         is_quad_mode(mode);
}

bool follows_drawn_diagonal(const QuadFacts& facts) {
  return is_quad_mode(facts.mode) && facts.polygon_mode == GL_FILL && facts.shade_model != GL_FLAT &&
         !facts.writes_flat_outputs && !facts.moves_vertices && !facts.split;
}

polygons::QuadSource quad_source(const DrawCall& call) {
  if (call.list_segment != 0 && !call.calls_vertex_lists) {
    return polygons::QuadSource::list;
  }
  if (!call.from_arrays) {
    return polygons::QuadSource::immediate;
  }
  return call.indexed ? polygons::QuadSource::elements : polygons::QuadSource::arrays;
}

}  // namespace glark::core
