// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The fixed-function vertex stage: refined outputs give the unrefined picture, refined inputs that of a finer mesh, which the
// case draws itself.
#include <cmath>

#include "conformance/cases/cases.h"
#include "conformance/support/capture.h"

namespace glark::conformance {
namespace {

struct Stage {
  const char* leaf;
  void (*set)();
  bool has_flat_shading = false;
  bool is_inputs_only = false;  // what is drawn of the triangles is not the same for more of them
};

void light() {
  const GLfloat ambient[] = {0.1F, 0.2F, 0.1F, 1};
  const GLfloat position[] = {0.5F, 0.7F, 1.5F, 1};
  const GLfloat specular[] = {0.6F, 0.5F, 0.4F, 1};
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  gl.Lightfv(GL_LIGHT0, GL_POSITION, position);
  gl.Lightfv(GL_LIGHT0, GL_SPECULAR, specular);
  gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
  gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, specular);
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 12);
  gl.Enable(GL_NORMALIZE);
}

void texture() {
  const GLubyte texels[] = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255};
  GLuint name = 0;
  gl.GenTextures(1, &name);
  gl.BindTexture(GL_TEXTURE_2D, name);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.Enable(GL_TEXTURE_2D);
}

void generate(GLint mode) {
  texture();
  for (const GLenum coordinate : {GL_S, GL_T}) {
    const GLfloat plane[] = {coordinate == GL_S ? 0.7F : 0.2F, coordinate == GL_S ? 0.1F : 0.9F, 0.5F, 0.3F};
    gl.TexGeni(coordinate, GL_TEXTURE_GEN_MODE, mode);
    if (mode == GL_OBJECT_LINEAR) gl.TexGenfv(coordinate, GL_OBJECT_PLANE, plane);
    if (mode == GL_EYE_LINEAR) gl.TexGenfv(coordinate, GL_EYE_PLANE, plane);
    gl.Enable(coordinate == GL_S ? GL_TEXTURE_GEN_S : GL_TEXTURE_GEN_T);
  }
}

void fog(GLint mode) {
  const GLfloat colour[] = {0.9F, 0.1F, 0.8F, 1};
  gl.Enable(GL_FOG);
  gl.Fogi(GL_FOG_MODE, mode);
  gl.Fogf(GL_FOG_DENSITY, 0.9F);
  gl.Fogf(GL_FOG_START, 0.2F);
  gl.Fogf(GL_FOG_END, 1.4F);
  gl.Fogfv(GL_FOG_COLOR, colour);
}

void color_material(GLenum face, GLenum parameter) {
  const GLfloat back[] = {0.1F, 0.5F, 0.9F, 1};
  light();
  gl.Materialfv(GL_BACK, GL_DIFFUSE, back);
  gl.ColorMaterial(face, parameter);
  gl.Enable(GL_COLOR_MATERIAL);
}

// Light that falls on the side that the viewer does not see otherwise.
void seen_from_behind() {
  const GLfloat position[] = {0.3F, 0.2F, -1.5F, 1};
  gl.Lightfv(GL_LIGHT0, GL_POSITION, position);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  gl.FrontFace(GL_CW);
}

void filter(GLenum target) {
  gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.Enable(target);
}

constexpr GLubyte texels_of_two[] = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255};

void cube_map(GLint mode) {
  GLuint name = 0;
  gl.GenTextures(1, &name);
  gl.BindTexture(GL_TEXTURE_CUBE_MAP, name);
  for (GLenum face = 0; face < 6; ++face)
    gl.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                  texels_of_two + 4 * (face % 4));
  filter(GL_TEXTURE_CUBE_MAP);
  if (mode == 0) return;
  for (const GLenum coordinate : {GL_S, GL_T, GL_R}) {
    gl.TexGeni(coordinate, GL_TEXTURE_GEN_MODE, mode);
    gl.Enable(GL_TEXTURE_GEN_S + (coordinate - GL_S));
  }
}

// Only unit 1 has a texture.
void second_unit() {
  gl.ActiveTexture(GL_TEXTURE1);
  texture();
  gl.ActiveTexture(GL_TEXTURE0);
}

