// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Commands that are allowed between Begin and End (GL 4.6 compatibility profile, 10.9), at each position of a primitive.
#include <fmt/core.h>

#include <memory>

#include "conformance/cases/cases.h"
#include "conformance/support/capture.h"
#include "conformance/support/counted.h"

namespace glark::conformance {
namespace {

struct WithinMode {
  const char* leaf;
  GLenum mode;
  int vertices;
  GLuint triangles;
};
constexpr WithinMode modes_within[] = {
    {"triangles", GL_TRIANGLES, 6, 2},       {"triangle_strip", GL_TRIANGLE_STRIP, 6, 4},
    {"triangle_fan", GL_TRIANGLE_FAN, 6, 4}, {"quads", GL_QUADS, 8, 4},
    {"quad_strip", GL_QUAD_STRIP, 8, 6},     {"polygon", GL_POLYGON, 6, 4}};

constexpr GLfloat material_red[] = {0.9F, 0.2F, 0.1F, 1};
constexpr GLfloat material_grey[] = {0.3F, 0.3F, 0.35F, 1};
constexpr GLint material_blue[] = {200000000, 400000000, 2000000000, 2147483647};

struct Within {
  const char* leaf;
  void (*call)();
};
constexpr Within commands_within[] = {
    {"Materialfv of DIFFUSE", [] { gl.Materialfv(GL_FRONT, GL_DIFFUSE, material_red); }},
    {"Materialfv of both sides", [] { gl.Materialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, material_red); }},
    {"Materialfv of EMISSION", [] { gl.Materialfv(GL_FRONT_AND_BACK, GL_EMISSION, material_grey); }},
    {"Materialiv of AMBIENT", [] { gl.Materialiv(GL_FRONT_AND_BACK, GL_AMBIENT, material_blue); }},
    {"Materialf of SHININESS", [] { gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 3); }},
    {"Materiali of SHININESS", [] { gl.Materiali(GL_FRONT, GL_SHININESS, 60); }},
    {"Materialfv of SPECULAR", [] { gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, material_red); }},
    {"Materialfv of the other side", [] { gl.Materialfv(GL_BACK, GL_DIFFUSE, material_red); }},
    {"Color", [] { gl.Color3f(0.2F, 0.9F, 0.3F); }},
    {"Normal", [] { gl.Normal3f(0.3F, 0.1F, 0.9F); }},
    {"SecondaryColor", [] { gl.SecondaryColor3f(0.1F, 0.5F, 0); }},
    {"FogCoord", [] { gl.FogCoordf(0.5F); }},
    {"TexCoord", [] { gl.TexCoord2f(0.5F, 0.25F); }},
    {"EdgeFlag", [] { gl.EdgeFlag(GL_FALSE); }},
    {"VertexAttrib", [] { gl.VertexAttrib4f(5, 1, 0, 1, 1); }},
    {"DepthTag1i", [] { gl.DepthTag1i(1); }},
};
constexpr std::size_t material_commands = 8;  // the first commands_within

void light_within() {
  const GLfloat light[] = {0.4F, 0.3F, 1, 0};
  const GLfloat specular[] = {0.3F, 0.5F, 0.4F, 1};
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  gl.Lightfv(GL_LIGHT0, GL_POSITION, light);
  gl.Lightfv(GL_LIGHT0, GL_SPECULAR, specular);
}

void reset_current() {
  gl.Materialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, material_grey);
  for (const GLenum parameter : {GL_EMISSION, GL_SPECULAR}) {
    const GLfloat value[] = {0.1F, 0.1F, 0.05F, 1};
    gl.Materialfv(GL_FRONT_AND_BACK, parameter, value);
  }
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 20);
  gl.Color3f(0.7F, 0.6F, 0.1F);
  gl.Normal3f(0, 0, 1);
  gl.SecondaryColor3f(0, 0, 0.3F);
  gl.FogCoordf(0);
  gl.TexCoord2f(0, 0);
  gl.EdgeFlag(GL_TRUE);
  gl.DepthTag1i(2);
}

