// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Rasterization state applies to refined triangles. Their pictures are those of the reference rasterizer.
#include <fmt/core.h>
#include <cmath>

#include "conformance/cases/cases.h"
#include "conformance/reference/raster.h"
#include "conformance/support/counted.h"
#include "conformance/support/surface.h"

namespace glark::conformance {
namespace {

void draw_three() { gl.DrawArrays(GL_TRIANGLES, 0, 3); }

// The GL snaps window coordinates to 2^-SUBPIXEL_BITS. The comparison leaves out pixels whose centre lies within one
// such step of an edge.
double uncertainty() {
  GLint bits = 4;
  gl.GetIntegerv(GL_SUBPIXEL_BITS, &bits);
  return 1.5 * std::ldexp(1.0, -std::max(bits, 4));
}

void expect_raster(Test& t, const reference::Raster& raster, const Picture& actual, const char* what) {
  const int different = raster.count_different(actual, 2);
  if (different == 0) return static_cast<void>(t.expect(true, what));
  t.attach("expected", raster.picture());
  t.attach("actual", actual);
  t.fail(fmt::format("{}: {} pixels away from edges differ", what, different));
}

reference::RasterVertex raster_vertex(const Vec4& position, const Vec4& colour) { return {position, colour}; }

void check_coarse(Test& t) {
  gl.UseProgram(colour_program(t));
  Mesh mesh = one_triangle();
  mesh[1].position = {1.5F, -1.5F, 0, 2};
  upload(mesh, false);
  reference::Raster raster(surface_size, surface_size, uncertainty());
  raster.triangle(raster_vertex(mesh[0].position, mesh[0].colour), raster_vertex(mesh[1].position, mesh[1].colour),
                  raster_vertex(mesh[2].position, mesh[2].colour));
  expect_raster(t, raster, picture_of(draw_three), "the unrefined triangle");
}

struct ColouredVertex {
  Vec4 position;
  Vec4 colour;
};

// The program in use writes colours. The case computes the refined triangles from the vertices' weights.
void check_refined(Test& t, GLenum refinement) {
  Mesh mesh = bent_mesh();
  for (std::size_t i = 0; i < mesh.size(); ++i)
    mesh[i].colour = {static_cast<float>(i % 2), 0.2F * static_cast<float>(i), 1 - 0.15F * static_cast<float>(i), 1};
  for (std::size_t i = 0; i < mesh.size(); ++i) mesh[i].tag = static_cast<float>((3 * i + 2) % 5);
  gl.UseProgram(surface_program(t));
  upload(mesh);
  refine_by_tags(5, refinement);
  const auto vertices = capture_surface(t, mesh);
  reference::Raster raster(surface_size, surface_size, uncertainty());
  raster.set_depth_test(true);
  std::vector<reference::RasterVertex> computed;
  for (const SurfaceVertex& vertex : vertices) {
    const auto triangle = static_cast<std::size_t>(std::lround(vertex.triangle));
    const reference::Corners corners = corners_of(mesh, triangle);
    const reference::Vector p = reference::curved_pn(corners, vertex.weights).position;
    reference::RasterVertex made;
    made.position = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z), 1};
    for (std::size_t k = 0; k < 4; ++k) {
      const auto component = [&](std::size_t i) { return mesh[3 * triangle + i].colour[k]; };
      made.colour[k] = reference::refined(vertex.weights, component(0), component(1), component(2));
      const auto place = [&](std::size_t i) { return mesh[3 * triangle + i].position[k]; };
      if (refinement != GL_CURVED_PN_ARK)
        made.position[k] = reference::refined(vertex.weights, place(0), place(1), place(2));
    }
    computed.push_back(made);
  }
  for (std::size_t i = 0; i + 2 < computed.size(); i += 3)
    raster.triangle(computed[i], computed[i + 1], computed[i + 2]);
  gl.UseProgram(build_program(
      t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 1) in vec3 normal; out vec4 colour;\n"
                    "layout(location = 3) in vec4 tint;\n"
                    "void main() { colour = tint + vec4(normal * 1.0e-9, 0.0); gl_Position = position; }\n"}));
  gl.Enable(GL_DEPTH_TEST);
  const Picture actual = picture_of([] { gl.DrawArrays(GL_TRIANGLES, 0, 6); });
  gl.Disable(GL_DEPTH_TEST);
  expect_raster(t, raster, actual, "the refined mesh");
}

int count_lit(const Picture& picture) {
  int count = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const auto at = picture.at(x, y);
      count += at[0] + at[1] + at[2] > 0 ? 1 : 0;
    }
  return count;
}

