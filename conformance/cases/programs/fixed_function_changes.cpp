// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Changes of fixed-function vertex state between refined draws: each draw reads the current state (11.R.10).
#include "conformance/cases/cases.h"
#include "conformance/cases/programs/linear_texture.h"
#include "conformance/support/capture.h"

namespace glark::conformance {
namespace {

void vertex(float x, float y, float z) {
  gl.Color3f(0.5F + 0.5F * x, 0.5F - 0.5F * y, 0.25F);
  gl.Normal3f(0.6F * x, 0.5F * y, 0.8F);
  gl.TexCoord2f(0.5F + x, 0.5F - y);
  gl.FogCoordf(0.5F + 0.5F * y);
  gl.Vertex3f(x, y, z);
}

void triangle() {
  gl.Begin(GL_TRIANGLES);
  vertex(-0.8F, -0.7F, 0.2F);
  vertex(0.8F, -0.6F, -0.3F);
  vertex(-0.1F, 0.8F, 0.4F);
  gl.End();
}

void light() {
  const GLfloat position[] = {0.5F, 0.7F, 1.5F, 1};
  const GLfloat colour[] = {0.7F, 0.6F, 0.4F, 1};
  for (const GLenum capability : {GL_LIGHTING, GL_LIGHT0, GL_NORMALIZE}) gl.Enable(static_cast<GLenum>(capability));
  gl.Lightfv(GL_LIGHT0, GL_POSITION, position);
  gl.Lightfv(GL_LIGHT0, GL_SPECULAR, colour);
  gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, colour);
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 4);
}

struct Change {
  const char* leaf;
  void (*set_up)();
  void (*change)();
};

const Change changes[] = {
    {"tex_gen",
     [] {
       enable_linear_texture();
       gl.Enable(GL_TEXTURE_GEN_S);
       gl.TexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
     },
     [] { gl.TexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP); }},
    {"tex_gen_plane",
     [] {
       enable_linear_texture();
       gl.Enable(GL_TEXTURE_GEN_S);
       gl.TexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
     },
     [] {
       const GLfloat plane[] = {0.2F, 0.9F, 0.4F, 0.1F};
       gl.TexGenfv(GL_S, GL_OBJECT_PLANE, plane);
     }},
    {"local_viewer", light, [] { gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1); }},
    {"two_sided",
     [] {
       const GLfloat back[] = {0.1F, 0.5F, 0.9F, 1};
       light();
       gl.Materialfv(GL_BACK, GL_AMBIENT_AND_DIFFUSE, back);
       gl.FrontFace(GL_CW);
     },
     [] { gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1); }},
    {"separate_specular",
     [] {
       light();
       enable_linear_texture();
     },
     [] { gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR); }},
    {"color_material",
     [] {
       light();
       gl.ColorMaterial(GL_FRONT_AND_BACK, GL_EMISSION);
       gl.Enable(GL_COLOR_MATERIAL);
     },
     [] { gl.ColorMaterial(GL_FRONT_AND_BACK, GL_DIFFUSE); }},
    {"fog_source",
     [] {
       const GLfloat colour[] = {0.9F, 0.1F, 0.8F, 1};
       gl.Enable(GL_FOG);
       gl.Fogi(GL_FOG_MODE, GL_LINEAR);
       gl.Fogf(GL_FOG_START, 0);
       gl.Fogf(GL_FOG_END, 1);
       gl.Fogfv(GL_FOG_COLOR, colour);
     },
     [] { gl.Fogi(GL_FOG_COORD_SRC, GL_FOG_COORD); }},
    {"texture_matrix", enable_linear_texture,
     [] {
       gl.MatrixMode(GL_TEXTURE);
       gl.Rotatef(35, 0, 0, 1);
     }},
    {"light", light,
     [] {
       const GLfloat direction[] = {-0.6F, 0.1F, 0.4F, 0};
       gl.Lightfv(GL_LIGHT0, GL_POSITION, direction);
     }},
};

// Refined outputs give the unrefined picture.
void expect_as_unrefined(Test& t, const Picture& plain, const std::string& what) {
  for (int again = 0; again < 3; ++again) t.expect_same_picture(picture_of(triangle), plain, what, 3, 24);
}

enum class Way { by_call, by_list, by_pop };

// by_pop: the change is made before the first draw, and PopAttrib undoes it between the draws.
void check_change(Test& t, const Change& change, Way way) {
  change.set_up();
  if (way == Way::by_pop) {
    gl.PushAttrib(GL_ALL_ATTRIB_BITS);
    change.change();
  }
  const Picture before = picture_of(triangle);
  refine_uniformly(3, GL_LINEAR_OUTPUTS_ARK);
  expect_as_unrefined(t, before, "before the change");
  if (way == Way::by_list) {
    gl.NewList(1, GL_COMPILE);
    change.change();
    gl.EndList();
    expect_as_unrefined(t, before, "after the list was compiled");
  }
  switch (way) {
    case Way::by_call: change.change(); break;
    case Way::by_list: gl.CallList(1); break;
    case Way::by_pop: gl.PopAttrib(); gl.Enable(GL_ARK);
  }
  gl.Disable(GL_ARK);
  const Picture after = picture_of(triangle);
  gl.Enable(GL_ARK);
  t.expect(count_different(before, after, 8) > 100, "the change shows");
  expect_as_unrefined(t, after, "after the change");
  t.expect_no_error("the draws");
}