// Convex in every mode: strips zigzag upwards, the others go round.
void vertex_within(const WithinMode& mode, int i) {
  const auto n = static_cast<float>(i);
  if (mode.mode == GL_TRIANGLE_STRIP || mode.mode == GL_QUAD_STRIP)
    return gl.Vertex2f(i % 2 == 0 ? 0.8F : -0.75F, -0.9F + 0.23F * n);
  if (mode.mode == GL_TRIANGLE_FAN || mode.mode == GL_POLYGON) {
    const float corners[][2] = {{-0.6F, -0.8F}, {0.5F, -0.9F}, {0.9F, -0.2F}, {0.7F, 0.6F}, {0, 0.9F}, {-0.8F, 0.3F}};
    return gl.Vertex2f(corners[i][0], corners[i][1]);
  }
  const int each = mode.mode == GL_QUADS ? 4 : 3;
  const float corners[][2] = {{-0.4F, -0.8F}, {0.4F, -0.7F}, {0.35F, 0.8F}, {-0.35F, 0.6F}};
  gl.Vertex2f(corners[i % each][0] + (i < each ? -0.5F : 0.5F), corners[i % each][1]);
}

// `call` before the vertices whose bits are set.
void draw_with(const WithinMode& mode, unsigned positions, void (*call)()) {
  reset_current();
  gl.Begin(mode.mode);
  for (int i = 0; i <= mode.vertices; ++i) {
    if ((positions >> static_cast<unsigned>(i) & 1U) != 0) call();
    if (i < mode.vertices) vertex_within(mode, i);
  }
  gl.End();
}

// With the outputs refined, and with a uniform depth, the picture is the unrefined one.
void expect_same(Test& t, const WithinMode& mode, unsigned positions, const Within& command, bool is_listed) {
  const std::string what = fmt::format("{} before vertices {:b}", command.leaf, positions);
  const auto plain_draw = [&] { draw_with(mode, positions, command.call); };
  if (is_listed) {
    gl.NewList(2, GL_COMPILE);
    plain_draw();
    gl.EndList();
  }
  const auto draw = [&] { is_listed ? gl.CallList(2) : plain_draw(); };
  draw();  // an implementation may learn from it which parameters change within primitives
  GLuint count = 0;
  const Picture refined = picture_of([&] { count = count_generated(draw); });
  gl.Disable(GL_ARK);
  const Picture plain = picture_of(draw);
  gl.Enable(GL_ARK);
  t.expect(count_different(plain, Picture(surface_size, surface_size), 8) > 1000, what + ": something is drawn");
  t.expect_equal(count, 16 * mode.triangles, what + ": triangles");
  t.expect_same_picture(refined, plain, what, 4, 80);
}

constexpr unsigned patterns_of_positions[] = {0x1FF, 0x4A, 0x55};

void check_positions_within(Test& t, const WithinMode& mode) {
  light_within();
  refine_uniformly(2, GL_LINEAR_OUTPUTS_ARK);
  for (const Within& command : commands_within) {
    const bool is_material = &command - commands_within < static_cast<std::ptrdiff_t>(material_commands);
    for (unsigned i = 0; i <= static_cast<unsigned>(mode.vertices); ++i)
      if (is_material || i == 2 || i == 3) expect_same(t, mode, 1U << i, command, false);
    for (const unsigned several : patterns_of_positions) expect_same(t, mode, several, command, false);
  }
  // The lit colour is linear in these, so that refined inputs give the same picture.
  refine_uniformly(2, GL_LINEAR_INPUTS_ARK);
  for (const Within& command : {commands_within[0], commands_within[2]})
    for (unsigned i = 0; i <= static_cast<unsigned>(mode.vertices); ++i) expect_same(t, mode, 1U << i, command, false);
  t.expect_no_error("the draws");
}

// Each parameter of each face changes within a primitive for the first time. Whatever an implementation then does about the
// colours, it draws and refines the whole primitive.
constexpr GLenum parameters[] = {GL_DIFFUSE, GL_EMISSION, GL_AMBIENT, GL_SPECULAR, GL_SHININESS};

