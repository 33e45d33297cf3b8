// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Each parameter of glMaterial for the front face, the back face and both at once, by each command, between vertices. The
// triangles show their front or their back.
#include <fmt/core.h>

#include <array>

#include "conformance/cases/cases.h"
#include "conformance/support/capture.h"
#include "conformance/support/counted.h"

namespace glark::conformance {
namespace {

constexpr GLuint within_list = 81;
constexpr GLuint within_inner_list = 90;  // one for each vertex

struct WithinParameter {
  const char* leaf;
  GLenum parameter;
};
constexpr WithinParameter within_parameters[] = {
    {"ambient", GL_AMBIENT},
    {"diffuse", GL_DIFFUSE},
    {"specular", GL_SPECULAR},
    {"emission", GL_EMISSION},
    {"shininess", GL_SHININESS},
    {"ambient_and_diffuse", GL_AMBIENT_AND_DIFFUSE},
    {"color_indexes", GL_COLOR_INDEXES},
};

struct WithinFace {
  const char* name;
  GLenum face;
};
constexpr WithinFace within_faces[] = {{"front", GL_FRONT}, {"back", GL_BACK}, {"front and back", GL_FRONT_AND_BACK}};

std::array<float, 4> within_value(GLenum parameter, int salt) {
  const auto part = [salt](int k) { return 0.05F + static_cast<float>((3 * salt + 2 * k) % 7) / 20; };
  if (parameter == GL_SHININESS) return {static_cast<float>(2 + salt % 5 * 6), 0, 0, 0};
  if (parameter == GL_COLOR_INDEXES) return {static_cast<float>(salt), static_cast<float>(salt + 1), 3, 0};
  return {part(0), part(1), part(2), 1};
}

// Commands that set the same value.
using SetMaterial = void (*)(GLenum face, GLenum parameter, const std::array<float, 4>& value);

void set_by_floats(GLenum face, GLenum parameter, const std::array<float, 4>& value) {
  gl.Materialfv(face, parameter, value.data());
}

void set_by_integers(GLenum face, GLenum parameter, const std::array<float, 4>& value) {
  const bool is_colour = parameter != GL_SHININESS && parameter != GL_COLOR_INDEXES;
  std::array<GLint, 4> integers{};
  for (std::size_t i = 0; i < 4; ++i)
    integers[i] = static_cast<GLint>(static_cast<double>(value[i]) * (is_colour ? 2147483647.0 : 1.0));
  gl.Materialiv(face, parameter, integers.data());
}

// SHININESS by glMateriali and glMaterialf in turn; other parameters have several values.
void set_by_scalar(GLenum face, GLenum parameter, const std::array<float, 4>& value) {
  if (parameter != GL_SHININESS) return set_by_floats(face, parameter, value);
  static bool is_integer = false;
  is_integer = !is_integer;
  is_integer ? gl.Materiali(face, parameter, static_cast<GLint>(value[0])) : gl.Materialf(face, parameter, value[0]);
}

constexpr SetMaterial material_setters[] = {set_by_floats, set_by_integers, set_by_scalar};

constexpr GLfloat within_corners[6][2] = {{-0.6F, -0.5F}, {0, -0.5F},   {-0.4F, 0.6F},
                                          {0.1F, -0.6F},  {0.4F, 0.6F}, {0.7F, -0.4F}};

struct Within {
  GLenum face;
  GLenum parameter;
  SetMaterial set;
  bool is_two_sided;
};

bool is_face_of(const Within& w, GLenum face) { return w.face == face || w.face == GL_FRONT_AND_BACK; }
int base_salt(GLenum face) { return face == GL_FRONT ? 1 : 4; }

void set_base_materials() {
  for (const WithinParameter& each : within_parameters)
    for (const GLenum face : {GL_FRONT, GL_BACK})
      set_by_floats(face, each.parameter, within_value(each.parameter, base_salt(face)));
}

void set_vertex_material(const Within& w, int vertex) { w.set(w.face, w.parameter, within_value(w.parameter, vertex)); }

void draw_within(const Within& w, int first_vertex) {
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 6; ++i) {
    if (i >= first_vertex) set_vertex_material(w, i);
    gl.Vertex2fv(within_corners[i]);
  }
  gl.End();
}

// How the vertices come to GL, and the first of them that sets a material. An implementation may leave a list unrefined
// whose first vertices have the material that is current at the call.
struct WithinWay {
  const char* leaf;
  int first_vertex;
  void (*compile)(const Within& w);
  void (*draw)(const Within& w);
};

void call_within_list(const Within&) { gl.CallList(within_list); }

constexpr WithinWay within_ways[] = {
    {"direct", 0, [](const Within&) {}, [](const Within& w) { draw_within(w, 0); }},
    {"direct_late", 2, [](const Within&) {}, [](const Within& w) { draw_within(w, 2); }},
    {"listed", 0,
     [](const Within& w) {
       gl.NewList(within_list, GL_COMPILE);
       draw_within(w, 0);
       gl.EndList();
     },
     call_within_list},
    {"called", 0,
     [](const Within& w) {
       for (int i = 0; i < 6; ++i) {
         gl.NewList(within_inner_list + static_cast<GLuint>(i), GL_COMPILE);
         set_vertex_material(w, i);
         gl.EndList();
       }
     },
     [](const Within&) {
       gl.Begin(GL_TRIANGLES);
       for (int i = 0; i < 6; ++i) {
         gl.CallList(within_inner_list + static_cast<GLuint>(i));
         gl.Vertex2fv(within_corners[i]);
       }
       gl.End();
     }},
};

// Each triangle alone, while both faces have the materials of the one that is seen: Mesa 22.3 loses colours where a
// material of the back face alone differs among vertices.
void draw_seen_faces(const Within& w, int first_vertex) {
  for (const int triangle : {0, 1}) {
    const GLenum seen = triangle == 0 || !w.is_two_sided ? GL_FRONT : GL_BACK;
    for (const WithinParameter& each : within_parameters)
      set_by_floats(GL_FRONT_AND_BACK, each.parameter, within_value(each.parameter, base_salt(seen)));
    const Within both{GL_FRONT_AND_BACK, w.parameter, set_by_floats, w.is_two_sided};
    if (is_face_of(w, seen) && 3 * triangle > first_vertex) set_vertex_material(both, 3 * triangle - 1);
    gl.Begin(GL_TRIANGLES);
    for (int i = 3 * triangle; i < 3 * triangle + 3; ++i) {
      if (is_face_of(w, seen) && i >= first_vertex) set_vertex_material(both, i);
      gl.Vertex2fv(within_corners[i]);
    }
    gl.End();
  }
}

std::vector<float> left_materials_within() {
  std::vector<float> all;
  for (const GLenum face : {GL_FRONT, GL_BACK})
    for (const GLenum parameter : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_SHININESS, GL_COLOR_INDEXES}) {
      std::array<float, 4> value{};
      gl.GetMaterialfv(face, parameter, value.data());
      all.insert(all.end(), value.begin(), value.end());
    }
  return all;
}

