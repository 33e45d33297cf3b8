// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Draws that reach limits: the number of commands is on the GPU, or vertices come from streams and separate buffers of
// transform feedback. Others have more vertices than fit at once, more inputs than usual, or a hundred thousand pieces.
#include <fmt/core.h>
#include <cmath>
#include <cstring>

#include "conformance/cases/cases.h"
#include "conformance/reference/refinement.h"
#include "conformance/support/counted.h"
#include "conformance/support/refined_draw.h"

namespace glark::conformance {
namespace {

using Draw = std::function<void()>;

// Triangles side by side.
Mesh triangles_in_a_row(int count) {
  Mesh mesh;
  for (int i = 0; i < count; ++i)
    for (MeshVertex vertex : one_triangle({1, 1, 1})) {
      const auto n = static_cast<float>(i % 4);
      vertex.position = {0.25F * vertex.position[0] + 0.5F * n - 0.7F, 0.8F * vertex.position[1], 0, 1};
      vertex.colour[2] = 0.25F * n;
      mesh.push_back(vertex);
    }
  number_triangles(mesh);
  return mesh;
}

GLuint bind_words(GLenum target, const std::vector<GLuint>& words) {
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(target, buffer);
  gl.BufferData(target, static_cast<GLsizeiptr>(words.size() * sizeof(GLuint)), words.data(), GL_STATIC_DRAW);
  return buffer;
}

// Draws `triangles` coarse triangles with each depth source. Expects the picture `plain`, and four refined triangles
// for each coarse one.
void expect_drawn(Test& t, const Picture& plain, GLuint triangles, const Draw& draw, const std::string& what) {
  for (const bool is_uniform : {true, false}) {
    is_uniform ? refine_uniformly(1) : refine_by_tags(2);
    for (int again = 0; again < 3; ++again) {
      t.expect_same_picture(picture_of(draw), plain, what, 3, 60);
      t.expect_equal(count_generated(draw), 4 * triangles, what + ": triangles");
    }
    gl.Disable(GL_ARK);
  }
  t.expect_no_error(what);
}

// A buffer says that two of the four records are drawn.
void check_indirect_count(Test& t, bool is_indexed) {
  if (t.version() < 46 && !t.has_extension("GL_ARB_indirect_parameters")) t.not_supported("no counts in a buffer");
  gl.UseProgram(colour_program(t));
  upload(triangles_in_a_row(4));
  bind_words(GL_ELEMENT_ARRAY_BUFFER, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11});
  if (is_indexed)
    bind_words(GL_DRAW_INDIRECT_BUFFER, {3, 1, 6, 0, 0, 3, 1, 3, 0, 0, 3, 1, 0, 0, 0, 3, 1, 9, 0, 0});
  else
    bind_words(GL_DRAW_INDIRECT_BUFFER, {3, 1, 6, 0, 3, 1, 3, 0, 3, 1, 0, 0, 3, 1, 9, 0});
  bind_words(GL_PARAMETER_BUFFER, {9, 2});
  const bool is_core = t.version() >= 46;
  const auto draw_arrays = is_core ? gl.MultiDrawArraysIndirectCount : gl.MultiDrawArraysIndirectCountARB;
  const auto draw_elements = is_core ? gl.MultiDrawElementsIndirectCount : gl.MultiDrawElementsIndirectCountARB;
  const Draw draw = [is_indexed, draw_arrays, draw_elements] {
    if (is_indexed)
      draw_elements(GL_TRIANGLES, GL_UNSIGNED_INT, nullptr, 4, 4, 0);
    else
      draw_arrays(GL_TRIANGLES, nullptr, 4, 4, 0);
  };
  const Picture plain = picture_of(draw);
  t.expect_equal(count_generated(draw), 2U, "triangles of the unrefined draw");
  expect_drawn(t, plain, 2, draw, "two of four records");
}

struct Feedback {
  GLuint object = 0;
  GLuint buffers[2] = {0, 0};
};

Feedback begin_feedback(const GLsizeiptr (&bytes)[2]) {
  Feedback feedback;
  gl.GenTransformFeedbacks(1, &feedback.object);
  gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, feedback.object);
  gl.GenBuffers(2, feedback.buffers);
  for (GLuint i = 0; i < 2; ++i) {
    gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, i, feedback.buffers[i]);
    gl.BufferData(GL_TRANSFORM_FEEDBACK_BUFFER, bytes[i], nullptr, GL_STATIC_DRAW);
  }
  gl.Enable(GL_RASTERIZER_DISCARD);
  gl.BeginTransformFeedback(GL_POINTS);
  return feedback;
}

