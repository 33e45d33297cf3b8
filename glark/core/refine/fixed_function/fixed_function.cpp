// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/fixed_function/fixed_function.h"

#include "glark/core/refine/fixed_function/parts.h"

namespace glark::refine {
namespace {

// Fixed function gives a vertex the same position for every lighting, texturing and fog (OpenGL 2.1, appendix A.3).
// Multipass applications test depth for equality. Without `invariant`, two of these shaders may differ in the last bit.
constexpr std::string_view version = "#version 150 compatibility\n";
constexpr std::string_view invariant_position = "invariant gl_Position;\n";
constexpr std::string_view locations = "#extension GL_ARB_explicit_attrib_location : require\n";

// GLSL leaves pow(0, 0) undefined; lighting takes it as 1.
constexpr std::string_view power_function = R"(
float power(float base, float exponent) { return exponent == 0.0 ? 1.0 : pow(max(base, 0.0), exponent); }
)";

constexpr std::string_view point_size_statements = R"(
  float eye_distance = abs(eye_position.z);
  float attenuation = gl_Point.distanceConstantAttenuation +
      eye_distance * (gl_Point.distanceLinearAttenuation + eye_distance * gl_Point.distanceQuadraticAttenuation);
  gl_PointSize = clamp(gl_Point.size * inversesqrt(attenuation), gl_Point.sizeMin, gl_Point.sizeMax);
)";

Needs operator|(const Needs& a, const Needs& b) {
  return {a.eye_position || b.eye_position, a.eye_point || b.eye_point, a.eye_direction || b.eye_direction,
          a.eye_normal || b.eye_normal};
}

// Adds the values that each needed value is computed from.
Needs closed(Needs needs) {
  needs.eye_point = needs.eye_point || needs.eye_direction;
  needs.eye_position = needs.eye_position || needs.eye_point;
  return needs;
}

Needs needs_of(const FixedFunctionState& state) {
  Needs needs = texture_needs(state);
  if (state.lighting) needs = needs | lighting_needs(state);
  if (state.fog && !state.fog_from_coordinate) {
    needs.eye_position = true;
    needs.eye_point = needs.eye_point || state.fog_distance == GL_EYE_RADIAL_NV;
  }
  needs.eye_position = needs.eye_position || state.clip_planes || state.point_size;
  return closed(needs);
}

std::string eye_normal_statement(const FixedFunctionState& state) {
  if (state.normalize) return "  vec3 eye_normal = normalize(gl_NormalMatrix * gl_Normal);\n";
  // Not gl_NormalScale: NVIDIA (580) gives its inverse. OpenGL 4.6 compatibility, 12.1.3.
  if (state.rescale_normal)
    return "  vec3 eye_normal = inversesqrt(dot(gl_NormalMatrix[2], gl_NormalMatrix[2])) * (gl_NormalMatrix * "
           "gl_Normal);\n";
  return "  vec3 eye_normal = gl_NormalMatrix * gl_Normal;\n";
}

std::string eye_space_statements(const FixedFunctionState& state) {
  const Needs needs = needs_of(state);
  std::string text;
  if (needs.eye_position) text += "  vec4 eye_position = gl_ModelViewMatrix * gl_Vertex;\n";
  if (needs.eye_point)
    text += "  vec3 eye_point = eye_position.w == 0.0 ? eye_position.xyz : eye_position.xyz / eye_position.w;\n";
  if (needs.eye_direction) text += "  vec3 eye_direction = normalize(eye_point);\n";
  if (needs.eye_normal) text += eye_normal_statement(state);
  return text;
}

std::string unlit_statements(const FixedFunctionState& state) {
  std::string text = "  gl_FrontColor = gl_Color;\n  gl_BackColor = gl_Color;\n";
  if (state.color_sum)
    text += "  gl_FrontSecondaryColor = gl_SecondaryColor;\n  gl_BackSecondaryColor = gl_SecondaryColor;\n";
  return text;
}

std::string fog_statement(const FixedFunctionState& state) {
  if (!state.fog) return {};
  if (state.fog_from_coordinate) return "  gl_FogFragCoord = gl_FogCoord;\n";
  if (state.fog_distance == GL_EYE_RADIAL_NV) return "  gl_FogFragCoord = length(eye_point);\n";
  if (state.fog_distance == GL_EYE_PLANE) return "  gl_FogFragCoord = eye_position.z;\n";
  return "  gl_FogFragCoord = abs(eye_position.z);\n";
}

}  // namespace

std::string substitute(std::string_view text, const Substitutions& substitutions) {
  std::string result;
  while (!text.empty()) {
    std::string_view consumed = text.substr(0, 1);
    std::string_view written = consumed;
    for (const auto& [key, value] : substitutions) {
      if (!text.starts_with(key)) continue;
      consumed = key;
      written = value;
      break;
    }
    result += written;
    text.remove_prefix(consumed.size());
  }
  return result;
}

std::string fixed_function_vertex_shader(const FixedFunctionState& state) {
  std::string text(version);
  const std::string inputs = material_declarations(state);
  if (!inputs.empty()) text += locations;
  text += invariant_position;
  text += inputs;
  if (state.lighting) text += power_function;
  text += "\nvoid main() {\n  gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;\n";
  text += eye_space_statements(state);
  text += state.lighting ? lighting_statements(state) : unlit_statements(state);
  text += texture_statements(state);
  text += fog_statement(state);
  if (state.clip_planes) text += "  gl_ClipVertex = eye_position;\n";
  if (state.point_size) text += point_size_statements;
  return text + "}\n";
}

}  // namespace glark::refine
