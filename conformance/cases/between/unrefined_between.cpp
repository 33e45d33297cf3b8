// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Draws that are not refined, between draws that are, and that repeat: each draws what it would draw alone.
#include <fmt/core.h>

#include <cstddef>

#include "conformance/cases/cases.h"
#include "conformance/cases/repeated/repeated.h"
#include "conformance/support/capture.h"
#include "conformance/support/counted.h"

namespace glark::conformance {
namespace {

constexpr GLsizei left_vertices = 6;    // of the refined draws
constexpr GLsizei first_of_right = 6;   // of the unrefined ones, in the same arrays
constexpr GLsizei right_vertices = 12;  // four triangles, as two patches, or as lines and points

// What is drawn: the refined draw on the left, another refined draw, and the unrefined one on the right.
struct BetweenScene {
  GLuint array = 0;
  GLuint other_array = 0;
  GLuint elements = 0;
  GLuint program = 0;
  GLuint other_program = 0;     // draws in another order of colours
  GLuint geometry_program = 0;  // draws points as they are
};

Mesh mesh_between(float shift) {
  Mesh mesh;
  for (int i = 0; i < 6; ++i)
    for (MeshVertex vertex : one_triangle({1, 2, 1})) {
      vertex.position = {0.3F * vertex.position[0] - 0.6F + 0.55F * static_cast<float>(i % 3) + shift,
                         0.4F * vertex.position[1] + (i < 3 ? -0.5F : 0.45F), 0, 1};
      mesh.push_back(vertex);
    }
  number_triangles(mesh);
  return mesh;
}

GLuint program_between(Test& t, const char* colour) {
  return build_program(
      t, {.vertex = std::string("layout(location = 0) in vec4 position; layout(location = 2) in vec3 weights;\n"
                                "layout(location = 3) in vec4 vertex_colour; out vec4 colour;\n"
                                "void main() { colour = ") +
                    colour + " + vec4(0.0, 0.1 * weights.xy, 0.0); gl_PointSize = 5.0; gl_Position = position; }\n"});
}

BetweenScene make_between(Test& t) {
  BetweenScene scene;
  scene.program = program_between(t, "vertex_colour");
  scene.other_program = program_between(t, "vertex_colour.brga");
  scene.geometry_program = build_program(
      t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 3) in vec4 vertex_colour;\n"
                    "out vec4 tint; void main() { tint = vertex_colour; gl_Position = position; }\n",
          .geometry = "layout(points) in; layout(triangle_strip, max_vertices = 3) out;\n"
                      "in vec4 tint[]; out vec4 colour;\n"
                      "void main() { for (int i = 0; i < 3; ++i) { colour = tint[0];\n"
                      "  gl_Position = gl_in[0].gl_Position + vec4(0.1 * float(i % 2), 0.1 * float(i / 2), 0.0, 0.0);\n"
                      "  EmitVertex(); } EndPrimitive(); }\n"});
  scene.other_array = upload(mesh_between(0.1F)).array;
  scene.array = upload(mesh_between(0)).array;
  gl.UseProgram(scene.program);
  gl.ARKinit(4);
  if (!t.is_gles()) gl.Enable(GL_PROGRAM_POINT_SIZE);
  const GLushort indices[] = {6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17};
  gl.GenBuffers(1, &scene.elements);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, scene.elements);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof(indices), indices, GL_STATIC_DRAW);
  return scene;
}

void draw_left() { gl.DrawArrays(GL_TRIANGLES, 0, left_vertices); }
void draw_right(GLenum mode) { gl.DrawArrays(mode, first_of_right, right_vertices); }

void without_ark(const std::function<void()>& draw) {
  const bool is_enabled = gl.IsEnabled(GL_ARK) == GL_TRUE;
  gl.Disable(GL_ARK);
  draw();
  if (is_enabled) gl.Enable(GL_ARK);
}

void point_colours_at(std::size_t offset) {
  gl.VertexAttribPointer(at_colour, 3, GL_FLOAT, GL_FALSE, sizeof(MeshVertex), reinterpret_cast<const void*>(offset));
}