void end_feedback() {
  gl.EndTransformFeedback();
  gl.Disable(GL_RASTERIZER_DISCARD);
  gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, 0);
}

// A vertex array over the captured buffer, with a tag of 1 for each vertex and one colour.
void read_from(GLuint buffer, std::size_t vertices) {
  GLuint array = 0;
  gl.GenVertexArrays(1, &array);
  gl.BindVertexArray(array);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.VertexAttribPointer(at_position, 4, GL_FLOAT, GL_FALSE, 0, nullptr);
  gl.EnableVertexAttribArray(at_position);
  bind_words(GL_ARRAY_BUFFER, std::vector<GLuint>(vertices, 1));
  gl.DepthTagPointerARK(GL_UNSIGNED_INT, 0, nullptr);
  gl.Enable(GL_DEPTH_TAG_ARRAY_ARK);
  gl.VertexAttrib4f(at_colour, 1, 0.5F, 0.25F, 1);
}

// Stream 0 has every vertex. Stream 1 has every vertex twice, at another place.
void check_stream(Test& t) {
  const GLuint program = build_program(
      t, {.vertex = "layout(location = 0) in vec4 position; void main() { gl_Position = position; }\n",
          .fragment = "out vec4 pixel; void main() { pixel = vec4(1.0); }",
          .geometry = "layout(points) in; layout(points, max_vertices = 3) out;\n"
                      "layout(stream = 0) out vec4 first; layout(stream = 1) out vec4 second;\n"
                      "void main() { vec4 p = gl_in[0].gl_Position;\n"
                      "  first = p; EmitStreamVertex(0); EndStreamPrimitive(0);\n"
                      "  second = vec4(p.x, -p.y, p.zw); EmitStreamVertex(1); EndStreamPrimitive(1);\n"
                      "  second = vec4(0.5 * p.xy, p.zw); EmitStreamVertex(1); EndStreamPrimitive(1); }\n",
          .captured = {"first", "gl_NextBuffer", "second"}});
  gl.UseProgram(program);
  upload(triangles_in_a_row(3));
  const Feedback feedback = begin_feedback({9 * sizeof(Vec4), 18 * sizeof(Vec4)});
  gl.DrawArrays(GL_POINTS, 0, 9);
  end_feedback();
  gl.UseProgram(colour_program(t));
  const auto draw = [&feedback] { gl.DrawTransformFeedbackStream(GL_TRIANGLES, feedback.object, 1); };
  read_from(feedback.buffers[1], 18);
  const Picture plain = picture_of(draw);
  t.expect_equal(count_generated(draw), 6U, "unrefined triangles of stream 1");
  expect_drawn(t, plain, 6, draw, "triangles of stream 1");
}

// The buffers have just enough room.
void check_separate(Test& t) {
  const GLuint program = build_program(
      t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 3) in vec4 vertex_colour;\n"
                    "out vec4 place; out vec4 colour;\n"
                    "void main() { place = position; colour = vertex_colour; gl_Position = position; }\n"});
  const char* const names[] = {"place", "colour"};
  gl.TransformFeedbackVaryings(program, 2, names, GL_SEPARATE_ATTRIBS);
  gl.LinkProgram(program);
  gl.UseProgram(program);
  upload(triangles_in_a_row(4));
  const Feedback feedback = begin_feedback({12 * sizeof(Vec4), 12 * sizeof(Vec4)});
  gl.DrawArrays(GL_POINTS, 0, 12);
  end_feedback();
  gl.UseProgram(colour_program(t));
  const auto draw = [&feedback] { gl.DrawTransformFeedback(GL_TRIANGLES, feedback.object); };
  read_from(feedback.buffers[0], 12);
  const Picture plain = picture_of(draw);
  t.expect_equal(count_generated(draw), 4U, "unrefined triangles");
  expect_drawn(t, plain, 4, draw, "triangles of one of two buffers");
}

