// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The parts of the fixed-function vertex shader: each returns statements for the body of main(). They may read these
// locals, which fixed_function.cpp declares before them when `Needs` says so:
//   vec4 eye_position   the vertex in eye space, homogeneous
//   vec3 eye_point      the same, divided by w
//   vec3 eye_direction  unit vector from the eye to the vertex
//   vec3 eye_normal     the normal in eye space, rescaled or normalised
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "glark/core/refine/fixed_function/fixed_function.h"

namespace glark::refine {

struct Needs {
  bool eye_position = false;
  bool eye_point = false;
  bool eye_direction = false;
  bool eye_normal = false;
};

using Substitutions = std::vector<std::pair<std::string_view, std::string>>;

// `text` with every key replaced by its value; keys are tried in their order.
std::string substitute(std::string_view text, const Substitutions& substitutions);

// Declares the inputs that carry the material.
std::string material_declarations(const FixedFunctionState& state);
// gl_Front/BackColor and gl_Front/BackSecondaryColor of a lit vertex.
Needs lighting_needs(const FixedFunctionState& state);
std::string lighting_statements(const FixedFunctionState& state);

// gl_TexCoord[] of every used unit.
Needs texture_needs(const FixedFunctionState& state);
std::string texture_statements(const FixedFunctionState& state);

}  // namespace glark::refine
