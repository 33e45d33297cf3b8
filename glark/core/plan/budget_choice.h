// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What a budget of triangles pays for, in transparent refinement by curved triangles: surfaces that depth makes rounder.
// No GL.
// - Edges that stay straight, and so flat triangles, have depth 0 and do not count.
// - Draws that cannot be curved, and backgrounds, stay as they are.
// - Passes without colours do not count: the budget pays once for a mesh, not for its shadow map or its depth pre-pass.
//   They have the depths that they would have anyway, so they still meet the pass with colours.
// A program that calls the extension gets the budget of the extension's text.
#pragma once

#include "glark/core/ark_state.h"
#include "glark/core/context_options.h"
#include "glark/core/depth/depth_plan.h"
#include "glark/core/state/bindings.h"

namespace glark::core {

// Returns whether the budget goes to what shows. `wanted`: of the draw. `depth`: where its depths come from.
bool spends_on_curves(const ContextOptions& options, const ArkState& ark, Refinement wanted,
                      const depth::DepthPlan& depth);

// What a draw does to the depth and colour buffers.
struct VisibilityFacts {
  const Bindings& bindings;
  bool depth_buffer = true;         // the framebuffer has one
  bool color_buffer = true;         // the framebuffer has one that is drawn to
  bool others_write_depth = false;  // other draws of this or the last frame
  bool mesh_writes_depth = false;   // another pass over the mesh, in this or the last frame
};

// Returns whether everything else that is drawn with depth hides the draw, or stands before it.
bool is_background(const VisibilityFacts& facts);
bool draws_colors(const VisibilityFacts& facts);

}  // namespace glark::core
