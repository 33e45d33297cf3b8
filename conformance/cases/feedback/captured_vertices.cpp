// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Draws of vertices that transform feedback has captured.
#include <fmt/core.h>
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "conformance/cases/cases.h"
#include "conformance/support/counted.h"
#include "conformance/support/refined_draw.h"

namespace glark::conformance {
namespace {

constexpr GLsizei vertices = 6;

Mesh two_triangles() {
  Mesh mesh = one_triangle();
  for (MeshVertex vertex : one_triangle()) {
    vertex.position = {0.3F * vertex.position[0] + 0.65F, 0.3F * vertex.position[1] + 0.65F, 0, 1};  // beside it
    mesh.push_back(vertex);
  }
  return mesh;
}

// Since OpenGL 4.4, the vertex stage itself may say in which buffer an output lies.
void check_several_buffers(Test& t) {
  if (t.version() < 44) t.not_supported("outputs name no buffers");
  std::string log;
  const GLuint capturing =
      try_program({.vertex = "#version 440\n"
                             "layout(location = 0) in vec4 position; layout(location = 3) in vec4 vertex_colour;\n"
                             "layout(xfb_buffer = 0, xfb_offset = 0, xfb_stride = 16) out vec4 place;\n"
                             "layout(xfb_buffer = 1, xfb_offset = 0, xfb_stride = 16) out vec4 colour;\n"
                             "void main() { place = position; colour = vertex_colour; gl_Position = position; }\n",
                   .fragment = "#version 440\nin vec4 colour; out vec4 pixel; void main() { pixel = colour; }\n"},
                  log);
  t.require(capturing != 0, "the program builds: " + log);
  gl.UseProgram(capturing);
  upload(two_triangles());
  GLuint object = 0, array = 0, buffers[2] = {};
  gl.GenTransformFeedbacks(1, &object);
  gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, object);
  gl.GenBuffers(2, buffers);
  for (GLuint i = 0; i < 2; ++i) {
    gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, i, buffers[i]);
    gl.BufferData(GL_TRANSFORM_FEEDBACK_BUFFER, vertices * sizeof(Vec4), nullptr, GL_STATIC_DRAW);
  }
  gl.BeginTransformFeedback(GL_TRIANGLES);
  gl.DrawArrays(GL_TRIANGLES, 0, vertices);
  gl.EndTransformFeedback();
  gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, 0);
  gl.UseProgram(colour_program(t));
  gl.GenVertexArrays(1, &array);
  gl.BindVertexArray(array);
  for (const auto& [buffer, location] : {std::pair<GLuint, GLuint>{buffers[0], at_position}, {buffers[1], at_colour}}) {
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
    gl.VertexAttribPointer(location, 4, GL_FLOAT, GL_FALSE, sizeof(Vec4), nullptr);
    gl.EnableVertexAttribArray(location);
  }
  const auto draw = [object] { gl.DrawTransformFeedback(GL_TRIANGLES, object); };
  const Picture expected = picture_of(draw);
  t.expect(count_different(expected, Picture(surface_size, surface_size), 8) > 300, "something is drawn");
  refine_by_tags(4);
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK);
  gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, 8);
  for (int again = 0; again < 4; ++again)
    t.expect_same_picture(picture_of(draw), expected, "refined captured vertices", 4, 80);
  t.expect_no_error("the draws");
}

// Stages before the fragments, as programs of their own. Each passes positions on.
constexpr char vertex_stage[] =
    "layout(location = 0) in vec4 position; layout(location = 0) out vec4 from_vertex;\n"
    "out gl_PerVertex { vec4 gl_Position; };\n"
    "void main() { from_vertex = position; gl_Position = position; }\n";
constexpr char evaluation_stage[] =
    "layout(triangles) in; in gl_PerVertex { vec4 gl_Position; } gl_in[];\n"
    "layout(location = 0) out vec4 from_evaluation; out gl_PerVertex { vec4 gl_Position; };\n"
    "void main() { gl_Position = gl_TessCoord.x * gl_in[0].gl_Position + gl_TessCoord.y * gl_in[1].gl_Position +\n"
    "    gl_TessCoord.z * gl_in[2].gl_Position; from_evaluation = gl_Position; }\n";
