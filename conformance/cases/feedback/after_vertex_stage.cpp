// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The stages after the vertex stage of a refined draw: geometry shaders, transform feedback, queries.
#include <fmt/core.h>
#include <set>

#include "conformance/cases/cases.h"
#include "conformance/support/surface.h"

namespace glark::conformance {
namespace {

void draw_two() { gl.DrawArrays(GL_TRIANGLES, 0, 6); }

GLuint counted(GLenum query_target, const std::function<void()>& draw) {
  GLuint query = 0;
  gl.GenQueries(1, &query);
  gl.BeginQuery(query_target, query);
  draw();
  gl.EndQuery(query_target);
  GLuint result = 0;
  gl.GetQueryObjectuiv(query, GL_QUERY_RESULT, &result);
  gl.DeleteQueries(1, &query);
  return result;
}

const char pass_through[] =
    "layout(triangles) in; layout(triangle_strip, max_vertices = 3) out;\n"
    "in vec4 between[]; out vec4 colour; flat out int primitive;\n"
    "void main() { for (int i = 0; i < 3; ++i) { gl_Position = gl_in[i].gl_Position; colour = between[i];\n"
    "  primitive = gl_PrimitiveIDIn; EmitVertex(); } EndPrimitive(); }\n";

const char between_shader[] =
    "layout(location = 0) in vec4 position; layout(location = 3) in vec4 vertex_colour; out vec4 between;\n"
    "void main() { between = vertex_colour; gl_Position = position; }\n";

struct GeometryVertex {
  Vec4 position;
  GLint primitive;
};

void check_geometry(Test& t) {
  gl.UseProgram(
      build_program(t, {.vertex = between_shader, .geometry = pass_through, .captured = {"gl_Position", "primitive"}}));
  upload(bent_mesh());
  refine_uniformly(3);
  const auto vertices = capture_as<GeometryVertex>(t, 2000, draw_two);
  t.expect_equal(vertices.size(), 2U * 64 * 3, "the geometry shader is executed once for each refined triangle");
  std::set<GLint> numbers;
  for (const GeometryVertex& vertex : vertices) numbers.insert(vertex.primitive);
  // The text leaves the number of a triangle open, but two triangles of one coarse triangle cannot have the same
  // number.
  t.expect(numbers.size() >= 64, fmt::format("gl_PrimitiveIDIn numbers refined triangles, {} numbers", numbers.size()));
  t.expect(!numbers.empty() && *numbers.begin() >= 0 && *numbers.rbegin() < 128,
           "below the number of refined triangles");
}

// A geometry shader that emits a point for each triangle.
void check_geometry_points(Test& t) {
  gl.UseProgram(build_program(t, {.vertex = between_shader,
                                  .geometry = "layout(triangles) in; layout(points, max_vertices = 1) out;\n"
                                              "in vec4 between[]; out vec4 colour; flat out int primitive;\n"
                                              "void main() { gl_Position = gl_in[0].gl_Position; colour = between[0];\n"
                                              "  primitive = gl_PrimitiveIDIn; EmitVertex(); EndPrimitive(); }\n",
                                  .captured = {"gl_Position", "primitive"}}));
  upload(bent_mesh());
  refine_uniformly(2);
  t.expect_equal(capture_as<GeometryVertex>(t, 2000, draw_two, GL_POINTS).size(), 32U,
                 "a point for each refined triangle");
}

void check_geometry_picture(Test& t) {
  const Mesh mesh = one_triangle();
  gl.UseProgram(build_program(t, {.vertex = between_shader, .geometry = pass_through}));
  upload(mesh);
  clear_surface();
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  const Picture expected = read_picture(surface_size, surface_size);
  refine_uniformly(3);
  clear_surface();
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  // A pixel centre within rounding of an edge may fall to either side.
  t.expect_same_picture(read_picture(surface_size, surface_size), expected, "through a geometry shader", 2, 12);
}

void check_primitive_id(Test& t) {
  gl.UseProgram(build_program(
      t, {.vertex = plain_vertex_shader,
          .fragment = "in vec4 colour; out vec4 pixel;\n"
                      "void main() { pixel = vec4(float(gl_PrimitiveID) / 255.0, colour.r * 0.0, 0.0, 1.0); }\n"}));
  upload(one_triangle());
  refine_uniformly(2);
  clear_surface();
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  const Picture picture = read_picture(surface_size, surface_size);
  std::set<int> numbers;
  for (int y = 0; y < surface_size; ++y)
    for (int x = 0; x < surface_size; ++x) numbers.insert(picture.at(x, y)[0]);
  t.expect_equal(numbers.size(), 16U, "the triangle numbers that fragments read");
  t.expect(*numbers.rbegin() == 15, "from 0 to 15");
}

void check_queries(Test& t) {
  gl.UseProgram(capture_program(t));
  upload(bent_mesh());
  refine_uniformly(3);
  const auto with_feedback = [&](const std::function<void()>& draw) {
    GLuint buffer = 0;
    gl.GenBuffers(1, &buffer);
    gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
    // The buffer has room for 100 of the 128 triangles.
    gl.BufferData(GL_TRANSFORM_FEEDBACK_BUFFER, 100 * 3 * sizeof(CapturedVertex), nullptr, GL_STREAM_READ);
    gl.BeginTransformFeedback(GL_TRIANGLES);
    draw();
    gl.EndTransformFeedback();
    gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
  };
  t.expect_equal(counted(GL_PRIMITIVES_GENERATED, draw_two), 128U, "primitives generated without transform feedback");
  if (t.is_gles()) {
    t.expect_equal(counted(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, [&] { draw_two(); }), 0U,
                   "nothing is written without transform feedback");
    return;
  }
  t.expect_equal(counted(GL_PRIMITIVES_GENERATED, [&] { with_feedback(draw_two); }), 128U, "primitives generated");
  t.expect_equal(counted(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, [&] { with_feedback(draw_two); }), 100U,
                 "primitives written if the buffer has room for 100");
}

void check_first_draw_in_query(Test& t) {
  gl.UseProgram(capture_program(t));
  upload(bent_mesh());
  refine_uniformly(1, GL_CURVED_PN_ARK);
  gl.ARKParameteriARK(GL_WELD_ARK, GL_TRUE);
  // Anything that is built or measured for the first time is built within the query.
  t.expect_equal(counted(GL_PRIMITIVES_GENERATED, draw_two), 8U, "primitives of a first draw");
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_DEPTH_TAG_ARK);
  t.expect_equal(counted(GL_PRIMITIVES_GENERATED, draw_two), 2U, "primitives of a draw with tags of 0");
}

void check_occlusion(Test& t) {
  gl.UseProgram(colour_program(t));
  Mesh mesh = one_triangle({4, 2, 3});
  upload(mesh);
  const GLenum target = t.is_gles() ? GL_ANY_SAMPLES_PASSED : GL_SAMPLES_PASSED;
  const auto draw = [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); };
  clear_surface();
  const GLuint expected = counted(target, draw);
  refine_by_tags(4);
  const GLuint actual = counted(target, draw);
  t.expect(expected > 0, "the triangle is drawn");
  t.expect(std::abs(static_cast<int>(actual) - static_cast<int>(expected)) <= 12,
           fmt::format("samples passed: {}, unrefined {}", actual, expected));
}