void generate_depth_coordinates() {
  const GLfloat plane[] = {0.4F, 0.3F, 0.2F, 1.2F};
  texture();
  gl.TexGeni(GL_Q, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
  gl.TexGenfv(GL_Q, GL_OBJECT_PLANE, plane);
  gl.Enable(GL_TEXTURE_GEN_Q);
}

// Eye coordinates are not clip coordinates.
void look_through_frustum() {
  gl.MatrixMode(GL_PROJECTION);
  gl.Frustum(-0.5, 0.5, -0.5, 0.5, 0.5, 10);
  gl.MatrixMode(GL_MODELVIEW);
  gl.Translatef(0, 0, -1.2F);
}

void clip(GLenum plane) {
  const GLdouble half[] = {0.8, -0.5, 0.3, 0.1};
  look_through_frustum();
  gl.ClipPlane(GL_CLIP_PLANE0 + plane, half);
  gl.Enable(GL_CLIP_PLANE0 + plane);
}

void points() {
  look_through_frustum();
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_POINT);
  gl.PointSize(5);
}

const Stage stages[] = {
    {"color", [] {}},
    {"light.point", light},
    {"light.directional",
     [] {
       light();
       const GLfloat position[] = {0.4F, 0.3F, 0.8F, 0};
       gl.Lightfv(GL_LIGHT0, GL_POSITION, position);
     }},
    {"light.spot",
     [] {
       light();
       const GLfloat direction[] = {-0.3F, -0.4F, -1};
       gl.Lightfv(GL_LIGHT0, GL_SPOT_DIRECTION, direction);
       gl.Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, 60);
       gl.Lightf(GL_LIGHT0, GL_SPOT_EXPONENT, 3);
     }},
    {"light.attenuated",
     [] {
       light();
       gl.Lightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 0.6F);
     }},
    {"light.local_viewer",
     [] {
       light();
       gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
     }},
    {"light.two_sided",
     [] {
       light();
       gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
       gl.FrontFace(GL_CW);
     }},
    {"light.separate_specular",
     [] {
       light();
       texture();
       gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
     }},
    {"color_material",
     [] {
       light();
       gl.ColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);
       gl.Enable(GL_COLOR_MATERIAL);
     }},
    {"color_material.front",
     [] {
       color_material(GL_FRONT, GL_AMBIENT_AND_DIFFUSE);
       seen_from_behind();
     }},
    {"color_material.emission", [] { color_material(GL_FRONT_AND_BACK, GL_EMISSION); }},
    {"color_material.specular", [] { color_material(GL_FRONT_AND_BACK, GL_SPECULAR); }},
    {"color_material.ambient", [] { color_material(GL_FRONT, GL_AMBIENT); }},
    {"light.linear_attenuation",
     [] {
       light();
       gl.Lightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, 0.5F);
       gl.Lightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.9F);
     }},
    {"light.last_of_eight",
     [] {
       const GLfloat position[] = {-0.7F, 0.2F, 0.6F, 2};
       const GLfloat colour[] = {0.7F, 0.2F, 0.3F, 1};
       light();
       gl.Enable(GL_LIGHT7);
       gl.Lightfv(GL_LIGHT7, GL_POSITION, position);
       gl.Lightfv(GL_LIGHT7, GL_DIFFUSE, colour);
     }},
    {"light.none",
     [] {
       light();
       gl.Disable(GL_LIGHT0);
     }},
    {"light.back_material",
     [] {
       const GLfloat specular[] = {0.9F, 0.8F, 0.7F, 1};
       light();
       seen_from_behind();
       gl.Materialfv(GL_BACK, GL_SPECULAR, specular);
       gl.Materialf(GL_BACK, GL_SHININESS, 2);
     }},
    {"clip_plane.0", [] { clip(0); }},
    {"clip_plane.5", [] { clip(5); }},
    {"clip_plane.last",
     [] {
       GLint planes = 6;
       gl.GetIntegerv(GL_MAX_CLIP_PLANES, &planes);
       clip(static_cast<GLenum>(planes) - 1);
     }},
    {"points.size", points, false, true},
    {"points.attenuated",
     [] {
       const GLfloat attenuation[] = {1.5625F, 0, 0};
       points();
       gl.PointParameterfv(GL_POINT_DISTANCE_ATTENUATION, attenuation);
     },
     false, true},
    {"lines",
     [] {
       gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
       gl.LineWidth(2);
     },
     false, true},
    {"texture.unit_1", second_unit},
    {"texture.two_units",
     [] {
       texture();
       second_unit();
     }},
    {"texture.second_matrix",
     [] {
       second_unit();
       gl.ActiveTexture(GL_TEXTURE1);
       gl.MatrixMode(GL_TEXTURE);
       gl.Rotatef(40, 0, 0, 1);
       gl.Scalef(1.4F, 0.6F, 1);
       gl.ActiveTexture(GL_TEXTURE0);
     }},
    {"texture.cube_map", [] { cube_map(0); }},
    {"texture.reflection_map", [] { cube_map(GL_REFLECTION_MAP); }},
    {"texture.normal_map", [] { cube_map(GL_NORMAL_MAP); }},
    {"texture.projective", generate_depth_coordinates},
    {"texture.1d",
     [] {
       gl.TexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels_of_two);
       filter(GL_TEXTURE_1D);
     }},
    {"texture.3d",
     [] {
       gl.TexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 2, 2, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels_of_two);
       filter(GL_TEXTURE_3D);
     }},
    {"texture.rectangle",
     [] {
       gl.TexImage2D(GL_TEXTURE_RECTANGLE, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels_of_two);
       filter(GL_TEXTURE_RECTANGLE);
       gl.MatrixMode(GL_TEXTURE);
       gl.Scalef(2, 2, 1);
     }},
    {"normals.rescale",
     [] {
       light();
       gl.Disable(GL_NORMALIZE);
       gl.Enable(GL_RESCALE_NORMAL);
       gl.MatrixMode(GL_MODELVIEW);
       gl.Scalef(1.2F, 1.2F, 1.2F);
     }},
    {"normals.as_they_are",
     [] {
       light();
       gl.Disable(GL_NORMALIZE);
     }},
    {"texture.coordinates", texture},
    {"texture.matrix",
     [] {
       texture();
       gl.MatrixMode(GL_TEXTURE);
       gl.Rotatef(30, 0, 0, 1);
       gl.Scalef(1.5F, 0.7F, 1);
     }},
    {"texture.object_linear", [] { generate(GL_OBJECT_LINEAR); }},
    {"texture.eye_linear", [] { generate(GL_EYE_LINEAR); }},
    {"texture.sphere_map", [] { generate(GL_SPHERE_MAP); }},
    {"fog.linear", [] { fog(GL_LINEAR); }},
    {"fog.exp", [] { fog(GL_EXP); }},
    {"fog.exp2", [] { fog(GL_EXP2); }},
    {"fog.coordinate",
     [] {
       fog(GL_LINEAR);
       gl.Fogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
     }},
    {"color_sum", [] { gl.Enable(GL_COLOR_SUM); }},
    {"matrices",
     [] {
       gl.MatrixMode(GL_PROJECTION);
       gl.Frustum(-0.5, 0.5, -0.5, 0.5, 0.5, 10);
       gl.MatrixMode(GL_MODELVIEW);
       gl.Translatef(0, 0, -1.2F);
       gl.Rotatef(35, 0.3F, 1, 0.2F);
       light();
     }},
    {"flat",
     [] {
       light();
       gl.ShadeModel(GL_FLAT);
     },
     true},
};

