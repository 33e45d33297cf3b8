// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/plan/polygons/polygon_capture.h"

#include "glark/core/plan/polygons/quad_capture.h"
#include "glark/core/polygons/split_choice.h"
#include "glark/core/shape.h"

namespace glark::core {

void PolygonCapture::choose_split(const DrawCall& call, DrawPlan& plan) {
  if (captures_last_vertex(env_.bindings(), env_.capabilities, call.mode)) {
    plan.capture.convention = GL_LAST_VERTEX_CONVENTION;
  }
  if (splits_polygons(env_.options, env_.ark) && env_.capabilities.is_compatibility() &&
      polygons::splits_at_centroid(call, *plan.program, env_.bindings())) {
    plan.polygons = decompositions_.find(call.mode, convention(plan));
    if (call.polygon_sides != nullptr) {
      plan.polygon_sides = *call.polygon_sides;
    }
  }
  if (!plan.polygons) {
    find_provoking_corner(call, plan);
  }
}

void PolygonCapture::find_provoking_corner(const DrawCall& call, DrawPlan& plan) {
  const Bindings& b = env_.bindings();
  const bool flat = b.shade_model == GL_FLAT || plan.program->traits.writes_flat_outputs;
  if (!flat || !polygons::is_polygon_mode(call.mode) || !env_.capabilities.is_compatibility()) {
    return;
  }
  const std::optional<polygons::Decomposition> captured = decompositions_.find(call.mode, convention(plan));
  if (!captured) {
    return;
  }
  const bool first = b.provoking_vertex == GL_FIRST_VERTEX_CONVENTION && env_.capabilities.quads_follow_convention;
  const int vertex = polygons::provoking_vertex(call.mode, first);
  const int corner = captured->common_corners[static_cast<std::size_t>(vertex)];
  if (corner < 0) {
    plan.cut = polygons::Cut{*captured, vertex};
  }
  plan.provoking_corner = corner < 0 ? 2 : corner;
}

GLenum PolygonCapture::convention(const DrawPlan& plan) const {
  return plan.capture.convention != 0 ? plan.capture.convention : env_.bindings().provoking_vertex;
}

void PolygonCapture::follow_drawn_diagonal(const DrawCall& call, DrawPlan& plan) {
  const Bindings& b = env_.bindings();
  const bool moves = traits_of(plan.derived->refinement).curves_positions || displaces(env_.options, env_.ark);
  const QuadFacts facts{.mode = call.mode,
                        .polygon_mode = b.polygon_modes.either(),
                        .shade_model = b.shade_model,
                        .writes_flat_outputs = plan.program->traits.writes_flat_outputs,
                        .moves_vertices = moves,
                        .split = plan.polygons.has_value()};
  if (!env_.capabilities.is_compatibility() || !follows_drawn_diagonal(facts)) {
    return;
  }
  const std::optional<polygons::Diagonal> drawn = diagonals_.find(call.mode, quad_source(call));
  const auto captured_so = [&](GLenum convention) {
    const std::optional<polygons::Decomposition> captured = decompositions_.find(call.mode, convention);
    return captured && polygons::diagonal_of(*captured) == *drawn;
  };
  const GLenum other = other_convention(convention(plan));
  if (drawn && !captured_so(convention(plan)) && captured_so(other)) {
    plan.capture.convention = other == b.provoking_vertex ? 0 : other;
  }
}

}  // namespace glark::core