struct ManyPrimitives {
  const char* leaf;
  GLenum mode;
  int primitives;
  GLuint textures;  // units whose coordinates each vertex has
};
// As many triangles are captured at once as fit a buffer. With vertices of some sizes, their number is odd.
constexpr ManyPrimitives many_primitives[] = {{"triangles", GL_TRIANGLES, 130000, 4},
                                              {"quads", GL_QUADS, 70000, 4},
                                              {"quads_6_textures", GL_QUADS, 50000, 6},
                                              {"quads_8_textures", GL_QUADS, 40000, 8}};

// Many vertices with several texture coordinates, more than any implementation captures at once.
void check_many_immediate(Test& t, const ManyPrimitives& many) {
  const GLenum mode = many.mode;
  const int sides = mode == GL_QUADS ? 4 : 3;
  const int primitives = many.primitives;
  for (GLenum texture = 0; texture < many.textures; ++texture) {
    gl.ActiveTexture(GL_TEXTURE0 + texture);
    gl.Enable(GL_TEXTURE_2D);
  }
  gl.Enable(GL_RASTERIZER_DISCARD);
  refine_uniformly(1);
  const auto draw = [&] {
    gl.Begin(mode);
    for (int i = 0; i < sides * primitives; ++i)
      gl.Vertex2f(static_cast<float>(i % 100) / 100, static_cast<float>(i % 73) / 100);
    gl.End();
  };
  t.expect_equal(count_generated(draw), static_cast<GLuint>(4 * (sides - 2) * primitives),
                 "triangles of one Begin and End");
  t.expect_no_error("Begin and End");
}

constexpr std::size_t many = 10;
constexpr GLuint many_locations[many] = {1, 3, 4, 5, 7, 8, 9, 10, 11, 12};

struct ManyVertex {
  Vec4 values[many];
  Vec3 weights;
  float triangle;
};

GLuint many_program(Test& t) {
  std::string declarations =
      "layout(location = 0) in vec4 position; layout(location = 2) in vec3 weights;\n"
      "layout(location = 6) in float triangle; out vec3 weights_out; out float triangle_out;\n";
  std::string body = "gl_Position = position; weights_out = weights; triangle_out = triangle;\n";
  static const char* const outputs[] = {"o0", "o1", "o2", "o3", "o4",          "o5",
                                        "o6", "o7", "o8", "o9", "weights_out", "triangle_out"};
  for (std::size_t i = 0; i < many; ++i) {
    const std::string n = std::to_string(i);
    declarations += fmt::format("layout(location = {}) in vec4 i{}; out vec4 o{};\n", many_locations[i], n, n);
    body += "o" + n + " = i" + n + ";\n";
  }
  return build_program(t, {.vertex = declarations + "void main() { " + body + "}\n",
                           .fragment = "out vec4 pixel; void main() { pixel = vec4(1.0); }",
                           .captured = {std::begin(outputs), std::end(outputs)}});
}

float many_value(std::size_t vertex, std::size_t input, std::size_t component, std::size_t round) {
  return 0.1F * static_cast<float>((7 * vertex + 13 * input + 3 * component + 29 * round) % 31) - 1;
}

// Each coarse triangle has the pattern of its own tags.
void expect_counts(Test& t, const Mesh& mesh, const std::vector<ManyVertex>& vertices, bool is_uniform) {
  std::vector<std::int64_t> found(mesh.size() / 3);
  for (const ManyVertex& vertex : vertices) ++found[static_cast<std::size_t>(std::lround(vertex.triangle))];
  for (std::size_t i = 0; i < found.size(); ++i) {
    std::array<int, 3> tags{};
    for (std::size_t k = 0; k < 3; ++k) tags[k] = is_uniform ? 2 : static_cast<int>(mesh[3 * i + k].tag);
    t.expect_equal(found[i], 3 * reference::minimum_triangles(reference::edge_depths(tags)),
                   "vertices of triangle " + as_text(i));
  }
}