struct UnrefinedBetween {
  const char* leaf;
  void (*draw)(const BetweenScene& scene);
  Apis apis = every_api;
  bool has_refined = false;  // a refined draw as well
};

template <GLenum mode>
void draw_mode(const BetweenScene&) {
  draw_right(mode);
}

constexpr UnrefinedBetween unrefined_between[] = {
    {"points", draw_mode<GL_POINTS>},
    {"lines", draw_mode<GL_LINES>},
    {"line_strip", draw_mode<GL_LINE_STRIP>},
    {"line_loop", draw_mode<GL_LINE_LOOP>},
    {"lines_adjacency", draw_mode<GL_LINES_ADJACENCY>},
    {"line_strip_adjacency", draw_mode<GL_LINE_STRIP_ADJACENCY>},
    {"triangles_adjacency", draw_mode<GL_TRIANGLES_ADJACENCY>},
    {"points_of_the_refined_vertices", [](const BetweenScene&) { gl.DrawArrays(GL_POINTS, 0, left_vertices); }},
    {"lines_of_the_refined_vertices", [](const BetweenScene&) { gl.DrawArrays(GL_LINES, 0, left_vertices); }},
    {"elements",
     [](const BetweenScene&) { gl.DrawElements(GL_LINE_STRIP, right_vertices, GL_UNSIGNED_SHORT, nullptr); }},
    {"instances", [](const BetweenScene&) { gl.DrawArraysInstanced(GL_LINES, first_of_right, right_vertices, 2); }},
    {"other_array",
     [](const BetweenScene& s) {
       gl.BindVertexArray(s.other_array);
       draw_right(GL_LINES);
       gl.BindVertexArray(s.array);
     }},
    {"other_program",
     [](const BetweenScene& s) {
       gl.UseProgram(s.other_program);
       draw_right(GL_POINTS);
       gl.UseProgram(s.program);
     }},
    {"geometry_of_points",
     [](const BetweenScene& s) {
       gl.UseProgram(s.geometry_program);
       draw_right(GL_POINTS);
       gl.UseProgram(s.program);
     }},
    {"disabled", [](const BetweenScene&) { without_ark([] { draw_right(GL_TRIANGLES); }); }},
    {"disabled_same_draw", [](const BetweenScene&) { without_ark(draw_left); }},
    {"disabled_strip", [](const BetweenScene&) { without_ark([] { draw_right(GL_TRIANGLE_STRIP); }); }},
    {"disabled_elements",
     [](const BetweenScene&) {
       without_ark([] { gl.DrawElements(GL_TRIANGLES, right_vertices, GL_UNSIGNED_SHORT, nullptr); });
     }},
    {"disabled_other_array",
     [](const BetweenScene& s) {
       gl.BindVertexArray(s.other_array);
       without_ark(draw_left);
       gl.BindVertexArray(s.array);
     }},
    {"disabled_other_program",
     [](const BetweenScene& s) {
       gl.UseProgram(s.other_program);
       without_ark([] { draw_right(GL_TRIANGLES); });
       gl.UseProgram(s.program);
     }},
    // What changes while the extension is disabled, and what changes back.
    {"array_changed_meanwhile",
     [](const BetweenScene&) {
       without_ark([] {
         point_colours_at(offsetof(MeshVertex, weights));
         draw_right(GL_TRIANGLES);
       });
       draw_right(GL_TRIANGLES);
       without_ark([] { point_colours_at(offsetof(MeshVertex, colour)); });
     },
     every_api, true},
    {"array_disabled_meanwhile",
     [](const BetweenScene&) {
       without_ark([] {
         gl.DisableVertexAttribArray(at_colour);
         gl.VertexAttrib4f(at_colour, 0.2F, 0.7F, 0.9F, 1);
         draw_right(GL_TRIANGLES);
       });
       draw_right(GL_TRIANGLES);
       without_ark([] { gl.EnableVertexAttribArray(at_colour); });
     },
     every_api, true},
    {"buffer_written_meanwhile",
     [](const BetweenScene&) {
       for (const float red : {0.25F, 1.0F}) {
         without_ark([red] {
           // The colour of the first vertex of the right, which is red.
           gl.BufferSubData(GL_ARRAY_BUFFER, first_of_right * sizeof(MeshVertex) + offsetof(MeshVertex, colour),
                            sizeof(red), &red);
           draw_right(GL_LINES);
         });
         draw_right(GL_TRIANGLES);
       }
     },
     every_api, true},
    {"elements_changed_meanwhile",
     [](const BetweenScene& s) {
       const auto draw_elements = [] { gl.DrawElements(GL_TRIANGLES, right_vertices, GL_UNSIGNED_SHORT, nullptr); };
       for (const GLushort index : {GLushort{15}, GLushort{6}}) {
         without_ark([&] {
           gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, s.elements);
           gl.BufferSubData(GL_ELEMENT_ARRAY_BUFFER, 0, sizeof(index), &index);
           draw_elements();
         });
         draw_elements();
       }
     },
     every_api, true},
    {"program_changed_meanwhile",
     [](const BetweenScene& s) {
       without_ark([&] {
         gl.UseProgram(s.other_program);
         draw_right(GL_TRIANGLES);
       });
       draw_right(GL_TRIANGLES);
       without_ark([&] { gl.UseProgram(s.program); });
     },
     every_api, true},
    {"no_vertices", [](const BetweenScene&) { gl.DrawArrays(GL_TRIANGLES, 0, 0); }},
    {"two_vertices", [](const BetweenScene&) { gl.DrawArrays(GL_TRIANGLES, 0, 2); }},
    {"no_instances", [](const BetweenScene&) { gl.DrawArraysInstanced(GL_TRIANGLES, 0, left_vertices, 0); }},
    {"discarded",
     [](const BetweenScene&) {
       gl.Enable(GL_RASTERIZER_DISCARD);
       draw_right(GL_LINES);
       gl.Disable(GL_RASTERIZER_DISCARD);
     }},
    {"cleared",
     [](const BetweenScene&) {
       gl.Enable(GL_SCISSOR_TEST);
       gl.Scissor(90, 90, 20, 20);
       gl.ClearColor(0.3F, 0.5F, 0.7F, 1);
       gl.Clear(GL_COLOR_BUFFER_BIT);
       gl.Disable(GL_SCISSOR_TEST);
       gl.ClearColor(0, 0, 0, 1);
     }},
    {"begin_lines",
     [](const BetweenScene&) {
       gl.Begin(GL_LINE_STRIP);
       for (GLint i = 0; i < right_vertices; ++i) gl.ArrayElement(first_of_right + i);
       gl.End();
     },
     compat_only},
    {"begin_points_with_tags",
     [](const BetweenScene&) {
       gl.Begin(GL_POINTS);
       for (GLint i = 0; i < right_vertices; ++i) {
         gl.DepthTag1i(static_cast<GLuint>(i) % 3);
         gl.VertexAttrib4f(at_colour, 1, 0.1F * static_cast<float>(i), 0, 1);
         gl.Vertex2f(-0.9F + 0.15F * static_cast<float>(i), 0.9F);
       }
       gl.End();
     },
     compat_only},
    {"rectangle",
     [](const BetweenScene&) {
       gl.VertexAttrib4f(at_colour, 0.2F, 0.6F, 1, 1);
       gl.Rectf(0.8F, 0.8F, 0.95F, 0.95F);
     },
     compat_only},
    {"pixels",
     [](const BetweenScene&) {
       const GLubyte pixel[] = {200, 100, 50, 255};
       gl.RasterPos2f(0.9F, 0.9F);
       gl.DrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
     },
     compat_only},
    {"list_of_lines",
     [](const BetweenScene&) {
       gl.NewList(7, GL_COMPILE);
       draw_right(GL_LINES);
       gl.EndList();
       gl.CallList(7);
     },
     compat_only},
    {"selection",
     [](const BetweenScene&) {
       GLuint names[16] = {};
       gl.SelectBuffer(16, names);
       gl.RenderMode(GL_SELECT);
       gl.InitNames();
       gl.PushName(1);
       draw_left();
       gl.RenderMode(GL_RENDER);
     },
     compat_only},
};