// Several draws into one transform feedback, paused and resumed in between.
void check_feedback_draws(Test& t) {
  gl.UseProgram(capture_program(t));
  upload(bent_mesh());
  refine_uniformly(1);
  const auto draw_three = [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); };
  const auto vertices = capture(t, [&] {
    draw_three();
    gl.PauseTransformFeedback();
    gl.DrawArrays(GL_TRIANGLES, 3, 3);
    gl.ResumeTransformFeedback();
    gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 0);
    draw_three();
  });
  t.require(vertices.size() == 12U + 3, fmt::format("four triangles, none while paused, one: {}", vertices.size()));
  for (const CapturedVertex& vertex : vertices) t.expect_equal(vertex.triangle, 0.0F, "the triangle of both draws");
}

// The whole transform feedback has no refined draw.
void check_feedback_unrefined(Test& t) {
  gl.UseProgram(capture_program(t));
  upload(bent_mesh());
  refine_uniformly(1);
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  gl.Disable(GL_ARK);
  for (int again = 0; again < 2; ++again) {
    const auto vertices = capture(t, [&] {
      gl.DrawArrays(GL_TRIANGLES, 3, 3);
      gl.PauseTransformFeedback();
      gl.DrawArrays(GL_TRIANGLES, 0, 3);
      gl.ResumeTransformFeedback();
      gl.DrawArrays(GL_TRIANGLES, 3, 3);
    });
    t.require(vertices.size() == 6, fmt::format("two triangles, none while paused: {} vertices", vertices.size()));
    for (const CapturedVertex& vertex : vertices) t.expect_equal(vertex.triangle, 1.0F, "the triangle of both draws");
  }
}