constexpr char geometry_stage[] =
    "layout(triangles) in; layout(triangle_strip, max_vertices = 3) out;\n"
    "in gl_PerVertex { vec4 gl_Position; } gl_in[];\n"
    "layout(location = 0) out vec4 from_geometry; out gl_PerVertex { vec4 gl_Position; };\n"
    "void main() { for (int i = 0; i < 3; ++i) { from_geometry = gl_Position = gl_in[i].gl_Position; EmitVertex(); }\n"
    "  EndPrimitive(); }\n";

struct Stage {
  GLenum type;
  GLbitfield bit;
  const char* source;
  const char* captured;
};
constexpr std::array<Stage, 3> stages = {
    {{GL_VERTEX_SHADER, GL_VERTEX_SHADER_BIT, vertex_stage, "from_vertex"},
     {GL_TESS_EVALUATION_SHADER, GL_TESS_EVALUATION_SHADER_BIT, evaluation_stage, "from_evaluation"},
     {GL_GEOMETRY_SHADER, GL_GEOMETRY_SHADER_BIT, geometry_stage, "from_geometry"}}};

// A separable program of these stages. `captures`: it captures the output of the last one.
GLuint program_of(Test& t, const std::vector<const Stage*>& of, bool captures) {
  const GLuint program = gl.CreateProgram();
  gl.ProgramParameteri(program, GL_PROGRAM_SEPARABLE, GL_TRUE);
  for (const Stage* const stage : of) {
    const std::string text = glsl_head(t) + stage->source;
    const char* const texts = text.c_str();
    const GLuint shader = gl.CreateShader(stage->type);
    gl.ShaderSource(shader, 1, &texts, nullptr);
    gl.CompileShader(shader);
    gl.AttachShader(program, shader);
    gl.DeleteShader(shader);
  }
  if (captures) gl.TransformFeedbackVaryings(program, 1, &of.back()->captured, GL_INTERLEAVED_ATTRIBS);
  gl.LinkProgram(program);
  GLint linked = GL_FALSE;
  gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked == GL_FALSE) t.internal_error("a separable program does not build");
  return program;
}

struct Captured {
  GLuint object = 0;
  GLuint buffer = 0;
};

// The buffer has just enough room.
Captured capture_two_triangles(GLenum mode) {
  Captured captured;
  gl.GenTransformFeedbacks(1, &captured.object);
  gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, captured.object);
  gl.GenBuffers(1, &captured.buffer);
  gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, captured.buffer);
  gl.BufferData(GL_TRANSFORM_FEEDBACK_BUFFER, vertices * sizeof(Vec4), nullptr, GL_STATIC_DRAW);
  gl.Enable(GL_RASTERIZER_DISCARD);
  gl.BeginTransformFeedback(GL_TRIANGLES);
  gl.DrawArrays(mode, 0, vertices);
  gl.EndTransformFeedback();
  gl.Disable(GL_RASTERIZER_DISCARD);
  gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, 0);
  return captured;
}

