// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The fixed-function vertex stage as a GLSL vertex shader (compatibility profile), so that it can be derived like any other.
#pragma once

#include <array>
#include <compare>
#include <string>

#include "glark/gl/types.h"

namespace glark::refine {

inline constexpr int fixed_function_lights = 8;
inline constexpr int fixed_function_texture_units = 8;

struct TextureUnitState {
  bool used = false;                        // a texture target of the unit is enabled, or a fragment program may read gl_TexCoord
  std::array<GLenum, 4> generation{};       // per coordinate S, T, R, Q: 0 (off), GL_OBJECT_LINEAR, GL_EYE_LINEAR,
                                            // GL_SPHERE_MAP, GL_REFLECTION_MAP, GL_NORMAL_MAP
  auto operator<=>(const TextureUnitState&) const = default;
};

// The enables and modes that shape the shader; values (colours, planes, matrices) are read through GLSL's built-in state.
struct FixedFunctionState {
  bool lighting = false;
  std::array<bool, fixed_function_lights> light{};
  bool two_sided = false;
  bool local_viewer = false;
  bool separate_specular = false;
  bool color_sum = false;
  bool color_material = false;
  GLenum color_material_face = 0;       // GL_FRONT, GL_BACK, GL_FRONT_AND_BACK
  GLenum color_material_parameter = 0;  // GL_AMBIENT_AND_DIFFUSE, ...
  bool normalize = false;
  bool rescale_normal = false;
  bool fog = false;
  bool fog_from_coordinate = false;     // GL_FOG_COORDINATE_SOURCE is GL_FOG_COORDINATE
  bool clip_planes = false;             // any user clip plane enabled
  bool point_size = false;              // point parameters attenuate
  std::array<TextureUnitState, fixed_function_texture_units> unit{};
  auto operator<=>(const FixedFunctionState&) const = default;
};

// A complete vertex shader ("#version 150 compatibility") that writes what the fixed function of `state` computes per vertex:
// gl_Position, gl_Front/BackColor, gl_Front/BackSecondaryColor, gl_TexCoord[], gl_FogFragCoord, gl_ClipVertex, gl_PointSize.
std::string fixed_function_vertex_shader(const FixedFunctionState& state);

}  // namespace glark::refine