struct Corner {
  std::array<float, 3> position;
  std::array<float, 3> normal;
  std::array<float, 3> colour;
  std::array<float, 3> secondary;
  std::array<float, 2> texture;
  float fog;
};

const Corner corners[3] = {{{-0.8F, -0.7F, 0.2F}, {-0.6F, -0.4F, 0.8F}, {1, 0.2F, 0}, {0, 0.3F, 0.1F}, {0, 0.1F}, 0.2F},
                           {{0.8F, -0.6F, -0.3F}, {0.7F, -0.1F, 0.9F}, {0.1F, 1, 0.3F}, {0.4F, 0, 0}, {1, 0}, 0.7F},
                           {{-0.1F, 0.8F, 0.4F}, {0.1F, 0.9F, 0.5F}, {0.2F, 0, 1}, {0, 0, 0.5F}, {0.3F, 1}, 1.3F}};

template <std::size_t n>
std::array<float, n> mixed(const std::array<float, 3>& w, const std::array<float, n>& a, const std::array<float, n>& b,
                           const std::array<float, n>& c) {
  std::array<float, n> result{};
  for (std::size_t i = 0; i < n; ++i) result[i] = (w[0] * a[i] + w[1] * b[i]) + w[2] * c[i];
  return result;
}

void vertex(const std::array<float, 3>& w) {
  const auto colour = mixed(w, corners[0].colour, corners[1].colour, corners[2].colour);
  const auto secondary = mixed(w, corners[0].secondary, corners[1].secondary, corners[2].secondary);
  const auto normal = mixed(w, corners[0].normal, corners[1].normal, corners[2].normal);
  const auto texture_at = mixed(w, corners[0].texture, corners[1].texture, corners[2].texture);
  const auto position = mixed(w, corners[0].position, corners[1].position, corners[2].position);
  gl.Color3f(colour[0], colour[1], colour[2]);
  gl.SecondaryColor3f(secondary[0], secondary[1], secondary[2]);
  gl.Normal3f(normal[0], normal[1], normal[2]);
  gl.TexCoord2f(texture_at[0], texture_at[1]);
  gl.MultiTexCoord2f(GL_TEXTURE1, texture_at[1], 1 - texture_at[0]);
  gl.FogCoordf((w[0] * corners[0].fog + w[1] * corners[1].fog) + w[2] * corners[2].fog);
  gl.Vertex3f(position[0], position[1], position[2]);
}

