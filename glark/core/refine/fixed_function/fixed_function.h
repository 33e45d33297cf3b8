// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The fixed-function vertex stage as a GLSL vertex shader (compatibility profile), so that it can be derived like
// others.
#pragma once

#include <array>
#include <compare>
#include <string>

#include "glark/core/state/fixed_function/material_parameters.h"
#include "glark/gl/types.h"

namespace glark::refine {

inline constexpr int fixed_function_lights = 8;
inline constexpr int fixed_function_texture_units = 8;

struct TextureUnitState {
  bool used = false;  // a texture target of the unit is enabled, or a fragment program may read gl_TexCoord
  std::array<GLenum, 4> generation{};  // per coordinate S, T, R, Q: 0 (off), GL_OBJECT_LINEAR, GL_EYE_LINEAR,
                                       // GL_SPHERE_MAP, GL_REFLECTION_MAP, GL_NORMAL_MAP
  auto operator<=>(const TextureUnitState&) const = default;
};

// The enables and modes that shape the shader; values (colours, planes, matrices) are read through GLSL's built-in
// state.
struct FixedFunctionState {
  bool lighting = false;
  std::array<bool, fixed_function_lights> light{};
  bool two_sided = false;
  bool local_viewer = false;
  bool separate_specular = false;
  bool color_sum = false;  // GL_COLOR_SUM, or a fragment shader reads gl_SecondaryColor
  bool color_material = false;
  GLenum color_material_face = 0;       // GL_FRONT, GL_BACK, GL_FRONT_AND_BACK
  GLenum color_material_parameter = 0;  // GL_AMBIENT_AND_DIFFUSE, ...
  bool normalize = false;
  bool rescale_normal = false;
  bool fog = false;                                // GL_FOG, or a fragment shader reads gl_FogFragCoord
  bool fog_from_coordinate = false;                // GL_FOG_COORDINATE_SOURCE is GL_FOG_COORDINATE
  GLenum fog_distance = GL_EYE_PLANE_ABSOLUTE_NV;  // GL_FOG_DISTANCE_MODE_NV, where GL_NV_fog_distance exists
  bool clip_planes = false;                        // any user clip plane enabled
  bool point_size = false;                         // point parameters attenuate
  bool program_point_size = false;                 // the application's GL_PROGRAM_POINT_SIZE, which the shader ignores
  std::array<TextureUnitState, fixed_function_texture_units> unit{};
  // glMaterial is called between the vertices. Only with lighting.
  core::MaterialAttributes material_attribute = core::no_material_attributes();
  auto operator<=>(const FixedFunctionState&) const = default;
};

// A complete vertex shader ("#version 150 compatibility") that writes the outputs of the fixed function in `state`:
// gl_Position, gl_Front/BackColor, gl_Front/BackSecondaryColor, gl_TexCoord[], gl_FogFragCoord, gl_ClipVertex,
// gl_PointSize. It reads no attribute that the state does not need. It does not clamp colours: GL_CLAMP_VERTEX_COLOR
// acts after it.
//
// Where Mesa 22.3's fixed
// function differs from OpenGL 2.1, the shader follows OpenGL 2.1; fixed_function_test.cpp lists the differences.
//
// GL treats some state differently when a vertex shader is active. A caller that draws with the shader sets this state,
// and restores it afterwards:
//   GL_VERTEX_PROGRAM_TWO_SIDE    to `lighting && two_sided`, else the back colour is never (or wrongly) selected;
//   GL_VERTEX_PROGRAM_POINT_SIZE  to `point_size`, else gl_PointSize is ignored (or read though not written);
//   GL_COLOR_SUM                  on if `lighting && separate_specular`: fixed function adds the specular by itself.
std::string fixed_function_vertex_shader(const FixedFunctionState& state);

}  // namespace glark::refine
