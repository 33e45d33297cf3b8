// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Primitives that are not refined: points, lines, rectangles, evaluator meshes, bitmaps, pixels (10.R.2). Also draws
// without attributes from vertex arrays, whose picture must not change.
#include <utility>

#include "conformance/cases/cases.h"
#include "conformance/support/capture.h"

namespace glark::conformance {
namespace {

// A vertex stage that moves all points between corners, so that refinement shows.
const char bending[] =
    "layout(location = 0) in vec4 position; layout(location = 3) in vec4 vertex_colour; out vec4 colour;\n"
    "void main() { colour = vertex_colour; vec2 p = position.xy;\n"
    "  gl_Position = vec4(p.x + 0.2 * cos(4.0 * p.y), p.y + 0.2 * cos(3.0 * p.x), 0.0, 1.0); }\n";

std::size_t count_captured(Test& t, GLenum mode, GLenum feedback) {
  return capture_as<CapturedVertex>(
             t, 1000, [mode] { gl.DrawArrays(mode, 0, 12); }, feedback)
      .size();
}

Mesh fan_mesh() {
  Mesh mesh(12);
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const auto n = static_cast<float>(i);
    mesh[i].position = {-0.9F + 0.15F * n, i % 2 == 0 ? -0.6F : 0.5F + n / 40, 0, 1};
    mesh[i].colour = {n / 12, 1, 1 - n / 12, 1};
    mesh[i].tag = static_cast<float>(3 - i % 3);
  }
  return mesh;
}

void check_primitive(Test& t, GLenum mode) {
  const bool has_points = mode == GL_POINTS;
  gl.UseProgram(capture_program(t));
  upload(fan_mesh());
  const std::size_t coarse = count_captured(t, mode, has_points ? GL_POINTS : GL_LINES);
  refine_by_tags(3);
  t.expect_equal(count_captured(t, mode, has_points ? GL_POINTS : GL_LINES), coarse, "vertices by tags");
  refine_uniformly(2);
  t.expect_equal(count_captured(t, mode, has_points ? GL_POINTS : GL_LINES), coarse, "vertices at uniform depth 2");
  t.expect(coarse > 0, "primitives are captured");
}

void check_primitive_picture(Test& t, GLenum mode) {
  gl.UseProgram(build_program(t, {.vertex = bending}));
  upload(fan_mesh());
  const auto draw = [mode] {
    clear_surface();
    gl.DrawArrays(mode, 0, 12);
    return read_picture(surface_size, surface_size);
  };
  const Picture plain = draw();
  refine_uniformly(3);
  t.expect_same_picture(draw(), plain, "while ARK is enabled");
  t.expect_no_error("drawing");
}

// Checks that the strip is drawn at all without refinement. Otherwise equal pictures would prove nothing.
void control_bending(Test& t) {
  gl.UseProgram(build_program(t, {.vertex = bending}));
  upload(fan_mesh(), false);
  clear_surface();
  gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 12);
  const Picture picture = read_picture(surface_size, surface_size);
  t.expect(count_different(picture, Picture(surface_size, surface_size), 0) > 500, "the strip is drawn");
}

void expect_unchanged(Test& t, const std::function<void()>& draw) {
  const auto picture = [&] {
    clear_surface();
    draw();
    return read_picture(surface_size, surface_size);
  };
  const Picture plain = picture();
  t.expect(count_different(plain, Picture(surface_size, surface_size), 0) > 50, "something is drawn unrefined");
  refine_uniformly(3);
  t.expect_same_picture(picture(), plain, "while ARK is enabled");
  t.expect_no_error("drawing");
}

void check_rect(Test& t) {
  gl.UseProgram(build_program(t, {.vertex = bending}));
  gl.VertexAttrib4f(at_colour, 1, 0.5F, 0.25F, 1);
  expect_unchanged(t, [] { gl.Rectf(-0.6F, -0.5F, 0.5F, 0.7F); });
}

void check_rect_of_list(Test& t) {
  gl.UseProgram(build_program(t, {.vertex = bending}));
  gl.VertexAttrib4f(at_colour, 1, 0.5F, 0.25F, 1);
  gl.ARKinit(3);
  const GLuint list = gl.GenLists(1);
  gl.NewList(list, GL_COMPILE);
  gl.Rectf(-0.6F, -0.5F, 0.5F, 0.7F);
  gl.EndList();
  expect_unchanged(t, [list] { gl.CallList(list); });
}