struct BetweenDepth {
  const char* name;
  void (*refine)();
  GLuint triangles;  // the number of triangles of the refined draw; 0: any number, the same each time
};
constexpr BetweenDepth between_depths[] = {
    {"a uniform depth", [] { refine_uniformly(2); }, 2 * 16},
    {"outputs", [] { refine_uniformly(3, GL_LINEAR_OUTPUTS_ARK); }, 2 * 64},
    {"tags", [] { refine_by_tags(3); }, 0},
    {"measured depths",
     [] {
       refine_by_tags(4);
       gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK);
       gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, 6);
     },
     0},
};

void draw_refined_twice(const BetweenScene& scene) {
  draw_left();
  gl.BindVertexArray(scene.other_array);
  gl.UseProgram(scene.other_program);
  draw_right(GL_TRIANGLES);
  gl.BindVertexArray(scene.array);
  gl.UseProgram(scene.program);
}

// Both counts: that of the refined draw, and that of the unrefined one.
struct BetweenCounts {
  GLuint refined = 0;
  GLuint unrefined = 0;
};

BetweenCounts counts_between(const BetweenScene& scene, const UnrefinedBetween& row) {
  BetweenCounts counts;
  counts.refined = count_generated(draw_left);
  counts.unrefined = count_generated([&] { row.draw(scene); });
  return counts;
}

