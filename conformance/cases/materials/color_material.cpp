// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// ColorMaterial of each face and each parameter (GL 4.6 compatibility profile, 12.2.3). Both sides of triangles are lit
// and seen, so that a parameter of the other face shows.
#include <fmt/core.h>

#include <span>

#include "conformance/cases/cases.h"
#include "conformance/cases/repeated/repeated.h"
#include "conformance/support/capture.h"
#include "conformance/support/counted.h"

namespace glark::conformance {
namespace {

struct TrackedFace {
  const char* leaf;
  GLenum face;
};
constexpr TrackedFace tracked_faces[] = {{"front", GL_FRONT}, {"back", GL_BACK}, {"front_and_back", GL_FRONT_AND_BACK}};

struct TrackedParameter {
  const char* leaf;
  GLenum parameter;
};
constexpr TrackedParameter tracked_parameters[] = {{"ambient", GL_AMBIENT},
                                                   {"diffuse", GL_DIFFUSE},
                                                   {"specular", GL_SPECULAR},
                                                   {"emission", GL_EMISSION},
                                                   {"ambient_and_diffuse", GL_AMBIENT_AND_DIFFUSE}};

// Normals are those of the screen's plane and the light is far, so that lit colours are linear in the material.
struct ColouredVertex {
  Vec2 position;
  Vec4 colour;
};
// The first triangle shows its front, the second one its back.
constexpr ColouredVertex coloured_vertices[] = {
    {{-0.9F, -0.8F}, {0.7F, 0.1F, 0.2F, 1}}, {{0.0F, -0.7F}, {0.1F, 0.6F, 0.3F, 1}},
    {{-0.5F, 0.8F}, {0.2F, 0.1F, 0.7F, 1}},  {{0.1F, -0.8F}, {0.5F, 0.5F, 0.1F, 1}},
    {{0.4F, 0.9F}, {0.1F, 0.5F, 0.5F, 1}},   {{0.9F, -0.6F}, {0.6F, 0.2F, 0.6F, 1}}};
constexpr GLsizei coloured_count = std::size(coloured_vertices);

void set_materials() {
  const GLfloat front[][4] = {{0.1F, 0.05F, 0.2F, 1}, {0.3F, 0.1F, 0.1F, 1}, {0.2F, 0.2F, 0, 1}, {0, 0.1F, 0.05F, 1}};
  const GLfloat back[][4] = {{0.2F, 0.1F, 0, 1}, {0.05F, 0.3F, 0.2F, 1}, {0, 0.1F, 0.3F, 1}, {0.15F, 0, 0.1F, 1}};
  const GLenum parameters[] = {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION};
  for (std::size_t i = 0; i < 4; ++i) {
    gl.Materialfv(GL_FRONT, parameters[i], front[i]);
    gl.Materialfv(GL_BACK, parameters[i], back[i]);
  }
  gl.Materialf(GL_FRONT, GL_SHININESS, 2);
  gl.Materialf(GL_BACK, GL_SHININESS, 5);
}

void set_lights() {
  const GLfloat towards_front[] = {0.3F, 0.2F, 1, 0};
  const GLfloat towards_back[] = {-0.2F, 0.4F, -1, 0};
  const GLfloat half[] = {0.2F, 0.25F, 0.18F, 1};  // so dim that no colour is clamped
  gl.Enable(GL_LIGHTING);
  for (const auto& [light, position] : {std::pair<GLenum, const GLfloat*>{GL_LIGHT0, towards_front},
                                        std::pair<GLenum, const GLfloat*>{GL_LIGHT1, towards_back}}) {
    gl.Enable(light);
    gl.Lightfv(light, GL_POSITION, position);
    for (const GLenum part : {GL_DIFFUSE, GL_SPECULAR, GL_AMBIENT}) gl.Lightfv(light, part, half);
  }
  gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, half);
  gl.Normal3f(0, 0, 1);
}

// A range of coloured_vertices, which one draw takes.
using ColouredPart = std::span<const ColouredVertex>;
constexpr ColouredPart all_coloured(coloured_vertices);

void draw_between_begin_and_end(ColouredPart part) {
  gl.Begin(GL_TRIANGLES);
  for (const ColouredVertex& vertex : part) {
    gl.Color4fv(vertex.colour.data());
    gl.Vertex2fv(vertex.position.data());
  }
  gl.End();
}

void draw_by_arrays(ColouredPart part) {
  gl.VertexPointer(2, GL_FLOAT, sizeof(ColouredVertex), part[0].position.data());
  gl.ColorPointer(4, GL_FLOAT, sizeof(ColouredVertex), part[0].colour.data());
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_COLOR_ARRAY);
  gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(part.size()));
  gl.DisableClientState(GL_COLOR_ARRAY);
  gl.DisableClientState(GL_VERTEX_ARRAY);
}