void check_feedback_disabled(Test& t) {
  gl.UseProgram(capture_program(t));
  upload(bent_mesh());
  refine_uniformly(1);
  const auto vertices = capture(t, [&] {
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    gl.Disable(GL_ARK);
    gl.DrawArrays(GL_TRIANGLES, 3, 3);
  });
  t.require(vertices.size() == 12U + 3, "four triangles, and one of the draw that is not refined");
}

void check_feedback_order(Test& t) {
  gl.UseProgram(capture_program(t));
  Mesh mesh(60);
  for (std::size_t i = 0; i < mesh.size(); ++i)
    mesh[i].position = {t.random_float(-1, 1), t.random_float(-1, 1), t.random_float(-1, 1), 1};
  number_triangles(mesh);
  upload(mesh);
  refine_uniformly(3);
  const auto vertices = capture(t, [] { gl.DrawArrays(GL_TRIANGLES, 0, 60); });
  t.require(vertices.size() == 20U * 64 * 3, "all triangles are refined");
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (const std::size_t coarse = i / 192;
        !t.expect_equal(vertices[i].triangle, static_cast<float>(coarse), "coarse triangles keep their order"))
      return;
}

void check_feedback_separate(Test& t) {
  std::string log;
  const GLuint program = capture_program(t);
  const char* const names[] = {"gl_Position", "weights_out"};
  gl.TransformFeedbackVaryings(program, 2, names, GL_SEPARATE_ATTRIBS);
  gl.LinkProgram(program);
  gl.UseProgram(program);
  upload(one_triangle());
  refine_uniformly(2);
  GLuint buffers[2];
  gl.GenBuffers(2, buffers);
  for (GLuint i = 0; i < 2; ++i) {
    gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, i, buffers[i]);
    gl.BufferData(GL_TRANSFORM_FEEDBACK_BUFFER, 4096, nullptr, GL_STREAM_READ);
  }
  gl.BeginTransformFeedback(GL_TRIANGLES);
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  gl.EndTransformFeedback();
  std::vector<Vec4> positions(48);
  std::vector<Vec3> weights(48);
  gl.BindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, buffers[0]);
  std::memcpy(positions.data(), gl.MapBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 48 * 16, GL_MAP_READ_BIT), 48 * 16);
  gl.UnmapBuffer(GL_TRANSFORM_FEEDBACK_BUFFER);
  gl.BindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, buffers[1]);
  std::memcpy(weights.data(), gl.MapBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 48 * 12, GL_MAP_READ_BIT), 48 * 12);
  gl.UnmapBuffer(GL_TRANSFORM_FEEDBACK_BUFFER);
  const Mesh mesh = one_triangle();
  for (std::size_t i = 0; i < 48; ++i)
    for (std::size_t k = 0; k < 4; ++k)
      t.expect_near(positions[i][k],
                    reference::refined(weights[i], mesh[0].position[k], mesh[1].position[k], mesh[2].position[k]),
                    t.is_gles() ? 1e-6 : 0, "both buffers belong to the same vertices");
}

void check_feedback_mode(Test& t) {
  gl.UseProgram(capture_program(t));
  upload(bent_mesh());
  refine_uniformly(2);
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
  gl.BufferData(GL_TRANSFORM_FEEDBACK_BUFFER, 100000, nullptr, GL_STREAM_READ);
  gl.BeginTransformFeedback(GL_LINES);
  draw_two();
  t.expect_error(GL_INVALID_OPERATION, "triangles into transform feedback of lines");
  gl.EndTransformFeedback();
  gl.BeginTransformFeedback(GL_TRIANGLES);
  for (const char* const when : {"first", "after refined triangles"}) {
    for (const GLenum mode : {GL_POINTS, GL_LINES, GL_LINE_LOOP, GL_LINE_STRIP}) {
      gl.DrawArrays(mode, 0, 4);
      t.expect_error(GL_INVALID_OPERATION, "mode " + as_text(mode) + " into transform feedback of triangles, " + when);
    }
    draw_two();
    t.expect_no_error("triangles into transform feedback of triangles");
  }
  gl.EndTransformFeedback();
}