// At uniform depth 2 the wire frame is that of 16 triangles, which the case draws as lines.
void check_polygon_mode_line(Test& t) {
  gl.UseProgram(build_program(t, {.vertex = "layout(location = 0) in vec4 position; out vec4 colour;\n"
                                            "void main() { colour = vec4(1.0); gl_Position = position; }\n"}));
  const Mesh mesh = one_triangle();
  Mesh lines;
  for (std::size_t family = 0; family < 3; ++family)
    for (int k = 0; k < 4; ++k) {
      const float s = static_cast<float>(k) / 4;
      MeshVertex from;
      MeshVertex to;
      for (std::size_t i = 0; i < 2; ++i) {
        const float apex = mesh[family].position[i];
        from.position[i] = s * apex + (1 - s) * mesh[(family + 1) % 3].position[i];
        to.position[i] = s * apex + (1 - s) * mesh[(family + 2) % 3].position[i];
      }
      lines.push_back(from);
      lines.push_back(to);
    }
  upload(lines);
  const Picture expected = picture_of([] { gl.DrawArrays(GL_LINES, 0, 24); });
  upload(mesh);
  refine_uniformly(2);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  const Picture actual = picture_of(draw_three);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  // A line drawn in pieces may light other pixels: rounding shifts a steep line by up to a pixel.
  int away = 0;
  for (int y = 1; y + 1 < surface_size; ++y)
    for (int x = 1; x + 1 < surface_size; ++x) {
      bool is_near = false;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) is_near = is_near || expected.at(x + dx, y + dy)[0] > 0;
      away += actual.at(x, y)[0] > 0 && !is_near ? 1 : 0;
    }
  t.expect_equal(away, 0, "pixels away from the edges of refined triangles");
  const int lit = count_lit(actual);
  const int wanted = count_lit(expected);
  if (!t.expect(lit > wanted * 9 / 10 && lit < wanted * 11 / 10,
                fmt::format("the wire frame has {} pixels, the lines have {}", lit, wanted))) {
    t.attach("expected", expected);
    t.attach("actual", actual);
  }
}

void check_polygon_mode_point(Test& t) {
  gl.UseProgram(colour_program(t));
  upload(one_triangle());
  refine_uniformly(3);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_POINT);
  const Picture points = picture_of(draw_three);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  // (2^3 + 1) (2^3 + 2) / 2 vertices.
  const int lit = count_lit(points);
  t.expect(lit >= 42 && lit <= 45, fmt::format("45 vertices are points, except for two in one pixel: {}", lit));
}

void check_edge_flags(Test& t) {
  gl.Color3f(1, 1, 1);
  const auto draw = [] {
    gl.Begin(GL_TRIANGLES);
    gl.EdgeFlag(GL_FALSE);
    gl.Vertex3f(-0.75F, -0.75F, 0);
    gl.Vertex3f(0.75F, -0.75F, 0);
    gl.Vertex3f(-0.25F, 0.75F, 0);
    gl.End();
  };
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  t.expect_equal(count_lit(picture_of(draw)), 0, "unrefined, no edge is a boundary edge");
  refine_uniformly(2);
  const int lit = count_lit(picture_of(draw));
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  t.expect(lit > 400, fmt::format("every edge of a refined triangle is drawn, {} pixels", lit));
}

void check_culling(Test& t, GLenum refinement) {
  gl.UseProgram(colour_program(t));
  Mesh mesh = one_triangle({3, 1, 4});
  upload(mesh);
  refine_by_tags(4, refinement);
  const int all = count_lit(picture_of(draw_three));
  gl.Enable(GL_CULL_FACE);
  t.expect_equal(count_lit(picture_of(draw_three)), all, "front faces, back faces culled");
  gl.CullFace(GL_FRONT);
  t.expect_equal(count_lit(picture_of(draw_three)), 0, "front faces culled");
  gl.FrontFace(GL_CW);
  t.expect_equal(count_lit(picture_of(draw_three)), all, "clockwise is front, front culled");
  gl.FrontFace(GL_CCW);
  std::swap(mesh[1], mesh[2]);
  upload(mesh);
  t.expect_equal(count_lit(picture_of(draw_three)), all, "a clockwise triangle, front faces culled");
}

void check_polygon_offset(Test& t) {
  gl.UseProgram(colour_program(t));
  Mesh mesh = one_triangle({3, 1, 4});
  mesh[2].position[2] = 0.5F;
  upload(mesh);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LESS);
  refine_by_tags(4);
  const int once = count_lit(picture_of(draw_three));
  t.expect(once > 0, "the triangle is drawn");
  gl.Enable(GL_POLYGON_OFFSET_FILL);
  gl.PolygonOffset(-1, -4);
  clear_surface();
  gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  gl.Disable(GL_POLYGON_OFFSET_FILL);
  draw_three();
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  draw_three();
  t.expect_equal(count_lit(read_picture(surface_size, surface_size)), 0, "equal depths are not less");
  gl.Enable(GL_POLYGON_OFFSET_FILL);
  draw_three();
  t.expect_equal(count_lit(read_picture(surface_size, surface_size)), once, "with an offset they are less, everywhere");
}

