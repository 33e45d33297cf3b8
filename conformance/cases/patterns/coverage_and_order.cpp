// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Order (11.R.12), repeatability (11.R.13), and watertightness: the draw covers every pixel inside a mesh exactly once.
#include <fmt/core.h>
#include <algorithm>
#include <utility>

#include "conformance/cases/cases.h"
#include "conformance/support/refined_draw.h"

namespace glark::conformance {
namespace {

// A vertex stage that bends the inside of the surface and keeps its border.
const char bending_stage[] =
    "layout(location = 0) in vec4 position; layout(location = 1) in vec3 normal;\n"
    "layout(location = 3) in vec4 vertex_colour; out vec4 colour;\n"
    "void main() { vec2 p = position.xy; vec2 inside = vec2(1.0) - p * p;\n"
    "  colour = max(vertex_colour, vec4(1e-9 * normal.z));\n"
    "  gl_Position = vec4(p + 0.12 * inside * sin(3.0 * p.yx), 0.25 * p.x + 0.1 * cos(3.0 * p.y), 1.0); }\n";

// n x n quadrilaterals over the whole surface, jittered inside, with two triangles each. Each place has one tag.
Mesh grid(Test& t, int n, int greatest_tag) {
  std::vector<MeshVertex> vertices;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) {
      MeshVertex vertex;
      const float step = 2.0F / static_cast<float>(n);
      const auto jitter = [&](int i) { return i == 0 || i == n ? 0.0F : t.random_float(-0.25F, 0.25F) * step; };
      vertex.position = {-1 + step * static_cast<float>(x) + jitter(x), -1 + step * static_cast<float>(y) + jitter(y),
                         0, 1};
      if (x == n) vertex.position[0] = 1;
      if (y == n) vertex.position[1] = 1;
      vertex.normal = {t.random_float(-0.2F, 0.2F), t.random_float(-0.2F, 0.2F), 1};
      vertex.colour = {0.125F, 0.125F, 0.125F, 0.125F};
      vertex.tag = static_cast<float>(t.random_int(0, greatest_tag));
      vertices.push_back(vertex);
    }
  Mesh mesh;
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const auto at = [&](int right, int up) {
        const int index = (y + up) * (n + 1) + x + right;
        return vertices[static_cast<std::size_t>(index)];
      };
      const bool turned = t.random_int(0, 1) == 1;
      const std::array<MeshVertex, 6> corners =
          turned ? std::array<MeshVertex, 6>{at(0, 0), at(1, 0), at(1, 1), at(1, 1), at(0, 1), at(0, 0)}
                 : std::array<MeshVertex, 6>{at(1, 0), at(1, 1), at(0, 1), at(0, 0), at(1, 0), at(0, 1)};
      mesh.insert(mesh.end(), corners.begin(), corners.end());
    }
  return mesh;
}

Picture additive_picture(const Mesh& mesh) {
  clear_surface();
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE);
  gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(mesh.size()));
  gl.Disable(GL_BLEND);
  return read_picture(surface_size, surface_size);
}

struct Covering {
  const char* name;
  GLenum refinement;
  GLenum interior;
  GLenum source;
  bool is_bent;
};

// 0.125 of every channel, once: 32 of 255.
void check_covering(Test& t, const Covering& covering) {
  gl.UseProgram(build_program(t, {.vertex = covering.is_bent ? bending_stage : plain_vertex_shader}));
  const Mesh mesh = grid(t, 7, 5);
  upload(mesh);
  refine_by_tags(5, covering.refinement);
  gl.ARKParameteriARK(GL_PATTERN_INTERIOR_ARK, static_cast<GLint>(covering.interior));
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, static_cast<GLint>(covering.source));
  gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 3);
  gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, 5);
  const Picture once(surface_size, surface_size, {32, 32, 32, 255});
  t.expect_same_picture(additive_picture(mesh), once, "every pixel is drawn exactly once", 1);
}

void control_covering(Test& t) {
  gl.UseProgram(build_program(t, {.vertex = bending_stage}));
  const Mesh mesh = grid(t, 7, 5);
  upload(mesh, false);
  const Picture once(surface_size, surface_size, {32, 32, 32, 255});
  t.expect_same_picture(additive_picture(mesh), once, "every pixel is drawn exactly once unrefined", 1);
}