// What GL refuses while feedback is active and not paused, it refuses between refined draws as well.
void check_feedback_errors(Test& t) {
  const GLuint program = capture_program(t);
  const GLuint other = capture_program(t);
  gl.UseProgram(program);
  upload(bent_mesh());
  refine_uniformly(2);
  std::array<GLuint, 2> objects{};
  gl.GenTransformFeedbacks(2, objects.data());
  for (const GLuint object : objects) gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, object);
  gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, objects[0]);
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
  gl.BufferData(GL_TRANSFORM_FEEDBACK_BUFFER, 100000, nullptr, GL_STREAM_READ);
  GLuint query = 0;
  gl.GenQueries(1, &query);
  gl.BeginQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, query);
  gl.BeginTransformFeedback(GL_TRIANGLES);
  const auto integer = [](GLenum name) {
    GLint value = -1;
    gl.GetIntegerv(name, &value);
    return static_cast<GLuint>(value);
  };
  for (const char* const when : {"before the first draw", "after a refined draw"}) {
    gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, objects[1]);
    t.expect_error(GL_INVALID_OPERATION, std::string("BindTransformFeedback ") + when);
    t.expect_equal(integer(GL_TRANSFORM_FEEDBACK_BINDING), objects[0], "the feedback that is bound");
    gl.UseProgram(other);
    t.expect_error(GL_INVALID_OPERATION, std::string("UseProgram ") + when);
    t.expect_equal(integer(GL_CURRENT_PROGRAM), program, "the program in use");
    gl.LinkProgram(program);
    t.expect_error(GL_INVALID_OPERATION, std::string("LinkProgram ") + when);
    gl.BindProgramPipeline(0);
    t.expect_error(GL_INVALID_OPERATION, std::string("BindProgramPipeline ") + when);
    gl.BeginTransformFeedback(GL_TRIANGLES);
    t.expect_error(GL_INVALID_OPERATION, std::string("BeginTransformFeedback ") + when);
    t.expect_equal(integer(GL_TRANSFORM_FEEDBACK_PAUSED), 0U, "the feedback is not paused");
    draw_two();
    t.expect_no_error("a refined draw");
  }
  gl.PauseTransformFeedback();
  t.expect_equal(integer(GL_TRANSFORM_FEEDBACK_PAUSED), 1U, "the feedback is paused");
  gl.UseProgram(other);
  gl.UseProgram(program);
  t.expect_no_error("UseProgram while the feedback is paused");
  gl.LinkProgram(program);
  t.expect_error(GL_INVALID_OPERATION, "LinkProgram while the feedback is paused");
  gl.ResumeTransformFeedback();
  draw_two();
  gl.EndTransformFeedback();
  gl.EndQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);
  GLuint written = 0;
  gl.GetQueryObjectuiv(query, GL_QUERY_RESULT, &written);
  t.expect_equal(written, 3U * 32U, "captured triangles");
  gl.LinkProgram(program);
  gl.UseProgram(other);
  t.expect_no_error("LinkProgram and UseProgram after the feedback");
}

// A geometry shader makes a line, or a point, of each refined triangle.
void check_other_feedback(Test& t, GLenum mode) {
  const bool has_lines = mode == GL_LINES;
  gl.UseProgram(build_program(
      t, {.vertex = "layout(location = 0) in vec4 position; out vec4 colour;\n"
                    "void main() { colour = vec4(1.0); gl_Position = position; }\n",
          .fragment = "out vec4 pixel; void main() { pixel = vec4(1.0); }\n",
          .geometry = std::string("layout(triangles) in; layout(") + (has_lines ? "line_strip" : "points") +
                      ", max_vertices = 2) out; in vec4 colour[]; out vec4 captured;\n"
                      "void main() { for (int i = 0; i < " +
                      (has_lines ? "2" : "1") +
                      "; ++i) {\n"
                      "  captured = colour[i]; gl_Position = gl_in[i].gl_Position; EmitVertex(); } }\n",
          .captured = {"captured"}}));
  upload(one_triangle({2, 2, 2}), false);
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
  gl.BufferData(GL_TRANSFORM_FEEDBACK_BUFFER, 100000, nullptr, GL_STREAM_READ);
  refine_uniformly(2);
  for (int again = 0; again < 3; ++again) {
    const GLuint written = counted(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, [&] {
      gl.BeginTransformFeedback(mode);
      gl.DrawArrays(GL_TRIANGLES, 0, 3);
      gl.EndTransformFeedback();
    });
    t.expect_equal(written, 16U, "primitives that a geometry shader makes of refined triangles");
  }
  t.expect_no_error("the draws");
}