void check_two_sided(Test& t) {
  gl.Enable(GL_VERTEX_PROGRAM_TWO_SIDE);
  std::string log;
  const GLuint program =
      try_program({.vertex = "#version 120\nvoid main() { gl_FrontColor = vec4(1.0, 0.0, 0.0, 1.0);\n"
                             "  gl_BackColor = vec4(0.0, 1.0, 0.0, 1.0); gl_Position = gl_Vertex; }\n",
                   .fragment = "#version 120\nvoid main() { gl_FragColor = gl_Color; }\n"},
                  log);
  if (program == 0) t.internal_error(log);
  gl.UseProgram(program);
  refine_uniformly(2);
  const Picture picture = picture_of([] {
    gl.Begin(GL_TRIANGLES);
    for (const float x : {-0.9F, 0.9F}) {
      gl.Vertex3f(0, -0.9F, 0);
      gl.Vertex3f(x, 0, 0);
      gl.Vertex3f(0, 0.9F, 0);
    }
    gl.End();
  });
  t.expect(picture.at(surface_size * 3 / 4, surface_size / 2)[0] == 255, "the right triangle shows its front colour");
  t.expect(picture.at(surface_size / 4, surface_size / 2)[1] == 255, "the left triangle shows its back colour");
}

void check_clip_distances(Test& t, GLenum refinement, bool is_redeclared = true) {
  gl.UseProgram(build_program(
      t,
      {.vertex =
           std::string("layout(location = 0) in vec4 position; layout(location = 3) in vec4 tint; out vec4 colour;\n") +
           (is_redeclared ? "out float gl_ClipDistance[2];\n" : "") +
           "void main() { gl_ClipDistance[0] = position.x + 0.3 * position.y; gl_ClipDistance[1] = 0.25 - position.y;\n"
           "  colour = tint; gl_Position = position; }\n"}));
  upload(one_triangle({2, 4, 3}));
  gl.Enable(GL_CLIP_DISTANCE0);
  gl.Enable(GL_CLIP_DISTANCE1);
  const Picture expected = picture_of(draw_three);
  refine_by_tags(4, refinement);
  t.expect_same_picture(picture_of(draw_three), expected, "clipped by distances", 2, 20);
}

void check_clip_planes(Test& t, GLenum refinement) {
  const GLdouble plane[4] = {1, 0.4, 0, -0.1};
  gl.ClipPlane(GL_CLIP_PLANE0, plane);
  gl.Enable(GL_CLIP_PLANE0);
  const auto draw = [] {
    gl.Begin(GL_TRIANGLES);
    gl.Color3f(1, 0, 0);
    gl.Vertex3f(-0.75F, -0.75F, 0);
    gl.Color3f(0, 1, 0);
    gl.Vertex3f(0.75F, -0.75F, 0);
    gl.Color3f(0, 0, 1);
    gl.Vertex3f(-0.25F, 0.75F, 0);
    gl.End();
  };
  const Picture expected = picture_of(draw);
  refine_uniformly(3, refinement);
  t.expect_same_picture(picture_of(draw), expected, "clipped by a plane", 2, 20);
}

// The API sets the outputs' source indices; the shader does not. Blending multiplies the two outputs and drops the
// colour in the framebuffer.
void check_two_sources(Test& t, GLenum refinement) {
  const GLuint program = build_program(
      t,
      {.vertex = plain_vertex_shader,
       .fragment =
           "in vec4 colour; out vec4 pixel; out vec4 factor;\n"
           "void main() { pixel = vec4(colour.xyz, 1.0); factor = vec4(0.25, 0.5, 0.75, 0.5) + 0.25 * colour.yzxw; }"});
  gl.BindFragDataLocationIndexed(program, 0, 0, "pixel");
  gl.BindFragDataLocationIndexed(program, 0, 1, "factor");
  gl.LinkProgram(program);
  gl.UseProgram(program);
  upload(one_triangle({2, 1, 3}));
  const auto draw = [] {
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_SRC1_COLOR, GL_ONE_MINUS_SRC1_ALPHA);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    gl.Disable(GL_BLEND);
  };
  const Picture expected = picture_of(draw);
  gl.BindFragDataLocationIndexed(program, 0, 1, "pixel");  // takes effect when the program is linked
  t.expect(count_different(expected, Picture(surface_size, surface_size), 8) > 1000, "something is drawn");
  refine_by_tags(3, refinement);
  t.expect_same_picture(picture_of(draw), expected, "two sources", 2, 20);
  t.expect(count_generated(draw) > 1, "the triangle is refined");
  t.expect_equal(GLint{gl.GetFragDataIndex(program, "factor")}, 1, "the index of the second source");
  t.expect_no_error("the draws");
}