// Draws of one program with other vertices each time. Compares each input by bits.
void check_many_inputs(Test& t, bool is_uniform) {
  const GLuint program = many_program(t);
  gl.UseProgram(program);
  is_uniform ? refine_uniformly(2) : refine_by_tags(3);
  GLint status = GL_FALSE;
  gl.GetRefinementivARK(program, GL_REFINEMENT_STATUS_ARK, &status);
  if (status == GL_FALSE) t.not_supported("a limit of the implementation");
  for (std::size_t round = 0; round < 3; ++round) {
    Mesh mesh = triangles_in_a_row(4);
    for (std::size_t i = 0; i < mesh.size(); ++i) mesh[i].tag = static_cast<float>((i * i + round) % 4);
    upload(mesh);
    GLuint buffer = 0;
    gl.GenBuffers(1, &buffer);
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
    std::vector<float> data;
    for (std::size_t v = 0; v < mesh.size(); ++v)
      for (std::size_t i = 0; i < many; ++i)
        for (std::size_t k = 0; k < 4; ++k) data.push_back(many_value(v, i, k, round));
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(4 * data.size()), data.data(), GL_STATIC_DRAW);
    for (std::size_t i = 0; i < many; ++i) {
      gl.VertexAttribPointer(many_locations[i], 4, GL_FLOAT, GL_FALSE, many * sizeof(Vec4),
                             reinterpret_cast<const void*>(i * sizeof(Vec4)));
      gl.EnableVertexAttribArray(many_locations[i]);
    }
    const auto vertices = capture_as<ManyVertex>(t, 2000, [] { gl.DrawArrays(GL_TRIANGLES, 0, 12); });
    expect_counts(t, mesh, vertices, is_uniform);
    for (const ManyVertex& vertex : vertices) {
      const auto first = 3 * static_cast<std::size_t>(std::lround(vertex.triangle));
      for (std::size_t i = 0; i < many; ++i)
        for (std::size_t k = 0; k < 4; ++k) {
          const float expected =
              reference::refined(vertex.weights, many_value(first, i, k, round), many_value(first + 1, i, k, round),
                                 many_value(first + 2, i, k, round));
          if (!t.expect_equal(vertex.values[i][k], expected,
                              "input " + as_text(i) + " of triangle " + as_text(vertex.triangle)))
            return;
        }
    }
  }
}

// Edges of 15, 30.1 and 34.9 pixels, or with normals 120, 170 and 70 degrees apart, in every order.
void check_measured(Test& t, int count, bool by_degrees) {
  const float places[3][2] = {{10, 10}, {25, 10}, {28, 40}};
  const double angles[3] = {0, 120, -70};
  Mesh mesh;
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < 3; ++k) {
      const int corner = (k + i) % 3;
      MeshVertex vertex;
      vertex.position = {places[corner][0] / 64 - 1, places[corner][1] / 64 - 1, 0, 1};
      const double angle = angles[corner] * std::acos(-1.0) / 180;
      vertex.normal = {static_cast<float>(std::sin(angle)), 0, static_cast<float>(std::cos(angle))};
      mesh.push_back(vertex);
    }
  number_triangles(mesh);
  gl.UseProgram(capture_program(t));
  if (by_degrees)
    gl.UseProgram(build_program(
        t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 1) in vec3 normal;\n"
                      "layout(location = 2) in vec3 weights; layout(location = 6) in float triangle;\n"
                      "out vec3 weights_out; out float triangle_out; out vec4 colour;\n"
                      "void main() { gl_Position = position; weights_out = weights; triangle_out = triangle;\n"
                      "  colour = vec4(normal, 1.0); }\n",
            .captured = {"gl_Position", "weights_out", "triangle_out"}}));
  upload(mesh);
  refine_by_tags(6);
  gl.Viewport(0, 0, surface_size, surface_size);
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK);
  gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, by_degrees ? 0 : 4);
  gl.ARKParameteriARK(GL_EDGE_DEGREES_ARK, by_degrees ? 10 : 0);
  const reference::Depths of_corner = by_degrees ? reference::Depths{4, 5, 3} : reference::Depths{2, 3, 4};
  const auto found = depths_of(t, static_cast<std::size_t>(count),
                               [&mesh] { gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(mesh.size())); });
  for (std::size_t i = 0; i < found.size(); ++i) {
    const reference::Depths expected = {of_corner[i % 3], of_corner[(i + 1) % 3], of_corner[(i + 2) % 3]};
    if (!t.expect_equal(text_of(found[i]), text_of(expected), "the depths of triangle " + as_text(i))) return;
  }
}

