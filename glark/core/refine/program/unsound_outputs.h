// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The outputs of a vertex stage that keep their picture only if they are interpolated between the corners.
#pragma once

#include <string>
#include <vector>

#include "glark/core/state/programs/vertex_stage_traits.h"

namespace glark::refine {

// Returns whether an output is a colour, by its name: "gl_FrontColor", "v_diffuse", "fog". Vertex lighting often jumps
// where a light comes over the horizon, and such a jump may lie anywhere between two vertices. In a texture coordinate
// or a number it would name something else.
bool is_color(const std::string& path);

// The outputs, gl_Position aside, for which running the stage between the corners is not sound:
// - values without a meaning between vertices;
// - values that jump, unless they are colours of a surface;
// - values that are not affine, unless the mesh is known to be a surface.
std::vector<OutputVariation> unsound_outputs(const StageVariation& stage, bool is_surface);

}  // namespace glark::refine
