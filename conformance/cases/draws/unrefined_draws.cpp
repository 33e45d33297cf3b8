// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Draws that are not refined (11.R.11): they are drawn unrefined, without an error.
#include "conformance/cases/cases.h"
#include "conformance/support/surface.h"

namespace glark::conformance {
namespace {

void expect_unrefined(Test& t, const std::function<void()>& draw, const char* what) {
  const Picture expected = picture_of(draw);
  t.expect(count_different(expected, Picture(surface_size, surface_size), 0) > 0, "something is drawn unrefined");
  refine_uniformly(3);
  const Picture actual = picture_of(draw);
  t.expect_no_error("a draw that cannot be refined");
  t.expect_same_picture(actual, expected, what);
}

struct OtherMode {
  const char* leaf;
  GLenum mode;
};

void check_mode(Test& t, GLenum mode) {
  gl.UseProgram(build_program(
      t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 3) in vec4 tint; out vec4 colour;\n"
                    "void main() { colour = tint; gl_Position = position; gl_PointSize = 3.0; }\n"}));
  Mesh mesh = bent_mesh();
  for (std::size_t i = 0; i < mesh.size(); ++i) mesh[i].colour = {0.1F * static_cast<float>(i + 3), 0.5F, 1, 1};
  upload(mesh);
  expect_unrefined(
      t, [mode] { gl.DrawArrays(mode, 0, 6); }, "the same bits as without refinement");
}

const char tessellation_control[] =
    "layout(vertices = 3) out; in vec4 between[]; out vec4 further[];\n"
    "void main() { gl_out[gl_InvocationID].gl_Position = gl_in[gl_InvocationID].gl_Position;\n"
    "  further[gl_InvocationID] = between[gl_InvocationID];\n"
    "  gl_TessLevelInner[0] = 2.0; gl_TessLevelOuter[0] = 3.0; gl_TessLevelOuter[1] = 1.0; gl_TessLevelOuter[2] = 2.0; "
    "}\n";
const char tessellation_evaluation[] =
    "layout(triangles) in; in vec4 further[]; out vec4 colour;\n"
    "void main() { gl_Position = gl_TessCoord.x * gl_in[0].gl_Position + gl_TessCoord.y * gl_in[1].gl_Position +\n"
    "  gl_TessCoord.z * gl_in[2].gl_Position; colour = further[0] * gl_TessCoord.x + further[1] * gl_TessCoord.y * "
    "0.5; }\n";

GLuint tessellation_program(Test& t) {
  const GLuint program = gl.CreateProgram();
  const std::pair<GLenum, std::string> stages[] = {
      {GL_VERTEX_SHADER,
       "layout(location = 0) in vec4 position; layout(location = 3) in vec4 tint; out vec4 between;\n"
       "void main() { between = tint; gl_Position = position; }\n"},
      {GL_TESS_CONTROL_SHADER, tessellation_control},
      {GL_TESS_EVALUATION_SHADER, tessellation_evaluation},
      {GL_FRAGMENT_SHADER, "in vec4 colour; out vec4 pixel; void main() { pixel = colour; }\n"}};
  for (const auto& [stage, text] : stages) {
    const std::string whole = glsl_head(t) + text;
    const char* const source = whole.c_str();
    const GLuint shader = gl.CreateShader(stage);
    gl.ShaderSource(shader, 1, &source, nullptr);
    gl.CompileShader(shader);
    gl.AttachShader(program, shader);
  }
  gl.LinkProgram(program);
  GLint linked = 0;
  gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked == 0) t.internal_error("the tessellation program does not link");
  return program;
}

void check_patches(Test& t) {
  gl.UseProgram(tessellation_program(t));
  gl.PatchParameteri(GL_PATCH_VERTICES, 3);
  upload(one_triangle());
  expect_unrefined(
      t, [] { gl.DrawArrays(GL_PATCHES, 0, 3); }, "patches are drawn as without refinement");
}

void check_tessellated_triangles(Test& t) {
  gl.UseProgram(tessellation_program(t));
  upload(one_triangle());
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  t.expect_error(GL_INVALID_OPERATION, "triangles with a tessellation program, unrefined");
  refine_uniformly(2);
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  t.expect_error(GL_INVALID_OPERATION, "triangles with a tessellation program while ARK is enabled");
}

void draw_fixed() {
  gl.Begin(GL_TRIANGLES);
  gl.Color4f(1, 0.5F, 0, 1);
  gl.Vertex3f(-0.75F, -0.75F, 0);
  gl.Vertex3f(0.75F, -0.75F, 0);
  gl.Vertex3f(-0.25F, 0.75F, 0);
  gl.End();
}