// What the commands leave, outside of Begin and End.
std::vector<float> expected_materials(const Within& w) {
  set_base_materials();
  set_vertex_material(w, 5);
  return left_materials_within();
}

void set_within_lights() {
  const GLfloat towards[] = {0.4F, 0.3F, 1, 0};
  const GLfloat behind[] = {0.1F, -0.4F, -1, 0};
  const GLfloat half[] = {0.5F, 0.6F, 0.4F, 1};
  gl.Enable(GL_LIGHTING);
  gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, half);
  gl.Normal3f(0.2F, 0.1F, 0.9F);
  for (const auto& [light, position] : {std::pair<GLenum, const GLfloat*>{GL_LIGHT0, towards}, {GL_LIGHT1, behind}}) {
    gl.Enable(light);
    gl.Lightfv(light, GL_POSITION, position);
    gl.Lightfv(light, GL_DIFFUSE, half);
    gl.Lightfv(light, GL_SPECULAR, half);
  }
}

void expect_within(Test& t, const Within& w, const WithinWay& way, const std::string& what) {
  const std::vector<float> left = expected_materials(w);
  gl.Disable(GL_ARK);
  const Picture expected = picture_of([&] { draw_seen_faces(w, way.first_vertex); });
  way.compile(w);
  gl.Enable(GL_ARK);
  const auto draw = [&] {
    set_base_materials();
    way.draw(w);
  };
  draw();  // an implementation may learn from it which parameters change within primitives
  for (int again = 0; again < 2; ++again) {
    GLuint triangles = 0;
    const Picture refined = picture_of([&] { triangles = count_generated(draw); });
    t.expect_equal(triangles, 2 * 16U, what + ": triangles");
    t.expect_same_picture(refined, expected, what, 4, 80);
    t.expect(left_materials_within() == left, what + ": the materials that are left");
  }
}

void check_within(Test& t, GLenum parameter, const WithinWay& way) {
  set_within_lights();
  refine_uniformly(2, GL_LINEAR_OUTPUTS_ARK);
  std::size_t turn = parameter + way.first_vertex;
  for (const WithinFace& face : within_faces)
    for (const bool is_two_sided : {true, false}) {
      const SetMaterial set = material_setters[++turn % std::size(material_setters)];
      gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, is_two_sided ? 1 : 0);
      expect_within(t, {face.face, parameter, set, is_two_sided}, way,
                    fmt::format("{}, {} sides, turn {}", face.name, is_two_sided ? 2 : 1, turn));
    }
  t.expect_no_error("the draws");
}

}  // namespace

Cases changed_within_cases() {
  Cases cases;
  for (const WithinParameter& parameter : within_parameters)
    for (const WithinWay& way : within_ways)
      cases.push_back(
          {.name = fmt::format("ark.draw.within.faces.{}.{}", parameter.leaf, way.leaf),
           .clauses = {"10.R.2-2", "11.R.10-1", "11.R.6-8"},
           .plan = "Vertices set this parameter of the front, of the back and of both faces at once. "
                   "Compare the picture, triangles, and the materials that are left.",
           .wrong = "Only one of two faces changes; the face that is not seen takes the place of the other.",
           .apis = compat_only,
           .check = [&parameter, &way](Test& t) { check_within(t, parameter.parameter, way); }});
  return cases;
}

}  // namespace glark::conformance