// An octahedron with curved faces and random tags: every ray that enters leaves.
Mesh octahedron(Test& t) {
  const Vec3 places[] = {{0.8F, 0.05F, 0}, {-0.75F, 0.1F, 0}, {0.03F, 0.8F, 0.1F},
                         {0, -0.7F, 0},    {0.1F, 0, 0.8F},   {0, 0.04F, -0.75F}};
  std::array<MeshVertex, 6> vertices;
  for (std::size_t i = 0; i < 6; ++i) {
    vertices[i].position = {places[i][0], places[i][1], 0.5F * places[i][2], 1};
    vertices[i].normal = {places[i][0], places[i][1], places[i][2]};
    vertices[i].colour = {0.125F, 0.125F, 0.125F, 0.125F};
    vertices[i].tag = static_cast<float>(t.random_int(1, 6));
  }
  const std::size_t faces[8][3] = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                   {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  Mesh mesh;
  for (std::size_t face = 0; face < 8; ++face)
    for (std::size_t k = 0; k < 3; ++k) mesh.push_back(vertices[faces[face][(k + face) % 3]]);
  return mesh;
}

void check_closed(Test& t, GLenum refinement, GLenum interior) {
  gl.UseProgram(build_program(
      t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 1) in vec3 normal;\n"
                    "layout(location = 3) in vec4 vertex_colour; out vec4 colour;\n"
                    "void main() { colour = max(vertex_colour, vec4(1e-9 * normal.z));\n"
                    "  gl_Position = vec4(position.xy + 0.15 * sin(4.0 * position.yx), position.z, 1.0); }\n"}));
  const Mesh mesh = octahedron(t);
  upload(mesh);
  refine_by_tags(6, refinement);
  gl.ARKParameteriARK(GL_PATTERN_INTERIOR_ARK, static_cast<GLint>(interior));
  gl.Enable(GL_CULL_FACE);
  gl.CullFace(GL_BACK);
  const Picture front = additive_picture(mesh);
  gl.CullFace(GL_FRONT);
  const Picture back = additive_picture(mesh);
  t.expect(count_different(front, Picture(surface_size, surface_size), 0) > 2000, "the surface is seen");
  t.expect_same_picture(back, front, "as many back faces as front faces in every pixel", 1);
}

// Triangles on top of each other, in this order: the last one shows.
Mesh stack() {
  Mesh mesh;
  for (int i = 0; i < 4; ++i) {
    Mesh triangle = one_triangle();
    for (MeshVertex& vertex : triangle) {
      vertex.position[0] += 0.125F * static_cast<float>(i);
      vertex.colour = {static_cast<float>(i & 1), static_cast<float>(i >> 1), 0.5F, 1};
    }
    mesh.insert(mesh.end(), triangle.begin(), triangle.end());
  }
  number_triangles(mesh);
  return mesh;
}

void check_coarse_order(Test& t, int level) {
  gl.UseProgram(colour_program(t));
  upload(stack());
  const auto draw = [] { gl.DrawArrays(GL_TRIANGLES, 0, 12); };
  const Picture plain = picture_of(draw);
  refine_uniformly(static_cast<GLuint>(level));
  t.expect_same_picture(picture_of(draw), plain, "overlapping triangles of one command", 1, 20);
  if (level > 6) return;
  gl.UseProgram(capture_program(t));
  float last = 0;
  bool in_order = true;
  for (const CapturedVertex& vertex : capture(t, draw)) {
    in_order = in_order && vertex.triangle >= last;
    last = vertex.triangle;
  }
  t.expect(in_order, "transform feedback has the coarse triangles in order");
}