void check_evaluator(Test& t) {
  gl.UseProgram(build_program(t, {.vertex = bending}));
  gl.VertexAttrib4f(at_colour, 1, 0.5F, 0.25F, 1);
  const GLfloat points[2][2][3] = {{{-0.6F, -0.6F, 0}, {0.6F, -0.5F, 0}}, {{-0.5F, 0.6F, 0}, {0.7F, 0.5F, 0}}};
  gl.Map2f(GL_MAP2_VERTEX_3, 0, 1, 3, 2, 0, 1, 6, 2, &points[0][0][0]);
  gl.Enable(GL_MAP2_VERTEX_3);
  gl.MapGrid2f(2, 0, 1, 2, 0, 1);
  expect_unchanged(t, [] { gl.EvalMesh2(GL_FILL, 0, 2, 0, 2); });
}

void check_bitmap(Test& t) {
  const GLubyte bits[16] = {0xF0, 0xF0, 0xCC, 0x33, 0xFF, 0x81, 0x81, 0xFF,
                            0x0F, 0xAA, 0x55, 0x18, 0x3C, 0x7E, 0xFF, 1};
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  expect_unchanged(t, [&] {
    gl.Color4f(1, 1, 0, 1);
    gl.RasterPos2f(-0.25F, -0.25F);
    gl.Bitmap(8, 16, 0, 0, 4, 4, bits);
  });
}

void check_pixels(Test& t) {
  std::vector<GLubyte> pixels(4 * 16 * 16);
  for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = static_cast<GLubyte>(i * 7 + 40);
  expect_unchanged(t, [&] {
    gl.RasterPos2f(-0.5F, -0.5F);
    gl.DrawPixels(16, 16, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    gl.RasterPos2f(0.25F, 0.25F);
    gl.CopyPixels(32, 32, 16, 16, GL_COLOR);
  });
}

// Primitives of every API, ordinary and with adjacency. The cases above have those of the compatibility profile.
struct Mode {
  const char* name;
  GLenum mode;
};
constexpr Mode modes[] = {
    {"points", GL_POINTS}, {"lines", GL_LINES}, {"line_strip", GL_LINE_STRIP}, {"line_loop", GL_LINE_LOOP}};
constexpr Mode adjacency[] = {{"lines_adjacency", GL_LINES_ADJACENCY},
                              {"line_strip_adjacency", GL_LINE_STRIP_ADJACENCY},
                              {"triangles_adjacency", GL_TRIANGLES_ADJACENCY},
                              {"triangle_strip_adjacency", GL_TRIANGLE_STRIP_ADJACENCY}};

Case unchanged_case(const char* leaf, const char* plan, void (*check)(Test&)) {
  return {.name = std::string("ark.draw.unrefined.") + leaf,
          .clauses = {"10.R.2-4"},
          .plan = plan,
          .wrong = "The primitive is refined, so its sides bend; an error; nothing is drawn.",
          .apis = compat_only,
          .check = check};
}

}  // namespace

Cases unrefined_primitives_cases() {
  Cases cases = {
      unchanged_case("rect", "Draw Rectf with a program that bends refined primitives.", check_rect),
      unchanged_case("rect_of_list", "The same from a display list that was compiled after ARKinit.",
                     check_rect_of_list),
      unchanged_case("evaluator_mesh", "Draw an evaluator mesh with a program that bends refined primitives.",
                     check_evaluator),
      unchanged_case("bitmap", "Draw a bitmap.", check_bitmap),
      unchanged_case("pixels", "DrawPixels and CopyPixels.", check_pixels),
  };
  for (const Mode& mode : modes)
    cases.push_back({.name = std::string("ark.draw.unrefined.captured.") + mode.name,
                     .clauses = {"10.R.2-3"},
                     .plan = "Capture the primitives with and without ARK: their number is the same.",
                     .wrong = "Lines between refined vertices; triangles.",
                     .check = [mode](Test& t) { check_primitive(t, mode.mode); }});
  const auto add_picture = [&](const Mode& mode) {
    cases.push_back({.name = std::string("ark.draw.unrefined.picture.") + mode.name,
                     .clauses = {"10.R.2-3"},
                     .plan = "Draw with a program that bends refined primitives: the picture is the one without ARK.",
                     .wrong = "Bent primitives; nothing.",
                     .apis = every_api,
                     .control = control_bending,
                     .check = [mode](Test& t) { check_primitive_picture(t, mode.mode); }});
  };
  for (const Mode& mode : modes) add_picture(mode);
  for (const Mode& mode : adjacency) add_picture(mode);
  return cases;
}

}  // namespace glark::conformance
