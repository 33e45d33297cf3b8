// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Based on: The OpenGL Graphics System, version 2.1, section 2.11.4 (generating texture coordinates), and 2.11.2
// (texture matrices).
#include <algorithm>
#include <cassert>

#include "glark/core/refine/fixed_function/parts.h"

namespace glark::refine {
namespace {

bool generates(const TextureUnitState& unit, GLenum mode) {
  return unit.used && std::find(unit.generation.begin(), unit.generation.end(), mode) != unit.generation.end();
}

bool any_generates(const FixedFunctionState& state, GLenum mode) {
  return std::any_of(state.unit.begin(), state.unit.end(), [mode](const auto& unit) { return generates(unit, mode); });
}

// One coordinate (0..3: s, t, r, q; as members x, y, z, w, because GLSL's `.r` is red) of a unit before the texture
// matrix.
std::string coordinate(const FixedFunctionState& state, int unit, int component) {
  const std::string index = std::to_string(unit);
  const std::string member(1, "xyzw"[component]);
  const std::string plane(1, "STRQ"[component]);
  switch (state.unit[unit].generation[component]) {
    case GL_OBJECT_LINEAR: return "dot(gl_Vertex, gl_ObjectPlane" + plane + "[" + index + "])";
    case GL_EYE_LINEAR: return "dot(eye_position, gl_EyePlane" + plane + "[" + index + "])";
    case GL_SPHERE_MAP: assert(component < 2); return "sphere." + member;  // TexGen refuses the rest
    case GL_REFLECTION_MAP: assert(component < 3); return "reflection." + member;
    case GL_NORMAL_MAP: assert(component < 3); return "eye_normal." + member;
    default: assert(state.unit[unit].generation[component] == 0); return "gl_MultiTexCoord" + index + "." + member;
  }
}

std::string unit_statement(const FixedFunctionState& state, int unit) {
  const std::string index = std::to_string(unit);
  const auto& generation = state.unit[unit].generation;
  std::string source = "gl_MultiTexCoord" + index;
  if (std::any_of(generation.begin(), generation.end(), [](GLenum mode) { return mode != 0; })) {
    source = "vec4(";
    for (int component = 0; component < 4; ++component)
      source += (component ? ", " : "") + coordinate(state, unit, component);
    source += ")";
  }
  return "  gl_TexCoord[" + index + "] = gl_TextureMatrix[" + index + "] * " + source + ";\n";
}

}  // namespace

Needs texture_needs(const FixedFunctionState& state) {
  Needs needs;
  needs.eye_direction = any_generates(state, GL_SPHERE_MAP) || any_generates(state, GL_REFLECTION_MAP);
  needs.eye_normal = needs.eye_direction || any_generates(state, GL_NORMAL_MAP);
  needs.eye_position = any_generates(state, GL_EYE_LINEAR);
  return needs;
}

std::string texture_statements(const FixedFunctionState& state) {
  std::string text;
  if (texture_needs(state).eye_direction) text += "  vec3 reflection = reflect(eye_direction, eye_normal);\n";
  if (any_generates(state, GL_SPHERE_MAP))
    text += "  vec2 sphere = 0.5 * reflection.xy / length(reflection + vec3(0.0, 0.0, 1.0)) + 0.5;\n";
  for (int unit = 0; unit < fixed_function_texture_units; ++unit)
    if (state.unit[unit].used) text += unit_statement(state, unit);
  return text;
}

}  // namespace glark::refine