// Moves refined triangles out of the picture.
void hide_when_refined(Test& t) {
  const char* const source = "void refine() { gl_Vertex.xyz += vec3(5.0); }";
  gl.RefinementShaderSourceARK(0, 1, &source, nullptr);
  clear_surface();
  draw_fixed();
  const Picture picture = read_picture(surface_size, surface_size);
  t.expect_same_picture(picture, Picture(surface_size, surface_size), "the refinement shader moves it out of sight");
}

void check_feedback(Test& t) {
  std::vector<GLfloat> buffer(1000, 0);
  refine_uniformly(2);
  gl.FeedbackBuffer(1000, GL_2D, buffer.data());
  gl.RenderMode(GL_FEEDBACK);
  draw_fixed();
  const GLint count = gl.RenderMode(GL_RENDER);
  // The format: a token, the number of vertices, two coordinates for each.
  t.expect_equal(count, 8, "values in the feedback buffer");
  t.expect_equal(buffer[0], static_cast<GLfloat>(GL_POLYGON_TOKEN), "the token");
  t.expect_equal(buffer[1], 3.0F, "the vertices");
}

void check_selection(Test& t) {
  GLuint buffer[64] = {};
  refine_uniformly(2);
  hide_when_refined(t);
  gl.SelectBuffer(64, buffer);
  gl.RenderMode(GL_SELECT);
  gl.InitNames();
  gl.PushName(17);
  draw_fixed();
  t.expect_equal(gl.RenderMode(GL_RENDER), 1, "hits");
  t.expect(buffer[0] == 1 && buffer[3] == 17, "the name of the triangle");
}

// A hit record has the least and the greatest depth of the drawn primitives. A curved triangle would bulge.
void check_selected_depths(Test& t, GLenum source) {
  gl.UseProgram(surface_program(t));
  Mesh mesh = one_triangle({2, 2, 2});
  mesh[0].normal = {-0.8F, -0.6F, 0.6F};
  mesh[1].normal = {0.8F, -0.6F, 0.6F};
  mesh[2].normal = {0, 0.9F, 0.6F};
  upload(mesh);
  std::array<std::array<GLuint, 64>, 2> records = {};
  for (const bool is_refined : {false, true}) {
    if (is_refined) refine_by_tags(2, GL_CURVED_PN_ARK);
    gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, static_cast<GLint>(source));
    gl.SelectBuffer(64, records[is_refined ? 1 : 0].data());
    gl.RenderMode(GL_SELECT);
    gl.InitNames();
    gl.PushName(17);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    t.expect_equal(gl.RenderMode(GL_RENDER), 1, "hits");
  }
  t.expect(records[0] == records[1], "the hit record is that of the triangle, with its depths");
}

void check_bad_refinement_shader(Test& t, const char* source) {
  const GLuint program = colour_program(t);
  gl.UseProgram(program);
  upload(one_triangle());
  gl.RefinementShaderSourceARK(program, 1, &source, nullptr);
  expect_unrefined(
      t, [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); }, "a refinement shader that does not compile");
  GLint status = GL_TRUE;
  gl.GetRefinementivARK(program, GL_REFINEMENT_STATUS_ARK, &status);
  t.expect_equal(status, GL_FALSE, "REFINEMENT_STATUS_ARK");
  GLint length = -1;
  GLsizei written = -1;
  char log[8000] = "";
  gl.GetRefinementivARK(program, GL_REFINEMENT_LOG_LENGTH_ARK, &length);
  gl.GetRefinementInfoLogARK(program, sizeof(log), &written, log);
  t.expect(written > 0 && written + 1 < static_cast<GLsizei>(sizeof(log)), "there is a log");
  t.expect_equal(length, written + 1, "REFINEMENT_LOG_LENGTH_ARK, with the null terminator");
  t.expect_equal(std::string(log).size(), static_cast<std::size_t>(written), "characters of the log");
}

void check_assembly(Test& t) {
  if (!t.has_extension("GL_ARB_vertex_program")) t.not_supported("no GL_ARB_vertex_program");
  const char text[] =
      "!!ARBvp1.0\nMOV result.position, vertex.position;\nMUL result.color, vertex.position, {0.5, 1.0, 1.0, 1.0};\n"
      "END\n";
  GLuint program = 0;
  gl.GenProgramsARB(1, &program);
  gl.BindProgramARB(GL_VERTEX_PROGRAM_ARB, program);
  gl.ProgramStringARB(GL_VERTEX_PROGRAM_ARB, GL_PROGRAM_FORMAT_ASCII_ARB, sizeof(text) - 1, text);
  gl.Enable(GL_VERTEX_PROGRAM_ARB);
  expect_unrefined(t, draw_fixed, "an assembly program");
}

