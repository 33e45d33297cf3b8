// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Commands that set fixed-function state in another form: scalars, vectors, floats, integers, transposed matrices.
// After each of them, refined draws look like the unrefined draw after the usual command.
#include <fmt/core.h>

#include <array>

#include "conformance/cases/cases.h"
#include "conformance/cases/commands/as_plain.h"
#include "conformance/cases/programs/linear_texture.h"

namespace glark::conformance {
namespace {

struct StateForm {
  const char* leaf;
  void (*set_up)();
  void (*usual)(int turn);  // 0 or 1
  void (*other)(int turn);
};

constexpr GLint integer_part(int turn, int component) {
  return ((3 * turn + 2 * component + 1) % 4) * 0x20000000 + 0x10000000;
}
GLfloat float_part(int turn, int component) {
  return static_cast<GLfloat>(static_cast<double>(integer_part(turn, component)) / 2147483647.0);
}

void set_up_texture() { enable_linear_texture(); }
void set_up_blend() {
  enable_linear_texture();
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_BLEND);
}
void set_up_generation() {
  enable_linear_texture();
  gl.Enable(GL_TEXTURE_GEN_S);
  gl.TexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
}
void set_up_fog() {
  gl.Enable(GL_FOG);
  gl.Fogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
  gl.Fogi(GL_FOG_MODE, GL_LINEAR);
  gl.Fogf(GL_FOG_END, 2);
}
void set_up_light() {
  const GLfloat position[] = {0.5F, 0.7F, 1.5F, 1};
  const GLfloat specular[] = {0.7F, 0.6F, 0.4F, 1};
  for (const GLenum capability : {GL_LIGHTING, GL_LIGHT0, GL_NORMALIZE}) gl.Enable(capability);
  gl.Lightfv(GL_LIGHT0, GL_POSITION, position);
  gl.Lightfv(GL_LIGHT0, GL_SPECULAR, specular);
  gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, specular);
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 3);
}
void set_up_two_sided() {
  set_up_light();
  const GLfloat back[] = {0.1F, 0.5F, 0.9F, 1};
  gl.Materialfv(GL_BACK, GL_AMBIENT, back);
  gl.FrontFace(GL_CW);
}

constexpr GLint environments[] = {GL_REPLACE, GL_MODULATE};
constexpr GLint generations[] = {GL_SPHERE_MAP, GL_EYE_LINEAR};
constexpr GLint fogs[] = {GL_EXP, GL_EXP2};

template <typename Number>
std::array<Number, 16> matrix_of(int turn, bool is_transposed) {
  std::array<Number, 16> columns{};
  for (std::size_t i = 0; i < 4; ++i) columns[5 * i] = 1;
  columns[0] = static_cast<Number>(turn == 0 ? 0.5 : 0.75);
  columns[1] = static_cast<Number>(turn == 0 ? 0.25 : -0.125);
  columns[12] = static_cast<Number>(turn == 0 ? 0.25 : -0.125);
  columns[13] = static_cast<Number>(turn == 0 ? -0.125 : 0.25);
  if (!is_transposed) return columns;
  std::array<Number, 16> rows{};
  for (std::size_t i = 0; i < 16; ++i) rows[i] = columns[4 * (i % 4) + i / 4];
  return rows;
}

void load_usual(int turn) { gl.LoadMatrixf(matrix_of<GLfloat>(turn, false).data()); }
void multiply_usual(int turn) {
  gl.LoadIdentity();
  gl.MultMatrixf(matrix_of<GLfloat>(turn, false).data());
}

void ambient_usual(int turn) {
  const GLfloat value[] = {float_part(turn, 0), float_part(turn, 1), float_part(turn, 2), 1};
  gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, value);
}
void fog_colour_usual(int turn) {
  const GLfloat value[] = {float_part(turn, 0), float_part(turn, 1), float_part(turn, 2), 1};
  gl.Fogfv(GL_FOG_COLOR, value);
}
void environment_colour_usual(int turn) {
  const GLfloat value[] = {float_part(turn, 0), float_part(turn, 1), float_part(turn, 2), 1};
  gl.TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, value);
}
void plane_usual(int turn) {
  const GLfloat plane[] = {turn == 0 ? 1.0F : 2.0F, turn == 0 ? -1.0F : 1.0F, 0, 1};
  gl.TexGenfv(GL_S, GL_OBJECT_PLANE, plane);
}