// Each pixel inside has one refined triangle, at a level with more than a million triangles.
void check_covered_once(Test& t, int level) {
  gl.UseProgram(colour_program(t));
  Mesh mesh = one_triangle();
  for (MeshVertex& vertex : mesh) vertex.colour = {0.25F, 0.25F, 0.25F, 1};
  upload(mesh, false);
  const Picture plain = picture_of([] { gl.DrawArrays(GL_TRIANGLES, 0, 3); });
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE);
  refine_uniformly(static_cast<GLuint>(level));
  t.expect_same_picture(picture_of([] { gl.DrawArrays(GL_TRIANGLES, 0, 3); }), plain,
                        "level " + as_text(level) + ": every pixel once", 2, 40);
}

constexpr Area draw_case{"ark.draw.particular."};

}  // namespace

Cases draw_limits_cases() {
  Cases cases;
  for (const bool is_indexed : {false, true}) {
    cases.push_back(draw_case(
        std::string("indirect_count.") + (is_indexed ? "elements" : "arrays"), {"10.R.2-2"},
        "A buffer says that two of four records are to be drawn.",
        "All four records count, though two of them have no vertices.",
        [is_indexed](Test& t) { check_indirect_count(t, is_indexed); }, desktop_apis));
    cases.back().is_optional = true;  // ARB_indirect_parameters
  }
  cases.push_back(draw_case("feedback_stream", {"10.R.2-2"}, "Draw what stream 1 of a geometry shader captured.",
                            "As many vertices as stream 0 has.", check_stream, desktop_apis));
  cases.push_back(
      draw_case("separate_feedback", {"10.R.2-2"}, "Capture to two buffers, and draw from the one that is full.",
                "As many vertices as would fit if the outputs were interleaved.", check_separate, desktop_apis));
  for (const ManyPrimitives& many : many_primitives)
    cases.push_back(draw_case(
        std::string("begin_end.") + many.leaf, {"10.R.2-2", "11.R.3-5"},
        "Count about a hundred thousand triangles between one Begin and End, with vertices of several sizes.",
        "Triangles beyond the implementation's buffer are lost, or one at each seam; a seam divides a quad.",
        [&many](Test& t) { check_many_immediate(t, many); }, compat_only));
  for (const bool is_uniform : {true, false}) {
    cases.push_back(draw_case(std::string("many_inputs.") + (is_uniform ? "uniform" : "tags"), {"11.R.6-4", "11.R.6-2"},
                              "Twelve inputs and other vertices from draw to draw: compare by bits.",
                              "The inputs of the first draw, or of another triangle.",
                              [is_uniform](Test& t) { check_many_inputs(t, is_uniform); }));
    cases.back().is_optional = true;  // as many inputs as that
  }
  for (const int count : {6, 200})
    for (const bool by_degrees : {false, true})
      cases.push_back(draw_case(
          fmt::format("{}{}", by_degrees ? "degrees." : "pixels.", count),
          {by_degrees ? "11.R.4-8" : "11.R.4-4", "11.R.4-27"},
          "Edges of three depths in every order, with angles of more than 90 degrees, in small and large draws.",
          "One edge has the depth of another; an angle counts as the angle to the opposite normal.",
          [count, by_degrees](Test& t) { check_measured(t, count, by_degrees); }));
  for (const int level : {9, 10})
    cases.push_back(draw_case(fmt::format("covered_once.level_{}", level), {"11.R.5-7", "11.R.5-8", "11.R.5-11"},
                              "Add up the colours of all refined triangles of a deep level.",
                              "Parts are covered twice, or by triangles of another level.",
                              [level](Test& t) { check_covered_once(t, level); }));
  return cases;
}

}  // namespace glark::conformance