void check_pipeline(Test& t) {
  bind_pipeline(t,
                "layout(location = 0) in vec4 position; layout(location = 3) in vec4 tint;\n"
                "layout(location = 0) out vec4 colour; void main() { colour = tint; gl_Position = position; }\n",
                "layout(location = 0) in vec4 colour; layout(location = 0) out vec4 pixel;\n"
                "void main() { pixel = colour; }\n");
  upload(one_triangle());
  const auto draw = [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); };
  const Picture expected = picture_of(draw);
  refine_uniformly(3);
  const Picture actual = picture_of(draw);
  t.expect_no_error("a draw with a pipeline object");
  // The refined and the unrefined picture are the same.
  t.expect_same_picture(actual, expected, "a linear vertex stage in a pipeline object", 2, 12);
}

void check_doubles(Test& t) {
  gl.UseProgram(build_program(
      t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 7) in dvec2 d; out vec4 colour;\n"
                    "void main() { colour = vec4(d, 0.5, 1.0); gl_Position = position; }\n"}));
  const Mesh mesh = one_triangle();
  upload(mesh);
  const double values[] = {0.1, 0.9, 0.8, 0.3, 0.4, 0.6};
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, sizeof(values), values, GL_STATIC_DRAW);
  gl.VertexAttribLPointer(7, 2, GL_DOUBLE, 0, nullptr);
  gl.EnableVertexAttribArray(7);
  const auto draw = [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); };
  const Picture expected = picture_of(draw);
  refine_uniformly(3);
  t.expect_same_picture(picture_of(draw), expected, "double-precision inputs, refined or not", 2, 12);
}

void check_subroutines(Test& t) {
  gl.UseProgram(build_program(
      t, {.vertex = "subroutine vec4 Tint(vec4 c); subroutine uniform Tint tint;\n"
                    "subroutine(Tint) vec4 swapped(vec4 c) { return c.bgra; }\n"
                    "layout(location = 0) in vec4 position; layout(location = 3) in vec4 c; out vec4 colour;\n"
                    "void main() { colour = tint(c); gl_Position = position; }\n"}));
  upload(one_triangle());
  const auto draw = [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); };
  const Picture expected = picture_of(draw);
  refine_uniformly(3);
  t.expect_same_picture(picture_of(draw), expected, "subroutines, refined or not", 2, 12);
}

// The vertex stage may be executed any number of times, but what it draws is the same.
void check_stores(Test& t) {
  GLint counters = 0;
  gl.GetIntegerv(GL_MAX_VERTEX_ATOMIC_COUNTERS, &counters);
  if (counters < 1) t.not_supported("no atomic counters in the vertex stage");
  gl.UseProgram(build_program(
      t, {.vertex = "layout(binding = 0) uniform atomic_uint executed;\n"
                    "layout(location = 0) in vec4 position; layout(location = 3) in vec4 c; out vec4 colour;\n"
                    "void main() { atomicCounterIncrement(executed); colour = c; gl_Position = position; }\n"}));
  const GLuint zero = 0;
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBufferBase(GL_ATOMIC_COUNTER_BUFFER, 0, buffer);
  gl.BufferData(GL_ATOMIC_COUNTER_BUFFER, sizeof(zero), &zero, GL_DYNAMIC_COPY);
  upload(one_triangle());
  const auto draw = [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); };
  const Picture expected = picture_of(draw);
  refine_uniformly(3);
  t.expect_same_picture(picture_of(draw), expected, "a stage that counts, refined or not", 2, 12);
  t.expect_no_error("the draws");
  GLuint executed = 0;
  gl.GetBufferSubData(GL_ATOMIC_COUNTER_BUFFER, 0, sizeof(executed), &executed);
  t.expect(executed >= 4, "the stage was executed in both draws: " + as_text(executed) + " times");
}

void check_depth_0(Test& t, GLenum refinement) {
  gl.UseProgram(build_program(
      t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 3) in vec4 c; out vec4 colour;\n"
                    "void main() { colour = sin(c * 7.1) * 0.5 + 0.5; gl_Position = position * 1.1; }\n"}));
  Mesh mesh = bent_mesh();
  for (MeshVertex& vertex : mesh)
    for (float& channel : vertex.colour) channel = t.random_float(0, 1);
  for (MeshVertex& vertex : mesh) vertex.tag = 3;
  upload(mesh);
  const auto draw = [] { gl.DrawArrays(GL_TRIANGLES, 0, 6); };
  const Picture expected = picture_of(draw);
  refine_uniformly(3, refinement);
  gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 0);
  t.expect_same_picture(picture_of(draw), expected, "a uniform depth of 0");
}

void check_disabled(Test& t) {
  gl.UseProgram(colour_program(t));
  Mesh mesh = bent_mesh();
  for (MeshVertex& vertex : mesh) vertex.tag = 3;
  upload(mesh);
  const auto draw = [] { gl.DrawArrays(GL_TRIANGLES, 0, 6); };
  const Picture expected = picture_of(draw);
  refine_by_tags(4, GL_CURVED_PN_ARK);
  picture_of(draw);
  gl.Disable(GL_ARK);
  t.expect_same_picture(picture_of(draw), expected, "with ARK disabled again");
  gl.UseProgram(capture_program(t));
  t.expect_equal(capture(t, draw).size(), 6U, "vertices with ARK disabled");
}