using IntegerVector = void (*)(GLenum name, const GLint* values);
void set_integers(int turn, GLenum name, IntegerVector set) {
  const GLint value[] = {integer_part(turn, 0), integer_part(turn, 1), integer_part(turn, 2), 0x7fffffff};
  set(name, value);
}

constexpr StateForm texture_forms[] = {
    {"texenvf", set_up_texture, [](int turn) { gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, environments[turn]); },
     [](int turn) { gl.TexEnvf(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, static_cast<GLfloat>(environments[turn])); }},
    {"texenviv", set_up_texture, [](int turn) { gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, environments[turn]); },
     [](int turn) { gl.TexEnviv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, environments + turn); }},
    {"texenviv.color", set_up_blend, environment_colour_usual,
     [](int turn) {
       set_integers(turn, GL_TEXTURE_ENV_COLOR,
                    [](GLenum name, const GLint* values) { gl.TexEnviv(GL_TEXTURE_ENV, name, values); });
     }},
    {"texgeniv", set_up_generation, [](int turn) { gl.TexGeni(GL_S, GL_TEXTURE_GEN_MODE, generations[turn]); },
     [](int turn) { gl.TexGeniv(GL_S, GL_TEXTURE_GEN_MODE, generations + turn); }},
    {"texgenf", set_up_generation, [](int turn) { gl.TexGeni(GL_S, GL_TEXTURE_GEN_MODE, generations[turn]); },
     [](int turn) { gl.TexGenf(GL_S, GL_TEXTURE_GEN_MODE, static_cast<GLfloat>(generations[turn])); }},
    {"texgend", set_up_generation, [](int turn) { gl.TexGeni(GL_S, GL_TEXTURE_GEN_MODE, generations[turn]); },
     [](int turn) { gl.TexGend(GL_S, GL_TEXTURE_GEN_MODE, generations[turn]); }},
    {"texgeniv.plane", set_up_generation, plane_usual,
     [](int turn) {
       const GLint plane[] = {turn == 0 ? 1 : 2, turn == 0 ? -1 : 1, 0, 1};
       gl.TexGeniv(GL_S, GL_OBJECT_PLANE, plane);
     }},
    {"texgendv.plane", set_up_generation, plane_usual,
     [](int turn) {
       const GLdouble plane[] = {turn == 0 ? 1.0 : 2.0, turn == 0 ? -1.0 : 1.0, 0, 1};
       gl.TexGendv(GL_S, GL_OBJECT_PLANE, plane);
     }},
};

constexpr StateForm fog_forms[] = {
    {"fogiv", set_up_fog, [](int turn) { gl.Fogi(GL_FOG_MODE, fogs[turn]); },
     [](int turn) { gl.Fogiv(GL_FOG_MODE, fogs + turn); }},
    {"fogf", set_up_fog, [](int turn) { gl.Fogi(GL_FOG_MODE, fogs[turn]); },
     [](int turn) { gl.Fogf(GL_FOG_MODE, static_cast<GLfloat>(fogs[turn])); }},
    {"fogiv.color", set_up_fog, fog_colour_usual, [](int turn) { set_integers(turn, GL_FOG_COLOR, gl.Fogiv); }},
    {"fogiv.end", set_up_fog, [](int turn) { gl.Fogf(GL_FOG_END, static_cast<GLfloat>(turn + 1)); },
     [](int turn) {
       const GLint end = turn + 1;
       gl.Fogiv(GL_FOG_END, &end);
     }},
};

constexpr StateForm light_forms[] = {
    {"lightmodeliv", set_up_light, ambient_usual,
     [](int turn) { set_integers(turn, GL_LIGHT_MODEL_AMBIENT, gl.LightModeliv); }},
    {"lightmodeliv.two_side", set_up_two_sided, [](int turn) { gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, turn); },
     [](int turn) { gl.LightModeliv(GL_LIGHT_MODEL_TWO_SIDE, &turn); }},
    {"lightmodelf.two_side", set_up_two_sided, [](int turn) { gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, turn); },
     [](int turn) { gl.LightModelf(GL_LIGHT_MODEL_TWO_SIDE, static_cast<GLfloat>(turn)); }},
    {"lightmodeliv.local_viewer", set_up_light, [](int turn) { gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, turn); },
     [](int turn) { gl.LightModeliv(GL_LIGHT_MODEL_LOCAL_VIEWER, &turn); }},
};

