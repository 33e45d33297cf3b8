// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Cases of refinements and of interplay that are planned and not written.
#include "conformance/cases/cases.h"

namespace glark::conformance {

Cases planned_refinement_cases() {
  const std::vector<Api> compat = {Api::gl_compat};
  return {
      {.name = "ark.pn.formula.one_place",
       .clauses = {"11.R.7-17"},
       .plan = "All corners in one place: every refined vertex has the bits of P_0."},
      {.name = "ark.displacement.texture_matrix",
       .clauses = {"11.R.7b-4"},
       .plan = "A texture matrix that is not the identity changes nothing, fixed function.",
       .apis = compat},
      {.name = "ark.refinement_shader.fixed_function",
       .clauses = {"11.R.9-4", "11.R.9-16"},
       .plan = "Program 0 has a refinement shader that moves gl_Vertex by ark_corner_gl_Vertex.",
       .apis = compat},
      {.name = "ark.weld.instances",
       .clauses = {"11.R.15-5"},
       .plan = "Two instances of one triangle, moved by an attribute with a divisor, each with tags of its own."},
      {.name = "ark.weld.tagged.crease",
       .clauses = {"11.R.15-16"},
       .plan = "Two triangles along a crease share its control points, by bits."},
      {.name = "ark.weld.measured_turns",
       .clauses = {"11.R.15-17", "11.R.15-18"},
       .plan = "Two sides of an edge with different turns of the normal have the greater depth, for each refinement."},
      {.name = "ark.weld.displacement.position",
       .clauses = {"11.R.15-21", "11.R.15-22", "11.R.15-31", "11.R.15-33"},
       .plan = "A seam of texture coordinates and normals, displaced: both sides have the same positions, by bits."},
      {.name = "ark.weld.displacement.normal",
       .clauses = {"11.R.15-23", "11.R.15-24", "11.R.15-25", "11.R.15-30"},
       .plan = "The displacement at a seam goes along the normal of the place, worked out from its triangles."},
      {.name = "ark.weld.displacement.coordinate",
       .clauses = {"11.R.15-26", "11.R.15-27", "11.R.15-28", "11.R.15-29", "11.R.15-32", "11.R.15-34"},
       .plan = "The coordinate at a seam is that of the dominant side, and at a corner the least."},
      {.name = "ark.interplay.conditional_rendering",
       .clauses = {"11.R.10-1"},
       .plan = "A refined draw within conditional rendering is drawn, or not, as the query says."},
      {.name = "ark.interplay.share_group",
       .clauses = {"11.R.1-3"},
       .plan = "Two contexts share programs and buffers, each with parameters of its own, and draw in turn."},
      {.name = "ark.interplay.threads",
       .clauses = {"11.R.1-3"},
       .plan = "Two threads with a context each draw refined scenes at the same time."},
      {.name = "ark.robustness.draws",
       .clauses = {"11.R.11-1"},
       .plan = "Counts of 0, empty buffers, an incomplete framebuffer, deleted objects in use: the errors of the "
               "unrefined draw, no crash."},
      {.name = "ark.robustness.indices",
       .clauses = {"11.R.11-1"},
       .plan = "Indices out of range in a context with robust access: no crash."},
  };
}

}  // namespace glark::conformance