// One colour for all vertices, which is current.
void draw_in_current_colour(ColouredPart part) {
  gl.Color4f(0.25F, 0.6F, 0.4F, 1);
  gl.VertexPointer(2, GL_FLOAT, sizeof(ColouredVertex), part[0].position.data());
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(part.size()));
  gl.DisableClientState(GL_VERTEX_ARRAY);
}

void draw_in_one_colour(ColouredPart part) {
  gl.Begin(GL_TRIANGLES);
  for (const ColouredVertex& vertex : part) {
    gl.Color4f(0.25F, 0.6F, 0.4F, 1);
    gl.Vertex2fv(vertex.position.data());
  }
  gl.End();
}

// The other material changes within the primitive, beside the one that follows the colour.
void draw_with_materials_within(ColouredPart part) {
  const GLfloat emission[] = {0.1F, 0.15F, 0.05F, 1};
  gl.Begin(GL_TRIANGLES);
  for (const ColouredVertex& vertex : part) {
    if (&vertex == coloured_vertices + 4) gl.Materialfv(GL_FRONT_AND_BACK, GL_EMISSION, emission);
    gl.Color4fv(vertex.colour.data());
    gl.Vertex2fv(vertex.position.data());
  }
  gl.End();
}

constexpr GLuint coloured_list = 3;

struct ColouredDraw {
  const char* name;
  void (*draw)(ColouredPart part);
  bool is_listed = false;
  // Draws the same: with arrays, Mesa 22.3 may miss that a current colour has changed the material.
  void (*draw_plainly)(ColouredPart part) = nullptr;
};
constexpr ColouredDraw coloured_draws[] = {
    {"Begin and End", draw_between_begin_and_end},
    {"arrays", draw_by_arrays},
    {"the current colour", draw_in_current_colour, false, draw_in_one_colour},
    {"materials within the primitive", draw_with_materials_within},
    {"a list", draw_between_begin_and_end, true},
    {"a list with arrays", draw_by_arrays, true},
};

// All materials that GL keeps. Those that follow the colour are what the draw left.
std::vector<float> kept_materials() {
  std::vector<float> all;
  for (const GLenum face : {GL_FRONT, GL_BACK})
    for (const GLenum parameter : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION}) {
      std::array<GLfloat, 4> value{};
      gl.GetMaterialfv(face, parameter, value.data());
      all.insert(all.end(), value.begin(), value.end());
    }
  return all;
}

// Which parameter follows the colour, of which face; 0: none.
struct Tracked {
  GLenum face;
  GLenum parameter;
  bool is_two_sided;
};

void track(const Tracked& tracked) {
  if (tracked.face == 0) return gl.Disable(GL_COLOR_MATERIAL);
  gl.ColorMaterial(tracked.face, tracked.parameter);
  gl.Enable(GL_COLOR_MATERIAL);
}

// Each triangle alone, while both faces follow the colour or neither does: Mesa 22.3 loses colours where a material of the
// back face alone differs among the vertices.
Picture expected_picture(const ColouredDraw& each, const Tracked& tracked) {
  return picture_of([&] {
    for (const std::size_t triangle : {0U, 1U}) {
      const GLenum seen = triangle == 1 && tracked.is_two_sided ? GL_BACK : GL_FRONT;
      const bool follows = tracked.face == GL_FRONT_AND_BACK || tracked.face == seen;
      gl.Disable(GL_COLOR_MATERIAL);
      set_materials();
      track({follows ? GLenum{GL_FRONT_AND_BACK} : GLenum{0}, tracked.parameter, tracked.is_two_sided});
      (each.draw_plainly != nullptr ? each.draw_plainly : each.draw)(all_coloured.subspan(3 * triangle, 3));
    }
  });
}

struct Lit {
  Picture picture;
  std::vector<float> materials;
};

// Materials are set before each draw, as applications do. Those that follow the colour get it again.
Lit lit_by(const ColouredDraw& each, const Tracked& tracked) {
  gl.Disable(GL_COLOR_MATERIAL);
  set_materials();
  track(tracked);
  Lit lit;
  lit.picture = picture_of([&] { each.is_listed ? gl.CallList(coloured_list) : each.draw(all_coloured); });
  lit.materials = kept_materials();
  return lit;
}