constexpr StateForm matrix_forms[] = {
    {"loadmatrixd", set_up_light, load_usual,
     [](int turn) { gl.LoadMatrixd(matrix_of<GLdouble>(turn, false).data()); }},
    {"loadtransposematrixf", set_up_light, load_usual,
     [](int turn) { gl.LoadTransposeMatrixf(matrix_of<GLfloat>(turn, true).data()); }},
    {"loadtransposematrixd", set_up_light, load_usual,
     [](int turn) { gl.LoadTransposeMatrixd(matrix_of<GLdouble>(turn, true).data()); }},
    {"multmatrixd", set_up_light, multiply_usual,
     [](int turn) {
       gl.LoadIdentity();
       gl.MultMatrixd(matrix_of<GLdouble>(turn, false).data());
     }},
    {"multtransposematrixf", set_up_light, multiply_usual,
     [](int turn) {
       gl.LoadIdentity();
       gl.MultTransposeMatrixf(matrix_of<GLfloat>(turn, true).data());
     }},
    {"multtransposematrixd", set_up_light, multiply_usual,
     [](int turn) {
       gl.LoadIdentity();
       gl.MultTransposeMatrixd(matrix_of<GLdouble>(turn, true).data());
     }},
};

struct FormVertex {
  std::array<GLfloat, 3> place;
  std::array<GLfloat, 3> normal;
  std::array<GLfloat, 2> coordinate;
  GLfloat fog;
};
constexpr FormVertex form_vertices[] = {{{-0.8F, -0.7F, 0.2F}, {-0.5F, -0.3F, 0.8F}, {0, 1}, 0.1F},
                                        {{0.8F, -0.6F, -0.3F}, {0.4F, -0.3F, 0.8F}, {1, 0.75F}, 0.9F},
                                        {{-0.1F, 0.8F, 0.4F}, {0, 0.6F, 0.7F}, {0.25F, 0}, 0.5F}};

void use_form_vertices() {
  const FormVertex& first = form_vertices[0];
  gl.VertexPointer(3, GL_FLOAT, sizeof(FormVertex), first.place.data());
  gl.NormalPointer(GL_FLOAT, sizeof(FormVertex), first.normal.data());
  gl.TexCoordPointer(2, GL_FLOAT, sizeof(FormVertex), first.coordinate.data());
  gl.FogCoordPointer(GL_FLOAT, sizeof(FormVertex), &first.fog);
  for (const GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY, GL_FOG_COORD_ARRAY})
    gl.EnableClientState(array);
  gl.Color3f(0.7F, 0.9F, 0.6F);
}

// Refined outputs are linear, so that the picture is that of the unrefined draw.
void check_form(Test& t, const StateForm& form) {
  const auto draw = [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); };
  use_form_vertices();
  form.set_up();
  refine_uniformly(2, GL_LINEAR_OUTPUTS_ARK);
  std::array<PlainDraw, 2> plain;
  for (int turn = 0; turn < 2; ++turn) {
    form.usual(turn);
    plain[static_cast<std::size_t>(turn)] = plain_draw(draw);
  }
  t.expect(count_different(plain[0].picture, plain[1].picture, 4) > 100, "the two values differ unrefined");
  for (int again = 0; again < 4; ++again) {
    const int turn = again % 2;
    form.other(turn);
    expect_as_plain(t, plain[static_cast<std::size_t>(turn)], draw, fmt::format("value {}, change {}", turn, again),
                    {.is_often = again < 2});
    if (again == 2) form.usual(turn);
  }
  t.expect_no_error("the draws");
}

}  // namespace

Cases state_forms_cases() {
  Cases cases;
  const auto add = [&cases](const auto& forms) {
    for (const StateForm& form : forms)
      cases.push_back({.name = fmt::format("ark.command.form.{}", form.leaf),
                       .clauses = {"11.R.10-1", "11.R.6-8"},
                       .plan = "Change this state by this command between draws that repeat often: each draw is that "
                               "after the usual command for the same value.",
                       .wrong = "A command in another form is not seen, and the draw keeps the earlier state.",
                       .apis = compat_only,
                       .check = [&form](Test& t) { check_form(t, form); }});
  };
  add(texture_forms);
  add(fog_forms);
  add(light_forms);
  add(matrix_forms);
  return cases;
}

}  // namespace glark::conformance