// 4^level triangles of the coarse one.
Picture finer_picture(int level) {
  clear_surface();
  const int n = 1 << level;
  const auto at = [n](int i, int j) {
    const auto u = static_cast<float>(i) / static_cast<float>(n);
    const auto v = static_cast<float>(j) / static_cast<float>(n);
    vertex({1 - u - v, u, v});
  };
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j) {
      at(i, j);
      at(i + 1, j);
      at(i, j + 1);
      if (i + j + 1 >= n) continue;
      at(i + 1, j);
      at(i + 1, j + 1);
      at(i, j + 1);
    }
  gl.End();
  return read_picture(surface_size, surface_size);
}

void check_stage(Test& t, const Stage& stage, bool is_inputs) {
  stage.set();
  const Picture expected = finer_picture(is_inputs && !stage.has_flat_shading ? 3 : 0);
  t.expect(count_different(expected, Picture(surface_size, surface_size), 0) > 500, "the triangle is drawn");
  refine_uniformly(3, is_inputs ? GL_LINEAR_INPUTS_ARK : GL_LINEAR_OUTPUTS_ARK);
  // Rounding of colors, and of the outline: a pixel centre within rounding of an edge may fall to either side.
  t.expect_same_picture(finer_picture(0), expected, is_inputs ? "refined inputs" : "refined outputs", 3, 24);
}

}  // namespace

Cases fixed_function_cases() {
  Cases cases;
  for (const Stage& stage : stages) {
    if (!stage.is_inputs_only)
      cases.push_back(
          {.name = std::string("ark.fixed_function.") + stage.leaf + ".outputs",
           .clauses = stage.has_flat_shading ? std::vector<std::string>{"11.R.6-10", "11.R.6-13"}
                                             : std::vector<std::string>{"11.R.6-8", "11.R.6-9"},
           .plan = "With this state, refined outputs give the unrefined picture.",
           .wrong = "A color, texture coordinate or fog coordinate is lost, or computed anew for each refined vertex.",
           .apis = compat_only,
           .check = [stage](Test& t) { check_stage(t, stage, false); }});
    cases.push_back(
        {.name = std::string("ark.fixed_function.") + stage.leaf + ".inputs",
         .clauses = stage.has_flat_shading ? std::vector<std::string>{"11.R.6-12", "11.R.6-13"}
                                           : std::vector<std::string>{"11.R.6-4", "11.R.6-5", "11.R.10-1"},
         .plan = "With this state, refined inputs give the picture of 64 triangles that the case draws itself.",
         .wrong = "The fixed-function stage is imitated wrongly; normals are normalized where they should not be.",
         .apis = compat_only,
         .check = [stage](Test& t) { check_stage(t, stage, true); }});
  }
  return cases;
}

}  // namespace glark::conformance