constexpr Area made{"ark.unrefined."};

}  // namespace

Cases unrefined_draws_cases() {
  Cases cases = {
      made("tessellation.patches", {"11.R.11-3", "tessellation-1"},
           "Patches through tessellation shaders, while ARK is enabled.", "Nothing is drawn.", check_patches),
      made("tessellation.triangles", {"11.R.11-3", "tessellation-2"},
           "Triangles with a tessellation program are an error, with and without ARK.", "They are refined.",
           check_tessellated_triangles),
      made("render_mode.feedback", {"11.R.11-4", "issues-20"}, "One triangle in the feedback buffer.", "Refined ones.",
           check_feedback, compat_only),
      made("render_mode.select", {"11.R.11-4"}, "One hit record.", "No hit record, as nothing is drawn.",
           check_selection, compat_only),
      made(
          "render_mode.select_depths.tags", {"11.R.11-4"},
          "Read the depths in the hit record of a triangle that would be curved.", "The depths of the curved triangle.",
          [](Test& t) { check_selected_depths(t, GL_DEPTH_TAG_ARK); }, compat_only),
      made(
          "render_mode.select_depths.uniform", {"11.R.11-4"}, "The same, of a uniform depth.",
          "The depths of the curved triangle.", [](Test& t) { check_selected_depths(t, GL_UNIFORM_DEPTH_ARK); },
          compat_only),
      made("refinement_shader.syntax", {"11.R.11-1", "11.R.11-5", "11.R.9-30"},
           "The refinement shader has a syntax error.", "An error, or nothing is drawn.",
           [](Test& t) { check_bad_refinement_shader(t, "void refine() { position += ; }"); }),
      made("refinement_shader.inactive_input", {"11.R.11-5", "11.R.9-17"},
           "The refinement shader reads something that is not an input.", "An error, or nothing is drawn.",
           [](Test& t) { check_bad_refinement_shader(t, "void refine() { position.x += no_such_input; }"); }),
      made("refinement_shader.no_refine", {"11.R.11-5", "11.R.9-12"}, "The refinement shader has no function refine.",
           "Nothing is drawn.", [](Test& t) { check_bad_refinement_shader(t, "float other() { return 1.0; }"); }),
      optional(made("assembly", {"programs-1", "11.R.11-5"}, "VERTEX_PROGRAM_ARB is enabled.",
                    "The fixed-function vertex stage is refined instead.", check_assembly, compat_only)),
      made("pipeline", {"11.R.11-10"}, "A program pipeline object; the draw may be refined or not.",
           "Nothing is drawn.", check_pipeline),
      made("doubles", {"11.R.11-10"}, "Double-precision inputs; the draw may be refined or not.", "They read as 0.",
           check_doubles, desktop_apis),
      made("subroutines", {"11.R.11-10"}, "Subroutines; the draw may be refined or not.", "Nothing is drawn.",
           check_subroutines, desktop_apis),
      optional(made("stores", {"11.R.11-10"}, "A vertex stage with an atomic counter; the draw may be refined or not.",
                    "Nothing is drawn; the stage is executed in one of the draws only.", check_stores, desktop_apis)),
      made("depth_0.inputs", {"11.R.11-8"}, "With UNIFORM_DEPTH_LEVEL_ARK of 0, the bits are the same.",
           "Last bits of colors change.", [](Test& t) { check_depth_0(t, GL_LINEAR_INPUTS_ARK); }),
      made("depth_0.outputs", {"11.R.11-8"}, "The same with LINEAR_OUTPUTS_ARK.", "Last bits of colors change.",
           [](Test& t) { check_depth_0(t, GL_LINEAR_OUTPUTS_ARK); }),
      made("disabled", {"11.R.1-12", "10.R.2-1"},
           "ARK is disabled after a refined draw: the bits are the same as before.", "Something stays refined.",
           check_disabled),
  };
  for (const OtherMode& mode : {OtherMode{"points", GL_POINTS},
                                {"lines", GL_LINES},
                                {"line_strip", GL_LINE_STRIP},
                                {"line_loop", GL_LINE_LOOP},
                                {"lines_adjacency", GL_LINES_ADJACENCY}})
    cases.push_back(made(std::string("mode.") + mode.leaf, {"11.R.11-2", "10.R.2-3"},
                         "Draw in this mode with and without ARK: the bits are the same.",
                         "Lines are divided, or nothing is drawn.", [mode](Test& t) { check_mode(t, mode.mode); }));
  return cases;
}

}  // namespace glark::conformance