constexpr Area raster_case{"ark.rasterized."};

}  // namespace

Cases rasterization_cases() {
  Cases cases = {
      raster_case(
          "two_sources.inputs", {"11.R.10-2"}, "Blend with a second source whose index the API sets.",
          "The outputs have other indices in the program that draws refined triangles.",
          [](Test& t) { check_two_sources(t, GL_LINEAR_INPUTS_ARK); }, desktop_apis),
      raster_case(
          "two_sources.outputs", {"11.R.10-2"}, "The same with refined outputs.",
          "The outputs have other indices in the program that draws refined triangles.",
          [](Test& t) { check_two_sources(t, GL_LINEAR_OUTPUTS_ARK); }, desktop_apis),
      raster_case("polygon_mode.line", {"chapter-14-11", "chapter-14-12"},
                  "The wire frame at depth 2 is that of 16 triangles, which the case draws as lines.",
                  "The outline of the coarse triangle.", check_polygon_mode_line, desktop_apis),
      raster_case("polygon_mode.point", {"chapter-14-11"}, "45 points at depth 3.", "Three points.",
                  check_polygon_mode_point, desktop_apis),
      raster_case("edge_flags", {"chapter-14-12"},
                  "Edge flags are FALSE: nothing is drawn unrefined, every edge is drawn refined.",
                  "The corners' edge flags are kept or refined.", check_edge_flags, compat_only),
      raster_case("culling.inputs", {"chapter-14-13"},
                  "Front and back faces are culled, with both orientations of the triangle and of FrontFace.",
                  "Refined triangles have the wrong orientation.",
                  [](Test& t) { check_culling(t, GL_LINEAR_INPUTS_ARK); }),
      raster_case("culling.outputs", {"chapter-14-13"}, "The same with LINEAR_OUTPUTS_ARK.",
                  "Refined triangles have the wrong orientation.",
                  [](Test& t) { check_culling(t, GL_LINEAR_OUTPUTS_ARK); }),
      raster_case("polygon_offset", {"chapter-14-13", "11.R.13-1"},
                  "A second pass of the same draw has the same depths, and smaller depths with an offset.",
                  "The offset is lost; depths of two passes differ.", check_polygon_offset),
      raster_case("two_sided", {"chapter-14-13"}, "Two triangles, one of each orientation, with front and back colors.",
                  "All triangles show their front colour.", check_two_sided, compat_only),
      raster_case(
          "clip_plane.inputs", {"chapter-14-14"}, "A user clip plane with the fixed function.", "Not clipped.",
          [](Test& t) { check_clip_planes(t, GL_LINEAR_INPUTS_ARK); }, compat_only),
      raster_case(
          "clip_plane.outputs", {"chapter-14-14", "11.R.6-9"}, "A user clip plane with refined outputs.",
          "The clip vertex is not refined.", [](Test& t) { check_clip_planes(t, GL_LINEAR_OUTPUTS_ARK); }, compat_only),
      raster_case(
          "clip_distance.inputs", {"chapter-14-14"}, "Two clip distances.", "Not clipped.",
          [](Test& t) { check_clip_distances(t, GL_LINEAR_INPUTS_ARK); }, desktop_apis),
      raster_case(
          "clip_distance.outputs", {"chapter-14-14", "11.R.6-9"}, "Two clip distances with refined outputs.",
          "Not clipped, or clipped only by the first distance.",
          [](Test& t) { check_clip_distances(t, GL_LINEAR_OUTPUTS_ARK); }, desktop_apis),
      raster_case(
          "clip_distance.outputs_of_language", {"chapter-14-14", "11.R.6-9"},
          "Two clip distances as the language declares them, with refined outputs.", "The distances of one corner.",
          [](Test& t) { check_clip_distances(t, GL_LINEAR_OUTPUTS_ARK, false); }, desktop_apis),
  };
  const std::pair<const char*, GLenum> refinements[] = {{"picture.inputs", GL_LINEAR_INPUTS_ARK},
                                                        {"picture.outputs", GL_LINEAR_OUTPUTS_ARK},
                                                        {"picture.curved", GL_CURVED_PN_ARK}};
  for (const auto& [leaf, refinement] : refinements) {
    Case made = raster_case(leaf, {"overview-2", "11.R.7-1"},
                            "Draw a mesh with tags and a depth test. Compare with the suite's own rasterizer, which "
                            "draws the vertices of the reference, except for pixels within a subpixel step of an edge.",
                            "A missing triangle, a triangle at the wrong place, colours of the wrong corner.",
                            [refinement = refinement](Test& t) { check_refined(t, refinement); });
    made.control = check_coarse;
    cases.push_back(made);
  }
  return cases;
}

}  // namespace glark::conformance
