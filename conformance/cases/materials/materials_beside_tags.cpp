// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Materials of vertices between Begin and End, beside depth tags of vertices whose attribute has been moved. The fixed
// function has no attribute for a material, so an implementation has to find one that nothing else uses.
#include <fmt/core.h>

#include <algorithm>

#include "conformance/cases/cases.h"
#include "conformance/support/capture.h"
#include "conformance/support/counted.h"
#include "conformance/support/state.h"

namespace glark::conformance {
namespace {

constexpr GLuint attributes = 16;  // GL has at least so many
constexpr GLuint materials_list = 4;

struct MaterialParameter {
  const char* name;
  GLenum parameter;
};
constexpr MaterialParameter parameters_beside[] = {
    {"AMBIENT", GL_AMBIENT},   {"DIFFUSE", GL_DIFFUSE},     {"SPECULAR", GL_SPECULAR},
    {"EMISSION", GL_EMISSION}, {"SHININESS", GL_SHININESS}, {"AMBIENT_AND_DIFFUSE", GL_AMBIENT_AND_DIFFUSE}};

// Where the attributes of the extension are.
struct Slots {
  GLuint tag;
  GLuint discontinuity;
  GLuint scalar;
};

void move_attributes(const Slots& slots) {
  gl.ARKParameteriARK(GL_DEPTH_TAG_ATTRIBUTE_ARK, static_cast<GLint>(slots.tag));
  gl.ARKParameteriARK(GL_DISCONTINUITY_ATTRIBUTE_ARK, static_cast<GLint>(slots.discontinuity));
  gl.ARKParameteriARK(GL_SCALAR_TAG_ATTRIBUTE_ARK, static_cast<GLint>(slots.scalar));
}

void light_materials() {
  const GLfloat towards[] = {0.4F, 0.3F, 1, 0};
  const GLfloat behind[] = {0.1F, -0.4F, -1, 0};
  const GLfloat half[] = {0.5F, 0.6F, 0.4F, 1};
  gl.Enable(GL_LIGHTING);
  gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, half);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  for (const auto& [light, position] :
       {std::pair<GLenum, const GLfloat*>{GL_LIGHT0, towards}, std::pair<GLenum, const GLfloat*>{GL_LIGHT1, behind}}) {
    gl.Enable(light);
    gl.Lightfv(light, GL_POSITION, position);
    gl.Lightfv(light, GL_DIFFUSE, half);
    gl.Lightfv(light, GL_SPECULAR, half);
  }
}

void set_one_material(GLenum face, GLenum parameter, int salt) {
  if (parameter == GL_SHININESS) {
    gl.Materialf(face, parameter, static_cast<GLfloat>(2 + salt % 5 * 6));
    return;
  }
  const auto part = [salt](int k) { return 0.05F + static_cast<float>((3 * salt + 2 * k) % 7) / 20; };
  const GLfloat value[] = {part(0), part(1), part(2), 1};
  gl.Materialfv(face, parameter, value);
}

void reset_materials() {
  for (const MaterialParameter& each : parameters_beside)
    for (const GLenum face : {GL_FRONT, GL_BACK}) set_one_material(face, each.parameter, face == GL_FRONT ? 1 : 4);
}

// Which materials the vertices set.
struct Changing {
  std::vector<GLenum> parameters;
  std::vector<GLenum> faces;
};

// The first triangle shows its front and has tags of 1, the second one shows its back and has tags of 2.
constexpr GLfloat corners[6][2] = {{-0.9F, -0.8F}, {0, -0.7F},   {-0.5F, 0.8F},
                                   {0.1F, -0.8F},  {0.4F, 0.9F}, {0.9F, -0.6F}};

void draw_materials(const Changing& changing) {
  gl.Normal3f(0.2F, 0.1F, 0.9F);
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 6; ++i) {
    gl.DepthTag1i(i < 3 ? 1 : 2);
    for (const GLenum parameter : changing.parameters)
      for (const GLenum face : changing.faces) set_one_material(face, parameter, i + (face == GL_BACK ? 3 : 0));
    gl.Vertex2fv(corners[i]);
  }
  gl.End();
}
constexpr GLuint refined_triangles = 4 + 16;

// Each triangle alone, while both faces have the materials of the one that is seen: Mesa 22.3 loses colours where a material
// of the back face alone differs among the vertices.
void draw_expected_materials(const Changing& changing) {
  gl.Normal3f(0.2F, 0.1F, 0.9F);
  for (const int triangle : {0, 1}) {
    const GLenum seen = triangle == 0 ? GL_FRONT : GL_BACK;
    const bool changes = std::find(changing.faces.begin(), changing.faces.end(), seen) != changing.faces.end();
    for (const MaterialParameter& each : parameters_beside)
      set_one_material(GL_FRONT_AND_BACK, each.parameter, seen == GL_FRONT ? 1 : 4);
    gl.Begin(GL_TRIANGLES);
    for (int i = 3 * triangle; i < 3 * triangle + 3; ++i) {
      for (const GLenum parameter : changing.parameters)
        if (changes) set_one_material(GL_FRONT_AND_BACK, parameter, i + (seen == GL_BACK ? 3 : 0));
      gl.Vertex2fv(corners[i]);
    }
    gl.End();
  }
}

// The current values of all generic attributes, except for the attribute of the tags, which the draw sets.
std::vector<float> other_values(GLuint tag) {
  std::vector<float> all;
  for (GLuint i = 1; i < attributes; ++i) {
    if (i == tag) continue;
    const std::vector<float> value = current_value(i);
    all.insert(all.end(), value.begin(), value.end());
  }
  return all;
}

