// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The fixed-function vertex stage: refined outputs give the unrefined picture, refined inputs give the picture of a
// finer mesh that the case draws itself.
#include <cmath>

#include "conformance/cases/cases.h"
#include "conformance/cases/programs/finer_triangle.h"
#include "conformance/cases/programs/linear_texture.h"
#include "conformance/support/capture.h"

namespace glark::conformance {
namespace {

struct Stage {
  const char* leaf;
  void (*set)();
  bool has_flat_shading = false;
  bool is_inputs_only = false;  // the picture depends on the number of triangles
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

void generate(GLint mode) {
  enable_linear_texture();
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

// The light falls on the side that the viewer cannot see otherwise.
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

void cube_map(GLint mode) {
  GLuint name = 0;
  gl.GenTextures(1, &name);
  gl.BindTexture(GL_TEXTURE_CUBE_MAP, name);
  for (GLenum face = 0; face < 6; ++face)
    gl.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                  four_texels + 4 * (face % 4));
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
  enable_linear_texture();
  gl.ActiveTexture(GL_TEXTURE0);
}

void generate_depth_coordinates() {
  const GLfloat plane[] = {0.4F, 0.3F, 0.2F, 1.2F};
  enable_linear_texture();
  gl.TexGeni(GL_Q, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
  gl.TexGenfv(GL_Q, GL_OBJECT_PLANE, plane);
  gl.Enable(GL_TEXTURE_GEN_Q);
}

// With a frustum, eye coordinates differ from clip coordinates.
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
       enable_linear_texture();
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
       enable_linear_texture();
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
       gl.TexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, four_texels);
       filter(GL_TEXTURE_1D);
     }},
    {"texture.3d",
     [] {
       gl.TexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 2, 2, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, four_texels);
       filter(GL_TEXTURE_3D);
     }},
    {"texture.rectangle",
     [] {
       gl.TexImage2D(GL_TEXTURE_RECTANGLE, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, four_texels);
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
    {"texture.coordinates", enable_linear_texture},
    {"texture.matrix",
     [] {
       enable_linear_texture();
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

void check_stage(Test& t, const Stage& stage, bool is_inputs) {
  stage.set();
  const Picture expected = finer_picture(is_inputs && !stage.has_flat_shading ? 3 : 0);
  t.expect(count_different(expected, Picture(surface_size, surface_size), 0) > 500, "the triangle is drawn");
  refine_uniformly(3, is_inputs ? GL_LINEAR_INPUTS_ARK : GL_LINEAR_OUTPUTS_ARK);
  // Colours are rounded. A pixel centre within rounding of the outline may fall to either side.
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
           .plan = "In this state, refined outputs give the unrefined picture.",
           .wrong =
               "A colour, texture coordinate or fog coordinate is lost, or computed again for each refined vertex.",
           .apis = compat_only,
           .check = [stage](Test& t) { check_stage(t, stage, false); }});
    cases.push_back(
        {.name = std::string("ark.fixed_function.") + stage.leaf + ".inputs",
         .clauses = stage.has_flat_shading ? std::vector<std::string>{"11.R.6-12", "11.R.6-13"}
                                           : std::vector<std::string>{"11.R.6-4", "11.R.6-5", "11.R.10-1"},
         .plan = "In this state, refined inputs give the picture of 64 triangles that the case draws itself.",
         .wrong =
             "The implementation imitates the fixed-function stage wrongly; it normalizes normals where it should not.",
         .apis = compat_only,
         .check = [stage](Test& t) { check_stage(t, stage, true); }});
  }
  return cases;
}

}  // namespace glark::conformance