// Two commands with any refinement: the second one shows.
void check_command_order(Test& t, GLenum source) {
  gl.UseProgram(colour_program(t));
  Mesh mesh = stack();
  for (std::size_t i = 0; i < mesh.size(); ++i) mesh[i].tag = static_cast<float>(i % 4);
  upload(mesh);
  const auto draw = [] {
    for (GLint i = 0; i < 4; ++i) gl.DrawArrays(GL_TRIANGLES, 3 * i, 3);
  };
  const Picture plain = picture_of(draw);
  refine_by_tags(4);
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, static_cast<GLint>(source));
  gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 2);
  t.expect_same_picture(picture_of(draw), plain, "overlapping triangles of four commands", 1, 20);
}

struct Repeat {
  const char* name;
  GLenum refinement;
  GLenum source;
};

// A depth pass, then a colour pass with another fragment stage and an EQUAL test. Together they draw every pixel
// exactly once.
void check_equal_pass(Test& t, const Repeat& repeat) {
  const GLuint depth_only =
      build_program(t, {.vertex = bending_stage,
                        .fragment = "in vec4 colour; out vec4 pixel; void main() { pixel = min(colour, vec4(0.0)); }"});
  const GLuint coloured = build_program(t, {.vertex = bending_stage});
  const Mesh mesh = grid(t, 5, 4);
  upload(mesh);
  refine_by_tags(4, repeat.refinement);
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, static_cast<GLint>(repeat.source));
  gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 2);
  gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, 6);
  const auto draw = [&] { gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(mesh.size())); };
  clear_surface();
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LESS);
  gl.UseProgram(depth_only);
  draw();
  gl.DepthFunc(GL_EQUAL);
  gl.DepthMask(GL_FALSE);
  gl.UseProgram(coloured);
  draw();
  gl.DepthMask(GL_TRUE);
  const Picture two_passes = read_picture(surface_size, surface_size);
  clear_surface();
  gl.DepthFunc(GL_LESS);
  draw();
  const Picture one_pass = read_picture(surface_size, surface_size);
  t.expect(count_different(one_pass, Picture(surface_size, surface_size), 8) > 8000, "the surface is drawn");
  t.expect_same_picture(two_passes, one_pass, "the second pass reaches every pixel", 1);
}

void check_repeated_capture(Test& t, const Repeat& repeat) {
  gl.UseProgram(build_program(t, {.vertex = bending_stage, .captured = {"gl_Position", "colour"}}));
  const Mesh mesh = grid(t, 4, 4);
  upload(mesh);
  refine_by_tags(4, repeat.refinement);
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, static_cast<GLint>(repeat.source));
  gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 2);
  const auto once = [&] {
    auto vertices = capture_as<std::array<float, 8>>(
        t, 60000, [&] { gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(mesh.size())); });
    std::sort(vertices.begin(), vertices.end());
    return vertices;
  };
  const auto first = once();
  gl.Enable(GL_BLEND);
  gl.Enable(GL_DEPTH_TEST);
  t.expect(first.size() > mesh.size(), "the draw is refined");
  t.expect(once() == first, "the same vertices again");
}

}  // namespace

