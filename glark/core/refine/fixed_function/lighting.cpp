// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Based on: The OpenGL Graphics System, version 2.1, section 2.14.1, equations 2.2 to 2.5, and section 2.14.3
// (ColorMaterial). The values of a light do not select the shader; the shader branches on them. They change more often
// than the enables, and such a branch is uniform.
#include "glark/core/refine/fixed_function/parts.h"

namespace glark::refine {
namespace {

struct Face {
  GLenum name;
  int first_parameter;   // of the material
  const char* built_in;  // as in gl_FrontMaterial
  const char* local;     // prefix of the shader's own variables
  const char* sign;      // of the normal
};

constexpr Face front_face = {GL_FRONT, 0, "Front", "front", ""};
constexpr Face back_face = {GL_BACK, core::parameters_of_face, "Back", "back", "-"};

// Returns whether the material parameter follows gl_Color.
bool follows_color(const FixedFunctionState& state, const Face& face, GLenum parameter) {
  if (!state.color_material) return false;
  if (state.color_material_face != GL_FRONT_AND_BACK && state.color_material_face != face.name) return false;
  if (state.color_material_parameter == GL_AMBIENT_AND_DIFFUSE)
    return parameter == GL_AMBIENT || parameter == GL_DIFFUSE;
  return state.color_material_parameter == parameter;
}

std::string member_of(GLenum parameter) {
  switch (parameter) {
    case GL_AMBIENT: return "ambient";
    case GL_DIFFUSE: return "diffuse";
    case GL_SPECULAR: return "specular";
    case GL_SHININESS: return "shininess";
    default: return "emission";
  }
}

std::string input_of(const Face& face, GLenum parameter) {
  return std::string("material_") + face.local + "_" + member_of(parameter);
}

// Returns whether each vertex has its own value of the parameter.
bool is_input(const FixedFunctionState& state, const Face& face, GLenum parameter) {
  for (int i = face.first_parameter; i < face.first_parameter + core::parameters_of_face; ++i) {
    if (core::name_of(i) == parameter) return state.material_attribute[i] >= 0;
  }
  return false;
}

// Returns whether the parameter differs between vertices.
bool varies(const FixedFunctionState& state, const Face& face, GLenum parameter) {
  return follows_color(state, face, parameter) || is_input(state, face, parameter);
}

std::string material(const FixedFunctionState& state, const Face& face, GLenum parameter) {
  if (follows_color(state, face, parameter)) return "gl_Color";
  if (is_input(state, face, parameter)) return input_of(face, parameter);
  return std::string("gl_") + face.built_in + "Material." + member_of(parameter);
}

// Material times light, from GL's derived state where the material is constant.
std::string product(const FixedFunctionState& state, const Face& face, int light, GLenum parameter) {
  const std::string index = "[" + std::to_string(light) + "].";
  const std::string member = member_of(parameter);
  if (varies(state, face, parameter))
    return "(" + material(state, face, parameter) + " * gl_LightSource" + index + member + ").rgb";
  return std::string("gl_") + face.built_in + "LightProduct" + index + member + ".rgb";
}

std::string scene_color(const FixedFunctionState& state, const Face& face) {
  if (!varies(state, face, GL_AMBIENT) && !varies(state, face, GL_EMISSION))
    return std::string("gl_") + face.built_in + "LightModelProduct.sceneColor.rgb";
  return "(" + material(state, face, GL_EMISSION) + " + " + material(state, face, GL_AMBIENT) +
         " * gl_LightModel.ambient).rgb";
}

// The vectors of light $i. A spot cutoff of 180 makes no spot light, and a directional light has no distance
// attenuation.
constexpr std::string_view light_vectors = R"(  {
    vec3 light_vector = gl_LightSource[$i].position.xyz;
    float attenuation = 1.0;
    if (gl_LightSource[$i].position.w != 0.0) {
      light_vector = light_vector / gl_LightSource[$i].position.w - eye_point;
      float light_distance = length(light_vector);
      attenuation = 1.0 / (gl_LightSource[$i].constantAttenuation + light_distance *
          (gl_LightSource[$i].linearAttenuation + light_distance * gl_LightSource[$i].quadraticAttenuation));
    }
    light_vector = normalize(light_vector);
    if (gl_LightSource[$i].spotCutoff != 180.0) {
      float spot = dot(-light_vector, normalize(gl_LightSource[$i].spotDirection));
      attenuation *= spot >= gl_LightSource[$i].spotCosCutoff ? power(spot, gl_LightSource[$i].spotExponent) : 0.0;
    }
    vec3 half_vector = normalize(light_vector + to_viewer);
    float normal_light = dot(eye_normal, light_vector);
    float normal_half = dot(eye_normal, half_vector);
)";

constexpr std::string_view face_of_light =
    R"(    $face_color += attenuation * ($ambient + max($sign normal_light, 0.0) * $diffuse);
    if ($sign normal_light > 0.0)
      $face_specular += attenuation * power($sign normal_half, $shininess) * $specular;
)";