void expect_materials(Test& t, const Slots& slots, const Changing& changing, bool is_listed, const std::string& what) {
  gl.Disable(GL_ARK);
  const auto direct = [&] { draw_materials(changing); };
  if (is_listed) {
    gl.NewList(materials_list, GL_COMPILE);
    direct();
    gl.EndList();
  }
  const auto draw = [&] {
    reset_materials();
    is_listed ? gl.CallList(materials_list) : direct();
  };
  const Picture plain = picture_of([&] { draw_expected_materials(changing); });
  t.expect(count_different(plain, Picture(surface_size, surface_size), 8) > 1000, what + ": something is drawn");
  gl.Enable(GL_ARK);
  draw();  // an implementation may learn from it which parameters change within primitives
  for (GLuint i = 1; i < attributes; ++i)
    if (i != slots.tag) gl.VertexAttrib4f(i, static_cast<float>(i), 0.25F, -1, 0.5F);
  const std::vector<float> before = other_values(slots.tag);
  for (int again = 0; again < 2; ++again) {
    GLuint count = 0;
    const Picture refined = picture_of([&] { count = count_generated(draw); });
    t.expect_equal(count, refined_triangles, what + ": triangles");
    t.expect_same_picture(refined, plain, what, 4, 80);
  }
  t.expect(other_values(slots.tag) == before, what + ": the values of other attributes");
  t.expect_equal(integer_of(GL_CURRENT_DEPTH_TAG_ARK), 2, what + ": the tag that the last vertex leaves");
  t.expect_equal(current_value(slots.tag)[0], 2.0F, what + ": the attribute of the tags");
}

Slots slots_for(GLuint tag, GLuint turn) {
  const auto other = [&](GLuint step) { return 1 + (tag - 1 + step) % (attributes - 1); };
  return {tag, other(1 + turn), other(4 + 2 * turn)};
}

void check_beside(Test& t, GLuint tag, bool is_listed) {
  light_materials();
  refine_by_tags(3, GL_LINEAR_OUTPUTS_ARK);
  for (const MaterialParameter& each : parameters_beside)
    for (const std::vector<GLenum>& faces :
         {std::vector<GLenum>{GL_FRONT}, std::vector<GLenum>{GL_BACK}, std::vector<GLenum>{GL_FRONT, GL_BACK}}) {
      const Slots slots = slots_for(tag, each.parameter % 3);
      move_attributes(slots);
      expect_materials(t, slots, {{each.parameter}, faces}, is_listed,
                       fmt::format("{} of {} faces, the tag at {}", each.name, faces.size(), tag));
    }
  t.expect_no_error("the draws");
}

// All parameters of both faces at once, while the attributes of the extension are anywhere.
void check_all_beside(Test& t, GLuint tag) {
  light_materials();
  refine_by_tags(3, GL_LINEAR_OUTPUTS_ARK);
  for (const GLuint turn : {0U, 1U, 2U})
    for (const bool is_listed : {false, true}) {
      const Slots slots = slots_for(tag, turn);
      move_attributes(slots);
      expect_materials(
          t, slots, {{GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_SHININESS}, {GL_FRONT, GL_BACK}}, is_listed,
          fmt::format("all parameters, the tag at {}, others at {} and {}", tag, slots.discontinuity, slots.scalar));
    }
  t.expect_no_error("the draws");
}

// The attribute moves between draws that repeat: what the vertices of the earlier draws carried is where it was.
void check_moved(Test& t) {
  light_materials();
  refine_by_tags(3, GL_LINEAR_OUTPUTS_ARK);
  const Changing changing{{GL_DIFFUSE, GL_EMISSION}, {GL_FRONT, GL_BACK}};
  for (GLuint step = 0; step < 2 * attributes; ++step) {
    const Slots slots = slots_for(1 + (7 * step) % (attributes - 1), step % 3);
    move_attributes(slots);
    expect_materials(t, slots, changing, step % 4 == 3, fmt::format("step {}, the tag at {}", step, slots.tag));
  }
  t.expect_no_error("the draws");
}

}  // namespace

Cases materials_beside_tags_cases() {
  Cases cases;
  const char* const wrong =
      "A material is taken for a depth tag or a tag for a material, or the values are not restored.";
  for (GLuint tag = 1; tag < attributes; ++tag) {
    for (const bool is_listed : {false, true})
      cases.push_back({.name = fmt::format("ark.draw.within.tags_at_{}{}", tag, is_listed ? ".listed" : ""),
                       .clauses = {"10.R.1-2", "10.R.1-13", "10.R.1-29", "11.R.10-1"},
                       .plan = "Move the attribute of the tags here. Each vertex has a tag and a material of its own: "
                               "count triangles, compare the picture, and read all attributes.",
                       .wrong = wrong,
                       .apis = compat_only,
                       .check = [tag, is_listed](Test& t) { check_beside(t, tag, is_listed); }});
    cases.push_back({.name = fmt::format("ark.draw.within.tags_at_{}.all", tag),
                     .clauses = {"10.R.1-2", "10.R.1-13", "10.R.1-29", "11.R.10-1"},
                     .plan = "The same, with all parameters of both faces at once.",
                     .wrong = wrong,
                     .apis = compat_only,
                     .check = [tag](Test& t) { check_all_beside(t, tag); }});
  }
  cases.push_back({.name = "ark.draw.within.tags_moved",
                   .clauses = {"10.R.1-29", "11.R.10-1"},
                   .plan = "Move the attribute of the tags between draws whose vertices have materials.",
                   .wrong = "The material is read from, or written to, the attribute of an earlier draw.",
                   .apis = compat_only,
                   .check = check_moved});
  return cases;
}

}  // namespace glark::conformance