void check_first_within(Test& t, const WithinMode& mode) {
  unsigned turn = 0;
  for (const GLenum face : {GL_FRONT, GL_BACK})
    for (const unsigned shift : {0U, 1U, 2U}) {
      const std::unique_ptr<Context> context = t.create_context();
      light_within();
      refine_uniformly(2, GL_LINEAR_OUTPUTS_ARK);
      for (const GLenum parameter : parameters) {
        const unsigned position = 1 + (turn++ + shift) % static_cast<unsigned>(mode.vertices);
        const auto draw = [&] {
          gl.Begin(mode.mode);
          for (int i = 0; i < mode.vertices; ++i) {
            if (static_cast<unsigned>(i) == position) gl.Materialfv(face, parameter, material_grey);
            vertex_within(mode, i);
          }
          gl.End();
        };
        const std::string what = fmt::format("0x{:x} of 0x{:x} before vertex {}", parameter, face, position);
        for (int again = 0; again < 2; ++again)
          t.expect_equal(count_generated(draw), 16 * mode.triangles, what + ": triangles");
      }
      t.expect_no_error("the draws");
    }
}

// Each vertex has its own material, in a new context: the first picture is right.
void check_each_within(Test& t, const WithinMode& mode) {
  for (const Within& command : {commands_within[0], commands_within[1], commands_within[2], commands_within[3]})
    for (const bool is_smooth : {true, false}) {
      const std::unique_ptr<Context> context = t.create_context();
      light_within();
      gl.ShadeModel(is_smooth ? GL_SMOOTH : GL_FLAT);
      const auto draw = [&] {
        reset_current();
        gl.Begin(mode.mode);
        for (int i = 0; i < mode.vertices; ++i) {
          gl.Materialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, i % 2 == 0 ? material_red : material_grey);
          command.call();
          vertex_within(mode, i);
        }
        gl.End();
      };
      refine_uniformly(2, GL_LINEAR_OUTPUTS_ARK);
      gl.Disable(GL_ARK);
      const Picture plain = picture_of(draw);
      gl.Enable(GL_ARK);
      for (int again = 0; again < 3; ++again)
        t.expect_same_picture(picture_of(draw), plain, command.leaf + std::string(is_smooth ? ", smooth" : ", flat"), 4,
                              80);
      t.expect_no_error("the draws");
    }
}

// A list whose first vertices inherit a material that it changes may stay unrefined.
void check_lists_within(Test& t, const WithinMode& mode) {
  light_within();
  refine_uniformly(2, GL_LINEAR_OUTPUTS_ARK);
  for (const Within& command : commands_within)
    for (const unsigned i : {2U, 3U}) expect_same(t, mode, 1U << i | 1U, command, true);
  t.expect_no_error("the draws");
}

}  // namespace

Cases within_begin_cases() {
  Cases cases;
  const char* const wrong = "The primitive is cut there: it is not drawn, or not refined.";
  for (const WithinMode& mode : modes_within)
    cases.push_back({.name = std::string("ark.draw.within.") + mode.leaf + ".first",
                     .clauses = {"10.R.2-1", "10.R.2-2"},
                     .plan = "In new contexts, change each material before each vertex of a primitive, and count.",
                     .wrong = wrong,
                     .apis = compat_only,
                     .check = [&mode](Test& t) { check_first_within(t, mode); }});
  for (const WithinMode& mode : modes_within)
    cases.push_back({.name = std::string("ark.draw.within.") + mode.leaf + ".each",
                     .clauses = {"10.R.2-1", "11.R.10-1"},
                     .plan = "In new contexts, draw vertices that each set their own material, and compare the first "
                             "pictures with the unrefined one.",
                     .wrong = "The first time, all vertices have the last material.",
                     .apis = compat_only,
                     .check = [&mode](Test& t) { check_each_within(t, mode); }});
  for (const WithinMode& mode : modes_within)
    for (const bool is_listed : {false, true})
      cases.push_back({.name = std::string("ark.draw.within.") + mode.leaf + (is_listed ? ".listed" : ".direct"),
                       .clauses = {"10.R.2-1", "10.R.2-2"},
                       .plan = "Change the material, or another current state, before each vertex of a primitive in "
                               "turn; count triangles and compare with the unrefined picture.",
                       .wrong = wrong,
                       .apis = compat_only,
                       .check = [&mode, is_listed](Test& t) {
                         is_listed ? check_lists_within(t, mode) : check_positions_within(t, mode);
                       }});
  return cases;
}

}  // namespace glark::conformance