// Draws what was captured by each command. Each draw has the picture and four times the triangles of the unrefined one.
void expect_captured_refined(Test& t, const Captured& captured, const std::string& what) {
  GLuint array = 0;
  gl.GenVertexArrays(1, &array);
  gl.BindVertexArray(array);
  gl.BindBuffer(GL_ARRAY_BUFFER, captured.buffer);
  gl.VertexAttribPointer(at_position, 4, GL_FLOAT, GL_FALSE, 0, nullptr);
  gl.EnableVertexAttribArray(at_position);
  gl.VertexAttrib4f(at_colour, 1, 0.5F, 0.25F, 1);
  const GLuint object = captured.object;
  const std::array<std::function<void()>, 4> draws = {
      [object] { gl.DrawTransformFeedback(GL_TRIANGLES, object); },
      [object] { gl.DrawTransformFeedbackInstanced(GL_TRIANGLES, object, 3); },
      [object] { gl.DrawTransformFeedbackStream(GL_TRIANGLES, object, 0); },
      [object] { gl.DrawTransformFeedbackStreamInstanced(GL_TRIANGLES, object, 0, 3); }};
  for (std::size_t i = 0; i < draws.size(); ++i) {
    const std::string of_draw = fmt::format("{}, command {}", what, i);
    const GLuint coarse = i % 2 == 0 ? 2 : 6;
    const Picture plain = picture_of(draws[i]);
    t.expect_equal(count_generated(draws[i]), coarse, of_draw + ": unrefined triangles");
    gl.Enable(GL_ARK);
    for (int again = 0; again < 2; ++again) {
      t.expect_equal(count_generated(draws[i]), 4 * coarse, of_draw + ": triangles");
      t.expect_same_picture(picture_of(draws[i]), plain, of_draw, 2, 40);
    }
    gl.Disable(GL_ARK);
  }
}

// Captures with the last stage in a pipeline, alone in its program or together with the vertex stage, and in a program
// that is in use.
void check_captured_stage(Test& t, const Stage& last) {
  const GLuint drawing = colour_program(t);
  const bool is_patch = last.type == GL_TESS_EVALUATION_SHADER;
  const GLuint array = upload(two_triangles(), false).array;
  gl.PatchParameteri(GL_PATCH_VERTICES, 3);
  refine_uniformly(1);
  gl.Disable(GL_ARK);
  const bool is_vertex = last.type == GL_VERTEX_SHADER;
  const std::vector<const Stage*> all =
      is_vertex ? std::vector<const Stage*>{&last} : std::vector<const Stage*>{&stages[0], &last};
  const GLuint whole = program_of(t, all, true);
  const GLuint alone = program_of(t, {&last}, true);
  const GLuint first = is_vertex ? alone : program_of(t, {&stages[0]}, false);
  GLuint pipelines[2] = {};
  gl.GenProgramPipelines(2, pipelines);
  gl.UseProgramStages(pipelines[0], GL_VERTEX_SHADER_BIT | last.bit, whole);
  gl.UseProgramStages(pipelines[1], GL_VERTEX_SHADER_BIT, first);
  gl.UseProgramStages(pipelines[1], last.bit, alone);
  for (const GLuint pipeline : {pipelines[1], pipelines[0], GLuint{0}}) {
    const std::string what = pipeline == 0              ? "a program"
                             : pipeline == pipelines[0] ? "a program of a pipeline"
                                                        : "a pipeline";
    gl.BindVertexArray(array);
    gl.BindProgramPipeline(pipeline);
    gl.UseProgram(pipeline == 0 ? whole : 0);
    const Captured captured = capture_two_triangles(is_patch ? GL_PATCHES : GL_TRIANGLES);
    gl.BindProgramPipeline(0);
    gl.UseProgram(drawing);
    expect_captured_refined(t, captured, "captured by " + what);
  }
  t.expect_no_error("the draws");
}

constexpr Area captured_case{"ark.after_vertex.captured."};

}  // namespace

Cases captured_vertices_cases() {
  Cases cases = {captured_case("several_buffers", {"10.R.2-2"},
                               "Capture outputs into two buffers that the vertex stage names, and draw the vertices.",
                               "Only half of the triangles.", check_several_buffers, desktop_apis)};
  cases.back().is_optional = true;  // outputs that name buffers
  for (const Stage& stage : stages)
    cases.push_back(captured_case(
        stage.captured, {"10.R.2-2"},
        "Capture the output of this stage of a program and of program pipelines, and draw it by each command.",
        "What a pipeline captured is drawn unrefined, or the number of its vertices is that of another stage.",
        [&stage](Test& t) { check_captured_stage(t, stage); }, desktop_apis));
  return cases;
}

}  // namespace glark::conformance