Cases coverage_and_order_cases() {
  Cases cases;
  const Covering coverings[] = {
      {"linear.minimum", GL_LINEAR_INPUTS_ARK, GL_MINIMUM_INTERIOR_ARK, GL_DEPTH_TAG_ARK, false},
      {"linear.smooth", GL_LINEAR_INPUTS_ARK, GL_SMOOTH_INTERIOR_ARK, GL_DEPTH_TAG_ARK, false},
      {"linear.uniform", GL_LINEAR_INPUTS_ARK, GL_MINIMUM_INTERIOR_ARK, GL_UNIFORM_DEPTH_ARK, false},
      {"linear.measured", GL_LINEAR_INPUTS_ARK, GL_MINIMUM_INTERIOR_ARK, GL_MEASURED_DEPTH_ARK, false},
      {"outputs.minimum", GL_LINEAR_OUTPUTS_ARK, GL_MINIMUM_INTERIOR_ARK, GL_DEPTH_TAG_ARK, true},
      {"bent.minimum", GL_LINEAR_INPUTS_ARK, GL_MINIMUM_INTERIOR_ARK, GL_DEPTH_TAG_ARK, true},
      {"bent.smooth", GL_LINEAR_INPUTS_ARK, GL_SMOOTH_INTERIOR_ARK, GL_DEPTH_TAG_ARK, true},
      {"bent.measured", GL_LINEAR_INPUTS_ARK, GL_SMOOTH_INTERIOR_ARK, GL_MEASURED_DEPTH_ARK, true}};
  for (const Covering& covering : coverings)
    cases.push_back({.name = std::string("ark.watertight.plane.") + covering.name,
                     .clauses = {"11.R.5-7", "11.R.8-3", "overview-4"},
                     .plan = "Add up a mesh of random tags that covers the surface: each pixel is drawn exactly once.",
                     .wrong = "Dark pixels along cracks, bright ones where triangles overlap.",
                     .control = control_covering,
                     .check = [covering](Test& t) { check_covering(t, covering); }});
  for (const bool is_curved : {false, true})
    for (const bool is_smooth : {false, true})
      cases.push_back({.name = std::string("ark.watertight.closed.") + (is_curved ? "curved_pn" : "linear") +
                               (is_smooth ? ".smooth" : ".minimum"),
                       .clauses = {"11.R.5-9", "11.R.8-3", "11.R.8-4", "overview-4"},
                       .plan = "Add up the front faces and the back faces of a closed mesh of random tags: the same in "
                               "every pixel.",
                       .wrong = "Pixels along cracks differ.",
                       .check = [is_curved, is_smooth](Test& t) {
                         check_closed(t, is_curved ? GL_CURVED_PN_ARK : GL_LINEAR_INPUTS_ARK,
                                      is_smooth ? GL_SMOOTH_INTERIOR_ARK : GL_MINIMUM_INTERIOR_ARK);
                       }});
  for (const int level : {1, 3, 6, 8})
    cases.push_back(
        {.name = fmt::format("ark.order.coarse.level_{}", level),
         .clauses = {"11.R.12-2"},
         .plan = "Draw four overlapping triangles by one command, without a depth test: the last one shows.",
         .wrong = "Refined triangles of different coarse ones are mixed.",
         .check = [level](Test& t) { check_coarse_order(t, level); }});
  for (const auto& [name, source] : {std::pair<const char*, GLenum>{"tags", GL_DEPTH_TAG_ARK},
                                     {"uniform", GL_UNIFORM_DEPTH_ARK},
                                     {"measured", GL_MEASURED_DEPTH_ARK}})
    cases.push_back({.name = std::string("ark.order.commands.") + name,
                     .clauses = {"11.R.12-1"},
                     .plan = "Draw four overlapping triangles by four commands: the last one shows.",
                     .wrong = "Commands are collected and drawn in another order.",
                     .check = [source = source](Test& t) { check_command_order(t, source); }});
  for (const Repeat& repeat : {Repeat{"linear.tags", GL_LINEAR_INPUTS_ARK, GL_DEPTH_TAG_ARK},
                               Repeat{"linear.uniform", GL_LINEAR_INPUTS_ARK, GL_UNIFORM_DEPTH_ARK},
                               Repeat{"linear.measured", GL_LINEAR_INPUTS_ARK, GL_MEASURED_DEPTH_ARK},
                               Repeat{"outputs.tags", GL_LINEAR_OUTPUTS_ARK, GL_DEPTH_TAG_ARK},
                               Repeat{"curved_pn.tags", GL_CURVED_PN_ARK, GL_DEPTH_TAG_ARK}}) {
    cases.push_back({.name = std::string("ark.repeat.equal_pass.") + repeat.name,
                     .clauses = {"11.R.13-1", "11.R.13-2"},
                     .plan = "Draw depths, then colours with an EQUAL depth test and another fragment stage.",
                     .wrong = "Pixels stay black where the second pass has other vertices.",
                     .check = [repeat](Test& t) { check_equal_pass(t, repeat); }});
    cases.push_back({.name = std::string("ark.repeat.capture.") + repeat.name,
                     .clauses = {"11.R.13-1"},
                     .plan = "Capture one command twice, with other state of later stages.",
                     .wrong = "Other vertices the second time.",
                     .check = [repeat](Test& t) { check_repeated_capture(t, repeat); }});
  }
  return cases;
}

}  // namespace glark::conformance