void expect_lit(Test& t, const ColouredDraw& each, const Tracked& tracked, const std::string& what) {
  gl.Disable(GL_ARK);
  if (each.is_listed) {
    gl.NewList(coloured_list, GL_COMPILE);
    each.draw(all_coloured);
    gl.EndList();
  }
  const Picture expected = expected_picture(each, tracked);
  const Lit plain = lit_by(each, tracked);
  t.expect(count_different(expected, Picture(surface_size, surface_size), 8) > 1000, what + " draws something");
  gl.Enable(GL_ARK);
  lit_by(each, tracked);  // an implementation may learn from it which parameters change within primitives
  for (int again = 0; again < 4; ++again) {
    const Lit refined = lit_by(each, tracked);
    t.expect_same_picture(refined.picture, expected, what, 4, 80);
    for (std::size_t i = 0; i < plain.materials.size(); ++i)
      if (!t.expect_near(refined.materials[i], plain.materials[i], 1e-6, what + ": material " + as_text(i))) break;
  }
  const GLuint coarse = coloured_count / 3;
  t.expect_equal(count_generated([&] { each.is_listed ? gl.CallList(coloured_list) : each.draw(all_coloured); }),
                 16 * coarse, what + ": triangles");
}

void check_tracked(Test& t, GLenum face, GLenum parameter) {
  set_lights();
  std::size_t turn = 0;
  for (const GLenum refinement : {GL_LINEAR_OUTPUTS_ARK, GL_LINEAR_INPUTS_ARK}) {
    refine_uniformly(2, refinement);
    for (const bool is_two_sided : {true, false}) {
      const GLint control = ++turn % 2 == 0 ? GL_SINGLE_COLOR : GL_SEPARATE_SPECULAR_COLOR;
      gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, is_two_sided ? 1 : 0);
      gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, control);
      for (const ColouredDraw& each : coloured_draws)
        expect_lit(t, each, {face, parameter, is_two_sided},
                   fmt::format("{}, refinement 0x{:x}, {} sides", each.name, refinement, is_two_sided ? 2 : 1));
    }
  }
  t.expect_no_error("the draws");
}

// The face or the parameter that follows the colour changes between draws that repeat.
void check_retracked(Test& t, GLenum from, GLenum to) {
  set_lights();
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  refine_uniformly(2, GL_LINEAR_OUTPUTS_ARK);
  const ColouredDraw& arrays = coloured_draws[1];
  for (const TrackedParameter& first : tracked_parameters)
    for (const TrackedParameter& second : tracked_parameters) {
      expect_lit(t, arrays, {from, first.parameter, true}, fmt::format("{} at first", first.leaf));
      repeat_often([&] { arrays.draw(all_coloured); });
      expect_lit(t, arrays, {to, second.parameter, true}, fmt::format("{} after {}", second.leaf, first.leaf));
      expect_lit(t, arrays, {0, second.parameter, true}, fmt::format("without {}", second.leaf));
    }
  t.expect_no_error("the draws");
}

}  // namespace

Cases color_material_cases() {
  Cases cases;
  const char* const wrong = "The other face, or another parameter, follows the colour too, or instead.";
  for (const TrackedFace& face : tracked_faces) {
    for (const TrackedParameter& parameter : tracked_parameters)
      cases.push_back({.name = fmt::format("ark.fixed_function.color_material.{}.{}", face.leaf, parameter.leaf),
                       .clauses = {"11.R.10-1", "11.R.6-8", "chapter-14-13"},
                       .plan = "This parameter of this face follows the colour. Draw triangles that show their front "
                               "and their back, and compare with the unrefined draw; so are the materials it leaves.",
                       .wrong = wrong,
                       .apis = compat_only,
                       .check = [&face, &parameter](Test& t) { check_tracked(t, face.face, parameter.parameter); }});
    for (const TrackedFace& to : tracked_faces)
      cases.push_back({.name = fmt::format("ark.fixed_function.color_material.{}.then.{}", face.leaf, to.leaf),
                       .clauses = {"11.R.10-1", "11.R.6-8", "11.R.13-1"},
                       .plan = "Repeat a draw, change which parameter of which face follows the colour, and compare.",
                       .wrong = "The parameter that followed it before.",
                       .apis = compat_only,
                       .check = [&face, &to](Test& t) { check_retracked(t, face.face, to.face); }});
  }
  return cases;
}

}  // namespace glark::conformance