std::string lit_face(const FixedFunctionState& state, const Face& face, int light) {
  return substitute(face_of_light, {{"$face", face.local},
                                    {"$sign ", face.sign},
                                    {"$shininess", material(state, face, GL_SHININESS)},
                                    {"$ambient", product(state, face, light, GL_AMBIENT)},
                                    {"$diffuse", product(state, face, light, GL_DIFFUSE)},
                                    {"$specular", product(state, face, light, GL_SPECULAR)}});
}

std::string face_start(const FixedFunctionState& state, const Face& face) {
  return substitute("  vec3 $face_color = $scene;\n  vec3 $face_specular = vec3(0.0);\n",
                    {{"$face", face.local}, {"$scene", scene_color(state, face)}});
}

// Alpha is that of the diffuse material, and 1 in the secondary colour.
std::string face_result(const FixedFunctionState& state, const Face& from, const Face& to) {
  std::string text = state.separate_specular ? "  gl_$ToColor = vec4($face_color, $diffuse.a);\n"
                                             : "  gl_$ToColor = vec4($face_color + $face_specular, $diffuse.a);\n";
  if (state.separate_specular)
    text += "  gl_$ToSecondaryColor = vec4($face_specular, 1.0);\n";
  else if (state.color_sum)
    text += "  gl_$ToSecondaryColor = vec4(0.0, 0.0, 0.0, 1.0);\n";
  return substitute(text,
                    {{"$To", to.built_in}, {"$face", from.local}, {"$diffuse", material(state, from, GL_DIFFUSE)}});
}

bool any_light(const FixedFunctionState& state) {
  for (bool enabled : state.light)
    if (enabled) return true;
  return false;
}

}  // namespace

std::string material_declarations(const FixedFunctionState& state) {
  std::string text;
  for (int i = 0; state.lighting && i < core::material_parameters; ++i) {
    if (state.material_attribute[i] < 0) continue;
    const Face& face = core::face_of(i) == GL_FRONT ? front_face : back_face;
    text += "layout(location = " + std::to_string(state.material_attribute[i]) + ") in " +
            (core::name_of(i) == GL_SHININESS ? "float " : "vec4 ") + input_of(face, core::name_of(i)) + ";\n";
  }
  return text;
}

Needs lighting_needs(const FixedFunctionState& state) {
  Needs needs;
  needs.eye_normal = needs.eye_point = any_light(state);
  needs.eye_direction = any_light(state) && state.local_viewer;
  return needs;
}

std::string lighting_statements(const FixedFunctionState& state) {
  std::string text = face_start(state, front_face);
  if (state.two_sided) text += face_start(state, back_face);
  if (any_light(state))
    text += state.local_viewer ? "  vec3 to_viewer = -eye_direction;\n" : "  vec3 to_viewer = vec3(0.0, 0.0, 1.0);\n";
  for (int light = 0; light < fixed_function_lights; ++light) {
    if (!state.light[light]) continue;
    text += substitute(light_vectors, {{"$i", std::to_string(light)}});
    text += lit_face(state, front_face, light);
    if (state.two_sided) text += lit_face(state, back_face, light);
    text += "  }\n";
  }
  text += face_result(state, front_face, front_face);
  return text + face_result(state, state.two_sided ? back_face : front_face, back_face);
}

}  // namespace glark::refine