void check_between(Test& t, const UnrefinedBetween& row, const BetweenDepth& depth) {
  const BetweenScene scene = make_between(t);
  const std::string with = fmt::format("{}, {}", row.leaf, depth.name);
  const auto mixed = [&] {
    draw_refined_twice(scene);
    row.draw(scene);
    draw_refined_twice(scene);
    row.draw(scene);
  };
  const auto first_unrefined = [&] {
    row.draw(scene);
    draw_left();
  };
  const Picture plain = picture_of(mixed);
  const Picture plain_first = picture_of(first_unrefined);
  const Picture plain_alone = picture_of([&] { row.draw(scene); });
  const GLuint unrefined = count_generated([&] { row.draw(scene); });
  depth.refine();
  GLuint refined = depth.triangles;
  for (int again = 0; again < 4; ++again) {
    t.expect_same_picture(picture_of(mixed), plain, "both kinds of draws: " + with, 4, 160);
    t.expect_same_picture(picture_of(first_unrefined), plain_first, "the unrefined draw first: " + with, 4, 80);
    t.expect_same_picture(picture_of([&] { row.draw(scene); }), plain_alone, "the unrefined draw: " + with,
                          row.has_refined ? 4 : 0, row.has_refined ? 80 : 0);
    const BetweenCounts counts = counts_between(scene, row);
    if (refined == 0) refined = counts.refined;
    t.expect(counts.refined > 2, "the draw is refined: " + with);
    t.expect_equal(counts.refined, refined, "triangles of the refined draw: " + with);
    if (!row.has_refined) t.expect_equal(counts.unrefined, unrefined, "primitives of the unrefined draw: " + with);
    if (again == 1)
      for (int often = 0; often < 12; ++often) mixed();
  }
  t.expect_no_error("the draws");
}

}  // namespace

Cases unrefined_between_cases() {
  Cases cases;
  for (const UnrefinedBetween& row : unrefined_between)
    cases.push_back({.name = fmt::format("ark.draw.between.unrefined.{}", row.leaf),
                     .clauses = {"10.R.2-1", "10.R.2-3", "chapter-14-8"},
                     .plan =
                         "Repeat refined draws with a draw between them that is not refined: compare the picture of "
                         "all, and the unrefined draw alone; count the primitives of each.",
                     .wrong = "The unrefined draw shows, or counts, what was captured; a refined one shows what the "
                              "unrefined draw left.",
                     .apis = row.apis,
                     .check = [&row](Test& t) {
                       for (const BetweenDepth& depth : between_depths) {
                         const std::unique_ptr<Context> context = t.create_context();
                         check_between(t, row, depth);
                       }
                     }});
  return cases;
}

}  // namespace glark::conformance