// A list sets one uniform. Another is set while the list is compiled but not executed.
void check_list_uniforms(Test& t) {
  const GLuint program = build_program(t, {.vertex = "uniform vec4 tint; out vec4 colour;\n"
                                                     "void main() { colour = tint; gl_Position = gl_Vertex; }\n"});
  const GLint tint = gl.GetUniformLocation(program, "tint");
  gl.UseProgram(program);
  refine_uniformly(2);
  for (const bool has_triangle : {false, true})
    for (const float green : {0.25F, 1.0F, 0.5F}) {
      gl.Uniform4f(tint, 1, 0, 0, 1);
      picture_of(triangle);
      gl.NewList(1, GL_COMPILE);
      gl.Uniform4f(tint, 0, green, 0, 1);
      if (has_triangle) triangle();
      gl.EndList();
      const auto call_and_draw = [has_triangle] {
        gl.CallList(1);
        if (!has_triangle) triangle();
      };
      for (int again = 0; again < 3; ++again) {
        gl.Uniform4f(tint, 1, 0, 0, 1);
        const Picture refined = picture_of(call_and_draw);
        gl.Disable(GL_ARK);
        gl.Uniform4f(tint, 0, green, 0, 1);
        const Picture plain = picture_of(triangle);
        gl.Enable(GL_ARK);
        t.expect_same_picture(refined, plain, "the uniform that the list sets", 2, 20);
      }
    }
  t.expect_no_error("the lists");
}

// The list was compiled before the program used the extension.
void check_early_list(Test& t) {
  const GLuint program = build_program(t, {.vertex = "uniform vec4 tint; out vec4 colour;\n"
                                                     "void main() { colour = tint; gl_Position = gl_Vertex; }\n"});
  const GLint tint = gl.GetUniformLocation(program, "tint");
  gl.UseProgram(program);
  gl.NewList(1, GL_COMPILE);
  gl.Uniform4f(tint, 0, 0.5F, 1, 1);
  gl.EndList();
  gl.NewList(2, GL_COMPILE);
  gl.CallList(1);
  gl.EndList();
  gl.Uniform4f(tint, 0, 0.5F, 1, 1);
  const Picture plain = picture_of(triangle);
  refine_uniformly(2);
  for (const GLuint list : {1U, 2U})
    for (int again = 0; again < 3; ++again) {
      gl.Uniform4f(tint, 1, 0, 0, 1);
      t.expect(count_different(picture_of(triangle), plain, 8) > 100, "the other uniform shows");
      gl.CallList(list);
      t.expect_same_picture(picture_of(triangle), plain, "the uniform that the list sets", 2, 20);
    }
  t.expect_no_error("the lists");
}

// Materials among the vertices of a list stay current after every call.
void check_list_materials(Test& t) {
  const GLfloat red[] = {1, 0, 0, 1};
  const GLfloat blue[] = {0, 0, 1, 1};
  const GLfloat light_colour[] = {1, 1, 1, 1};
  gl.Enable(GL_LIGHTING);
  gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, light_colour);
  refine_uniformly(2);
  gl.NewList(1, GL_COMPILE);
  gl.Begin(GL_TRIANGLES);
  vertex(-0.9F, -0.9F, 0);
  gl.Materialfv(GL_FRONT_AND_BACK, GL_AMBIENT, blue);
  vertex(-0.7F, -0.9F, 0);
  vertex(-0.8F, -0.7F, 0);
  gl.End();
  gl.EndList();
  for (int again = 0; again < 6; ++again) {
    gl.Materialfv(GL_FRONT_AND_BACK, GL_AMBIENT, red);
    gl.CallList(1);
    GLfloat found[4] = {0, 0, 0, 0};
    gl.GetMaterialfv(GL_FRONT, GL_AMBIENT, found);
    t.expect_equal(found[2], 1.0F, "the blue of the material that the list leaves");
    const Picture refined = picture_of(triangle);
    gl.Disable(GL_ARK);
    t.expect_same_picture(refined, picture_of(triangle), "a triangle after the list", 2, 20);
    gl.Enable(GL_ARK);
  }
  t.expect_no_error("the calls");
}

constexpr Area change_case{"ark.fixed_function.changed."};

}  // namespace

Cases fixed_function_changes_cases() {
  Cases cases;
  const char* const old_state = "The vertex stage reads the state of the first refined draw.";
  for (const Change& change : changes) {
    cases.push_back(change_case(
        change.leaf, {"11.R.10-1", "11.R.6-8"},
        "Draw refined, change only this state, and draw again: refined outputs give the unrefined picture.", old_state,
        [change](Test& t) { check_change(t, change, Way::by_call); }, compat_only));
    cases.push_back(change_case(
        std::string(change.leaf) + ".by_list", {"11.R.10-1", "chapter-21-4"},
        "The same, but a display list changes the state.", old_state,
        [change](Test& t) { check_change(t, change, Way::by_list); }, compat_only));
    // PopAttrib restores no matrix, and in Mesa 22.3 not the source of fog coordinates.
    if (change.leaf == std::string("texture_matrix") || change.leaf == std::string("fog_source")) continue;
    cases.push_back(change_case(
        std::string(change.leaf) + ".by_pop", {"11.R.10-1", "11.R.6-8"},
        "The same, but PopAttrib changes the state back.", old_state,
        [change](Test& t) { check_change(t, change, Way::by_pop); }, compat_only));
  }
  cases.push_back(change_case("early_list", {"11.R.10-1", "chapter-21-4"},
                              "A list that sets a uniform is compiled before ARKinit, and called after it.",
                              "The value that was set outside the list.", check_early_list, compat_only));
  cases.push_back(change_case("list_uniforms", {"11.R.10-1", "chapter-21-4"},
                              "Call lists that set a uniform of the program in use, with and without vertices.",
                              "The value that was set outside the list.", check_list_uniforms, compat_only));
  cases.push_back(change_case("list_materials", {"11.R.10-1", "chapter-21-4"},
                              "Call a list that sets a material between its vertices several times.",
                              "Only the first calls leave the material.", check_list_materials, compat_only));
  return cases;
}

}  // namespace glark::conformance