constexpr Area after_case{"ark.after_vertex."};

}  // namespace

Cases after_vertex_stage_cases() {
  return {
      after_case("geometry.count", {"chapter-14-1", "chapter-14-2", "chapter-14-3"},
                 "A geometry shader passes triangles and gl_PrimitiveIDIn on: 128 triangles, numbered.",
                 "The shader gets coarse triangles, or their numbers.", check_geometry),
      after_case("geometry.points", {"chapter-14-1", "chapter-14-2"},
                 "A geometry shader makes one point of each refined triangle.", "One point for each coarse triangle.",
                 check_geometry_points),
      after_case("geometry.picture", {"chapter-14-2"}, "The picture through a geometry shader is the unrefined one.",
                 "The geometry shader is skipped, or gets other varyings.", check_geometry_picture),
      after_case("primitive_id.fragment", {"chapter-14-3"}, "The fragment shader writes gl_PrimitiveID.",
                 "The number of the coarse triangle.", check_primitive_id),
      after_case("queries.primitives", {"chapter-14-8"},
                 "PRIMITIVES_GENERATED and PRIMITIVES_WRITTEN, also if the buffer is too small.",
                 "Coarse triangles are counted.", check_queries),
      after_case("queries.nothing_else", {"chapter-14-9"}, "The first draw of a context lies within a query.",
                 "Passes of the implementation itself are counted.", check_first_draw_in_query),
      after_case("queries.samples", {"chapter-14-9"}, "Compare the samples passed, refined and unrefined.",
                 "Samples are counted twice.", check_occlusion),
      after_case("feedback.draws", {"chapter-14-5"},
                 "Refined and unrefined draws go into one transform feedback, with a pause in between.",
                 "A draw overwrites the one before; draws during the pause are captured.", check_feedback_draws),
      after_case("feedback.disabled", {"chapter-14-5"},
                 "ARK is disabled between two draws into one transform feedback.", "The second draw is lost.",
                 check_feedback_disabled),
      after_case("feedback.unrefined", {"chapter-14-1"},
                 "Refine a draw, disable ARK, and capture unrefined draws with a pause between them.",
                 "The draw during the pause is captured.", check_feedback_unrefined),
      after_case("feedback.order", {"chapter-14-7"}, "20 coarse triangles at a uniform depth of 3 keep their order.",
                 "Sorted.", check_feedback_order),
      after_case("feedback.separate", {"chapter-14-5"}, "Two varyings into two buffers.",
                 "Only the first buffer is written.", check_feedback_separate),
      after_case("feedback.lines", {"chapter-14-5", "chapter-14-6"},
                 "A geometry shader makes a line of each refined triangle, which transform feedback captures.",
                 "The draw is not refined.", [](Test& t) { check_other_feedback(t, GL_LINES); }),
      after_case("feedback.points", {"chapter-14-5", "chapter-14-6"}, "The same with points.",
                 "The draw is not refined.", [](Test& t) { check_other_feedback(t, GL_POINTS); }),
      after_case("feedback.errors", {"10.R.2-13", "chapter-14-6"},
                 "While refined triangles are captured, call what GL refuses then: other objects, programs, links.",
                 "No error, because the implementation pauses the feedback between its draws.", check_feedback_errors),
      after_case("feedback.mode", {"chapter-14-6"},
                 "Triangles are an error in transform feedback of lines, refined and unrefined; so are lines in "
                 "transform feedback of triangles.",
                 "No error; or lines are captured.", check_feedback_mode),
  };
}

}  // namespace glark::conformance
