// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The table of states in which fixed function and the generated shader are compared. A case fills the
// FixedFunctionState, from which the enables are set, and sets the values (colours, planes, matrices) in GL itself.
#pragma once

#include <ostream>
#include <vector>

#include "tests/core/refine/fixed_function/values.h"

namespace glark::refine::test {

struct Case {
  const char* name;
  void (*set)(State& state);
  GLenum primitive = GL_TRIANGLES;
};

inline std::ostream& operator<<(std::ostream& stream, const Case& tested) { return stream << tested.name; }

// One case a line, where it fits.
// clang-format off
inline const std::vector<Case>& unlit_cases() {
  static const std::vector<Case> cases = {
      {"Unlit", [](State&) {}},
      {"UnlitFlat", [](State&) { glShadeModel(GL_FLAT); }},
      {"UnlitPoints", [](State&) { glPointSize(3.0f); }, GL_POINTS},
      {"UnlitColorMaterialIgnored", [](State& s) { follow_color(s, GL_FRONT, GL_DIFFUSE); s.lighting = false; }},
      {"ColorSum", [](State& s) { s.color_sum = true; }},
      {"ColorSumFlat", [](State& s) { s.color_sum = true; glShadeModel(GL_FLAT); }},
      {"FogLinear", [](State& s) { fog(s, GL_LINEAR); }},
      {"FogExp", [](State& s) { fog(s, GL_EXP); }},
      {"FogExp2", [](State& s) { fog(s, GL_EXP2); }},
      {"FogCoordinateLinear", [](State& s) { fog(s, GL_LINEAR); s.fog_from_coordinate = true; }},
      {"FogCoordinateExp", [](State& s) { fog(s, GL_EXP); s.fog_from_coordinate = true; }},
      {"FogCoordinateExp2", [](State& s) { fog(s, GL_EXP2); s.fog_from_coordinate = true; }},
      {"FogRadial", [](State& s) { fog(s, GL_EXP, 0.5f); s.fog_distance = GL_EYE_RADIAL_NV; }},
      {"FogSignedPlane", [](State& s) { fog(s, GL_EXP2); s.fog_distance = GL_EYE_PLANE; }},
      {"FogColorSum", [](State& s) { fog(s, GL_EXP); s.color_sum = true; }},
      {"ClipPlane", [](State& s) { clip_plane(s, 0, 1.0, 0.3, 0.0, 0.2); }},
      {"ClipPlanes", [](State& s) { clip_plane(s, 0, 1.0, 0.3, 0.0, 0.5); clip_plane(s, 3, -0.2, -1.0, 0.4, 0.4); }},
      {"ClipPlaneLit", [](State& s) { directional(s); clip_plane(s, 1, 0.1, 0.2, 1.0, 0.1); }},
      {"PointConstant", [](State& s) { point_attenuation(s, {4.0f, 0.0f, 0.0f}); }, GL_POINTS},
      {"PointLinear", [](State& s) { point_attenuation(s, {0.0f, 1.0f, 0.0f}); }, GL_POINTS},
      {"PointQuadratic", [](State& s) { point_attenuation(s, {0.0f, 0.0f, 0.9f}); }, GL_POINTS},
      {"PointAll", [](State& s) { point_attenuation(s, {0.5f, 0.3f, 0.2f}); }, GL_POINTS},
      {"PointClampedToMinimum", [](State& s) { point_attenuation(s, {0.0f, 0.0f, 0.9f}, 3.2f); }, GL_POINTS},
      {"PointClampedToMaximum", [](State& s) { point_attenuation(s, {0.0f, 0.0f, 0.9f}, 0.0f, 2.9f); }, GL_POINTS},
      {"PointLit", [](State& s) { positional(s); point_attenuation(s, {0.0f, 0.0f, 0.9f}); }, GL_POINTS},
  };
  return cases;
}

inline const std::vector<Case>& lighting_cases() {
  static const std::vector<Case> cases = {
      {"NoLight", [](State& s) { set_materials(); s.lighting = true; s.color_material = true; s.color_material_face =
         GL_FRONT; s.color_material_parameter = GL_EMISSION; }},
      {"Directional", [](State& s) { directional(s); }},
      {"DirectionalFlat", [](State& s) { directional(s); glShadeModel(GL_FLAT); }},
      {"DirectionalLocalViewer", [](State& s) { directional(s); s.local_viewer = true; }},
      {"DirectionalSpot", [](State& s) { directional(s); light_value(0, GL_SPOT_CUTOFF, {80.0f}); }},
      {"DirectionalIgnoresAttenuation", [](State& s) { directional(s); light_value(0, GL_QUADRATIC_ATTENUATION, {3.0f});
         }},
      {"Positional", [](State& s) { positional(s); }},
      {"PositionalLocalViewer", [](State& s) { positional(s); s.local_viewer = true; }},
      {"PositionalHomogeneous", [](State& s) { set_materials(); set_light(s, 0, {1.2f, 1.4f, -2.4f, 2.0f}); }},
      {"AttenuationConstant", [](State& s) { positional(s); light_value(0, GL_CONSTANT_ATTENUATION, {1.7f}); }},
      {"AttenuationLinear", [](State& s) { positional(s); light_value(0, GL_LINEAR_ATTENUATION, {0.6f}); }},
      {"AttenuationQuadratic", [](State& s) { positional(s); light_value(0, GL_QUADRATIC_ATTENUATION, {0.4f}); }},
      {"Spot", [](State& s) { spot(s, 35.0f, 0.0f); }},
      {"SpotExponent", [](State& s) { spot(s, 50.0f, 12.0f); }},
      {"SpotNinety", [](State& s) { spot(s, 90.0f, 3.0f); }},
      {"SpotNarrow", [](State& s) { spot(s, 12.0f, 3.0f); }},
      {"SpotCutoff180IgnoresExponent", [](State& s) { spot(s, 180.0f, 12.0f); }},
      {"SpotAttenuated", [](State& s) { spot(s, 40.0f, 5.0f); light_value(0, GL_LINEAR_ATTENUATION, {0.6f});
         s.local_viewer = true; }},
      {"ShininessZero", [](State& s) { directional(s); material_value(GL_FRONT_AND_BACK, GL_SHININESS, {0.0f}); }},
      {"ShininessZeroPositional", [](State& s) { positional(s); material_value(GL_FRONT_AND_BACK, GL_SHININESS, {0.0f});
         }},
      {"ShininessLargest", [](State& s) { positional(s); material_value(GL_FRONT_AND_BACK, GL_SHININESS, {128.0f}); }},
      {"ShininessZeroInFrontOnly", [](State& s) { two_sided(s); material_value(GL_FRONT, GL_SHININESS, {0.0f}); }},
      {"LightModelAmbient", [](State& s) { directional(s); const float c[4] = {0.9f, 0.1f, 0.5f, 1.0f};
         glLightModelfv(GL_LIGHT_MODEL_AMBIENT, c); }},
      {"Overbright", [](State& s) { directional(s); light_value(0, GL_DIFFUSE, {3.0f, 2.0f, -1.0f, 1.0f}); }},
      {"NegativeLight", [](State& s) { directional(s); set_light(s, 1, {0.0f, 0.0f, 1.0f, 0.0f}); light_value(1,
         GL_DIFFUSE, {-0.4f, -0.5f, -0.2f, 1.0f}); }},
      {"EightLights", [](State& s) { set_materials(); for (int i = 0; i < 8; ++i) { set_light(s, i, {float(i) - 3.5f,
         1.0f, float(i % 3), float(i % 2)}); light_value(i, GL_DIFFUSE, {0.02f * float(i), 0.2f, 0.1f, 1.0f});
         light_value(i, GL_SPECULAR, {0.1f, 0.03f * float(i), 0.1f, 1.0f}); } }},
      {"LightSevenOnly", [](State& s) { set_materials(); set_light(s, 7, {0.5f, 0.5f, 1.0f, 0.0f}); }},
      {"SeparateSpecular", [](State& s) { directional(s); s.separate_specular = true; }},
      {"SeparateSpecularTextured", [](State& s) { positional(s); s.separate_specular = true; textured(s, 0); }},
      {"SingleSpecularTextured", [](State& s) { positional(s); textured(s, 0); }},
      {"LitColorSum", [](State& s) { directional(s); s.color_sum = true; }},
      {"TwoSided", [](State& s) { two_sided(s); }},
      {"TwoSidedFlat", [](State& s) { two_sided(s); glShadeModel(GL_FLAT); }},
      {"TwoSidedSeparateSpecular", [](State& s) { two_sided(s); s.separate_specular = true; textured(s, 0); }},
      {"TwoSidedPositionalSpot", [](State& s) { spot(s, 60.0f, 2.0f); s.two_sided = s.local_viewer = true; set_light(s,
         1, {0.2f, 0.1f, -5.0f, 1.0f}); }},
      {"TwoSidedClockwise", [](State& s) { two_sided(s); glFrontFace(GL_CW); }},
      {"OneSidedBackShowsFront", [](State& s) { two_sided(s); s.two_sided = false; }},
      {"LitFog", [](State& s) { directional(s); fog(s, GL_EXP); }},
  };
  return cases;
}

// Mesa 22.3's own fixed function is wrong if GL_BACK alone follows a varying colour: green and blue are lost, except in
// emission. fixed_function_test.cpp tests those states against GL_FRONT_AND_BACK, in fixed function.
inline const std::vector<Case>& color_material_cases() {
  static const std::vector<Case> cases = {
      {"ColorFrontAmbient", [](State& s) { follow_color(s, GL_FRONT, GL_AMBIENT); }},
      {"ColorFrontDiffuse", [](State& s) { follow_color(s, GL_FRONT, GL_DIFFUSE); }},
      {"ColorFrontSpecular", [](State& s) { follow_color(s, GL_FRONT, GL_SPECULAR); }},
      {"ColorFrontEmission", [](State& s) { follow_color(s, GL_FRONT, GL_EMISSION); }},
      {"ColorFrontAmbientAndDiffuse", [](State& s) { follow_color(s, GL_FRONT, GL_AMBIENT_AND_DIFFUSE); }},
      {"ColorBackEmission", [](State& s) { follow_color(s, GL_BACK, GL_EMISSION); }},
      {"ColorBothAmbient", [](State& s) { follow_color(s, GL_FRONT_AND_BACK, GL_AMBIENT); }},
      {"ColorBothDiffuse", [](State& s) { follow_color(s, GL_FRONT_AND_BACK, GL_DIFFUSE); }},
      {"ColorBothSpecular", [](State& s) { follow_color(s, GL_FRONT_AND_BACK, GL_SPECULAR); }},
      {"ColorBothEmission", [](State& s) { follow_color(s, GL_FRONT_AND_BACK, GL_EMISSION); }},
      {"ColorBothAmbientAndDiffuse", [](State& s) { follow_color(s, GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE); }},
      {"ColorDiffuseSeparateSpecular", [](State& s) { follow_color(s, GL_FRONT_AND_BACK, GL_DIFFUSE);
         s.separate_specular = true; }},
      {"ColorDiffuseOneSided", [](State& s) { follow_color(s, GL_FRONT_AND_BACK, GL_DIFFUSE); s.two_sided = false; }},
  };
  return cases;
}

inline const std::vector<Case>& normal_cases() {
  static const std::vector<Case> cases = {
      {"Normalize", [](State& s) { directional(s); s.normalize = true; glScalef(0.4f, 0.4f, 0.4f); glScalef(2.0f, 2.0f,
         2.0f); }},
      {"NormalizeAnisotropic", [](State& s) { directional(s); s.normalize = true; glScalef(1.2f, 0.7f, 0.5f); }},
      {"ScaledWithoutNormalize", [](State& s) { directional(s); glScalef(1.3f, 1.3f, 1.3f); }},
      {"Rescale", [](State& s) { directional(s); s.rescale_normal = true; glScalef(0.7f, 0.7f, 0.7f); }},
      {"RescaleAnisotropic", [](State& s) { directional(s); s.rescale_normal = true; glScalef(1.2f, 0.8f, 0.6f); }},
      {"RescaleLocalViewer", [](State& s) { positional(s); s.local_viewer = s.rescale_normal = true; glScalef(1.3f,
         1.3f, 1.3f); }},
      {"NormalizeOverRescale", [](State& s) { directional(s); s.normalize = s.rescale_normal = true; glScalef(1.2f,
         0.8f, 0.6f); }},
      {"RescaleTwoSided", [](State& s) { two_sided(s); s.rescale_normal = true; glScalef(0.8f, 0.8f, 0.8f); }},
      {"Mirrored", [](State& s) { two_sided(s); glScalef(-1.0f, 1.0f, 1.0f); }},
  };
  return cases;
}

inline const std::vector<Case>& texture_cases() {
  static const std::vector<Case> cases = {
      {"TextureUnit0", [](State& s) { textured(s, 0); }},
      {"TextureUnit1", [](State& s) { textured(s, 1); }},
      {"TextureUnits", [](State& s) { for (int i = 0; i < 3; ++i) textured(s, i); }},
      {"TextureMatrix0", [](State& s) { textured(s, 0); texture_matrix(0); }},
      {"TextureMatrix1", [](State& s) { textured(s, 1); texture_matrix(1); }},
      {"TextureMatrix2", [](State& s) { textured(s, 2); texture_matrix(2); }},
      {"TextureMatrices", [](State& s) { for (int i = 0; i < 3; ++i) { textured(s, i); texture_matrix(i); } }},
      {"ObjectLinearST", [](State& s) { generate(s, 0, GL_OBJECT_LINEAR, GL_OBJECT_LINEAR); }},
      {"ObjectLinearS", [](State& s) { generate(s, 0, GL_OBJECT_LINEAR, 0); }},
      {"ObjectLinearT", [](State& s) { generate(s, 0, 0, GL_OBJECT_LINEAR); }},
      {"ObjectLinearR", [](State& s) { generate(s, 0, 0, 0, GL_OBJECT_LINEAR); }},
      {"ObjectLinearQ", [](State& s) { generate(s, 0, 0, 0, 0, GL_OBJECT_LINEAR); }},
      {"ObjectLinearAll", [](State& s) { generate(s, 0, GL_OBJECT_LINEAR, GL_OBJECT_LINEAR, GL_OBJECT_LINEAR,
         GL_OBJECT_LINEAR); }},
      {"ObjectLinearMatrix", [](State& s) { generate(s, 0, GL_OBJECT_LINEAR, GL_OBJECT_LINEAR); texture_matrix(0); }},
      {"EyeLinearST", [](State& s) { generate(s, 0, GL_EYE_LINEAR, GL_EYE_LINEAR); }},
      {"EyeLinearR", [](State& s) { generate(s, 0, 0, 0, GL_EYE_LINEAR); }},
      {"EyeLinearQ", [](State& s) { generate(s, 0, 0, 0, 0, GL_EYE_LINEAR); }},
      {"EyeLinearAllUnit2", [](State& s) { generate(s, 2, GL_EYE_LINEAR, GL_EYE_LINEAR, GL_EYE_LINEAR, GL_EYE_LINEAR);
         }},
      {"SphereMap", [](State& s) { generate(s, 0, GL_SPHERE_MAP, GL_SPHERE_MAP); }},
      {"SphereMapNormalized", [](State& s) { generate(s, 0, GL_SPHERE_MAP, GL_SPHERE_MAP); s.normalize = true;
         glScalef(1.2f, 0.8f, 0.7f); }},
      {"SphereMapRescaled", [](State& s) { generate(s, 0, GL_SPHERE_MAP, GL_SPHERE_MAP); s.rescale_normal = true;
         glScalef(0.8f, 0.8f, 0.8f); }},
      {"SphereMapUnit1Lit", [](State& s) { directional(s); generate(s, 1, GL_SPHERE_MAP, GL_SPHERE_MAP); }},
      {"SphereMapMatrix", [](State& s) { generate(s, 0, GL_SPHERE_MAP, GL_SPHERE_MAP); texture_matrix(0); }},
      {"ReflectionMap", [](State& s) { generate(s, 0, GL_REFLECTION_MAP, GL_REFLECTION_MAP, GL_REFLECTION_MAP); }},
      {"ReflectionMapMatrix", [](State& s) { generate(s, 0, GL_REFLECTION_MAP, GL_REFLECTION_MAP, GL_REFLECTION_MAP);
         texture_matrix(0); }},
      {"NormalMap", [](State& s) { generate(s, 0, GL_NORMAL_MAP, GL_NORMAL_MAP, GL_NORMAL_MAP); }},
      {"NormalMapUnit2", [](State& s) { generate(s, 2, GL_NORMAL_MAP, GL_NORMAL_MAP, GL_NORMAL_MAP); s.normalize = true;
         glScalef(1.2f, 0.8f, 0.7f); }},
      {"MixedModes", [](State& s) { generate(s, 0, GL_SPHERE_MAP, GL_EYE_LINEAR, 0, GL_OBJECT_LINEAR); }},
      {"MixedDirections", [](State& s) { generate(s, 0, GL_NORMAL_MAP, GL_REFLECTION_MAP, GL_EYE_LINEAR); }},
      {"MixedUnits", [](State& s) { textured(s, 0); generate(s, 1, GL_EYE_LINEAR, GL_SPHERE_MAP); generate(s, 2,
         GL_REFLECTION_MAP, GL_NORMAL_MAP, GL_NORMAL_MAP); glActiveTexture(GL_TEXTURE2); glTexEnvi(GL_TEXTURE_ENV,
         GL_TEXTURE_ENV_MODE, GL_MODULATE); glActiveTexture(GL_TEXTURE0); }},
      {"Everything", [](State& s) { follow_color(s, GL_FRONT, GL_DIFFUSE); set_light(s, 2, {0.6f, 0.7f, -1.2f, 1.0f});
         light_value(2, GL_SPOT_CUTOFF, {60.0f}); s.separate_specular = s.local_viewer = s.normalize = true; textured(s,
         0); texture_matrix(0); generate(s, 1, GL_SPHERE_MAP, GL_SPHERE_MAP); glActiveTexture(GL_TEXTURE1);
         glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE); glActiveTexture(GL_TEXTURE0); fog(s, GL_EXP2,
         0.2f); clip_plane(s, 0, 1.0, 0.3, 0.0, 0.6); }},
  };
  return cases;
}

// clang-format on

inline std::vector<Case> all_cases() {
  std::vector<Case> all;
  for (const auto* cases :
       {&unlit_cases(), &lighting_cases(), &color_material_cases(), &normal_cases(), &texture_cases()})
    all.insert(all.end(), cases->begin(), cases->end());
  return all;
}

}  // namespace glark::refine::test
