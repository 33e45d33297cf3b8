// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Draws that are repeated after a change that is not in a buffer: where the draw begins, which corner comes first,
// which object has the name. An implementation must not use cached results of the earlier draw.
#include <cstring>

#include "conformance/cases/cases.h"
#include "conformance/cases/repeated/expect_change.h"
#include "conformance/support/counted.h"
#include "conformance/support/refined_draw.h"

namespace glark::conformance {
namespace {

constexpr GLsizei vertices = 6;
constexpr int repeats = 4;

Mesh two_triangles() {
  Mesh mesh = one_triangle({1, 3, 2});
  for (MeshVertex vertex : one_triangle({2, 2, 0})) {
    vertex.position = {0.5F * vertex.position[0] + 0.5F, -vertex.position[1], 0, 1};
    mesh.push_back(vertex);
  }
  number_triangles(mesh);
  return mesh;
}

void draw_all() { gl.DrawArrays(GL_TRIANGLES, 0, vertices); }

void refine(bool is_uniform, GLenum refinement = GL_LINEAR_INPUTS_ARK) {
  is_uniform ? refine_uniformly(2, refinement) : refine_by_tags(3, refinement);
}

// Colours in a buffer that stays mapped: no GL command announces their change.
void check_persistent(Test& t, bool is_uniform) {
  if (t.version() < 44 && !t.has_extension("GL_ARB_buffer_storage")) t.not_supported("no buffers that stay mapped");
  gl.UseProgram(colour_program(t));
  upload(two_triangles());
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  constexpr GLbitfield flags = GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
  gl.BufferStorage(GL_ARRAY_BUFFER, vertices * 4, nullptr, flags);
  auto* const mapped = static_cast<GLuint*>(gl.MapBufferRange(GL_ARRAY_BUFFER, 0, vertices * 4, flags));
  t.require(mapped != nullptr, "the buffer can be mapped");
  gl.VertexAttribPointer(at_colour, 4, GL_UNSIGNED_BYTE, GL_TRUE, 0, nullptr);
  const GLuint first[vertices] = {0xff0000ff, 0xff00ff00, 0xffff0000, 0xff00ffff, 0xffffff00, 0xffff00ff};
  std::memcpy(mapped, first, sizeof(first));
  refine(is_uniform);
  const auto write = [mapped] {
    const GLuint second[vertices] = {0xff404040, 0xff0000ff, 0xffffffff, 0xffff8000, 0xff0080ff, 0xff00ff40};
    gl.Finish();
    std::memcpy(mapped, second, sizeof(second));
  };
  expect_change(t, draw_all, write, "a write to memory that stays mapped");
}

// One colour for each instance. A single instance takes its colour from the base instance.
void check_base_instance(Test& t, bool is_indexed) {
  gl.UseProgram(colour_program(t));
  upload(two_triangles());
  gl.VertexAttribDivisor(at_colour, 1);
  GLuint elements = 0;
  gl.GenBuffers(1, &elements);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, elements);
  const GLubyte indices[] = {3, 4, 5, 0, 1, 2};
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof(indices), indices, GL_STATIC_DRAW);
  GLuint base = 0;
  const auto draw = [&base, is_indexed] {
    if (is_indexed)
      gl.DrawElementsInstancedBaseInstance(GL_TRIANGLES, vertices, GL_UNSIGNED_BYTE, nullptr, 1, base);
    else
      gl.DrawArraysInstancedBaseInstance(GL_TRIANGLES, 0, vertices, 1, base);
  };
  refine_by_tags(3);
  for (const GLuint next : {1U, 2U, 0U})
    expect_change(
        t, draw, [&base, next] { base = next; }, "another base instance");
}

// In strips, the convention decides the order of corners of every other triangle.
void check_convention(Test& t, GLenum mode, GLenum refinement) {
  gl.UseProgram(build_program(
      t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 3) in vec4 vertex_colour;\n"
                    "flat out vec4 flat_colour; out vec4 colour;\n"
                    "void main() { flat_colour = vertex_colour; colour = vertex_colour; gl_Position = position; }\n",
          .fragment = "flat in vec4 flat_colour; in vec4 colour; out vec4 pixel;\n"
                      "void main() { pixel = mix(flat_colour, colour, 0.25); }"}));
  Mesh mesh;
  for (int i = 0; i < vertices; ++i) {
    const auto n = static_cast<float>(i);
    MeshVertex vertex;
    vertex.position = {0.3F * n - 0.75F, i % 2 == 0 ? -0.75F : 0.75F, 0, 1};
    vertex.colour = {0.2F * n, 1 - 0.2F * n, i % 3 == 0 ? 1.0F : 0.25F, 1};
    vertex.tag = static_cast<float>(i * i % 4);
    mesh.push_back(vertex);
  }
  upload(mesh);
  refine(false, refinement);
  const auto draw = [mode] { gl.DrawArrays(mode, 0, vertices); };
  for (const GLenum convention : {GL_FIRST_VERTEX_CONVENTION, GL_LAST_VERTEX_CONVENTION})
    expect_change(
        t, draw, [convention] { gl.ProvokingVertex(convention); }, "the other convention");
}

// Some implementations give a new object the deleted one's name. The new object has only the array of positions.
void check_object_again(Test& t, bool is_uniform) {
  gl.UseProgram(colour_program(t));
  const MeshBuffers first = upload(two_triangles());
  refine(is_uniform);
  gl.DepthTag1i(1);
  gl.VertexAttrib4f(at_colour, 0, 1, 1, 1);
  for (int again = 0; again < repeats; ++again) draw_all();
  const auto count = static_cast<GLuint>(count_generated(draw_all));
  const auto renew = [&first] {
    gl.DeleteVertexArrays(1, &first.array);
    GLuint array = 0;
    gl.GenVertexArrays(1, &array);
    gl.BindVertexArray(array);
    gl.BindBuffer(GL_ARRAY_BUFFER, first.buffer);
    gl.VertexAttribPointer(at_position, 4, GL_FLOAT, GL_FALSE, sizeof(MeshVertex), nullptr);
    gl.EnableVertexAttribArray(at_position);
  };
  expect_change(t, draw_all, renew, "an object with one array");
  expect_change(
      t, draw_all, [] { gl.VertexAttrib4f(at_colour, 1, 0.5F, 0, 1); }, "another current value");
  if (is_uniform) return;
  t.expect(count != 8, "the deleted object's tags gave other depths");
  for (int again = 0; again < repeats; ++again)
    t.expect_equal(count_generated(draw_all), 8U, "triangles with the current tag");
  gl.DepthTag1i(2);
  for (int again = 0; again < repeats; ++again)
    t.expect_equal(count_generated(draw_all), 32U, "triangles with another current tag");
}

// Depths differ by so much that a smooth interior may have additional vertices. It need not have them.
void check_interior(Test& t) {
  gl.UseProgram(colour_program(t));
  const std::array<int, 3> tags = {6, 6, 1};
  upload(one_triangle({6, 6, 1}));
  refine_by_tags(6);
  const auto draw = [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); };
  const std::int64_t least = reference::minimum_triangles(reference::edge_depths(tags));
  for (int round = 0; round < 3; ++round)
    for (const GLint interior : {GL_SMOOTH_INTERIOR_ARK, GL_MINIMUM_INTERIOR_ARK}) {
      gl.ARKParameteriARK(GL_PATTERN_INTERIOR_ARK, interior);
      for (int again = 0; again < repeats; ++again) {
        const std::int64_t count = count_generated(draw);
        if (interior == GL_MINIMUM_INTERIOR_ARK)
          t.expect_equal(count, least, "triangles with the least interior, again");
        else
          t.expect(count >= least, "a smooth interior has additional vertices, or none");
      }
    }
}

// Captures vertices and draws them, as programs usually do. There are more instances than an implementation may have
// room for at first.
void check_feedback_instances(Test& t) {
  gl.UseProgram(
      build_program(t, {.vertex = "layout(location = 0) in vec4 position; out vec4 colour; out vec4 place;\n"
                                  "void main() { float n = float(gl_InstanceID % 16); place = position;\n"
                                  "  colour = vec4(fract(0.31 * n), 1.0 - fract(0.17 * n), fract(0.07 * n), 1.0);\n"
                                  "  gl_Position = vec4(0.2 * position.xy + vec2(0.1 * n - 0.8, 0.0), 0.0, 1.0); }\n",
                        .captured = {"place"}}));
  upload(two_triangles());
  GLuint object = 0;
  GLuint buffer = 0;
  GLuint array = 0;
  gl.GenTransformFeedbacks(1, &object);
  gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, object);
  gl.GenBuffers(1, &buffer);
  gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
  gl.BufferData(GL_TRANSFORM_FEEDBACK_BUFFER, vertices * sizeof(Vec4), nullptr, GL_STATIC_DRAW);
  gl.Enable(GL_RASTERIZER_DISCARD);
  gl.BeginTransformFeedback(GL_POINTS);
  gl.DrawArrays(GL_POINTS, 0, vertices);
  gl.EndTransformFeedback();
  gl.Disable(GL_RASTERIZER_DISCARD);
  gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, 0);
  gl.GenVertexArrays(1, &array);
  gl.BindVertexArray(array);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.VertexAttribPointer(at_position, 4, GL_FLOAT, GL_FALSE, sizeof(Vec4), nullptr);
  gl.EnableVertexAttribArray(at_position);
  GLsizei instances = 16;
  const auto draw = [&] { gl.DrawTransformFeedbackInstanced(GL_TRIANGLES, object, instances); };
  refine_uniformly(1);
  expect_as_unrefined(t, draw, "instances of captured vertices");
  gl.Enable(GL_RASTERIZER_DISCARD);
  for (const GLsizei next : {16, 3, 60000}) {
    instances = next;
    t.expect_equal(count_generated(draw), static_cast<GLuint>(8 * instances), "triangles");
  }
  t.expect_no_error("the draws");
}

// The bound pipeline gets another program for a stage. All programs are separable, and have the same interface.
void check_pipeline_stages(Test& t, bool is_uniform) {
  const auto vertex_stage = [](const char* position) {
    return std::string(
               "layout(location = 0) in vec4 position; layout(location = 3) in vec4 vertex_colour;\n"
               "layout(location = 0) out vec4 colour;\n"
               "void main() { colour = vertex_colour; gl_Position = ") +
           position + "; }\n";
  };
  const auto fragment_stage = [](const char* value) {
    return std::string("layout(location = 0) in vec4 colour; out vec4 pixel; void main() { pixel = ") + value + "; }\n";
  };
  const Pipeline pipeline = bind_pipeline(t, vertex_stage("position"), fragment_stage("colour"));
  const GLuint turned = separable_program(t, GL_VERTEX_SHADER, vertex_stage("vec4(-position.yx, position.zw)"));
  const GLuint bright = separable_program(t, GL_FRAGMENT_SHADER, fragment_stage("1.0 - 0.5 * colour"));
  gl.UseProgram(0);
  upload(two_triangles());
  refine(is_uniform);
  const auto use = [&pipeline](GLbitfield stage, GLuint program) {
    return [&pipeline, stage, program] { gl.UseProgramStages(pipeline.name, stage, program); };
  };
  expect_change(t, draw_all, use(GL_VERTEX_SHADER_BIT, turned), "another vertex stage");
  expect_change(t, draw_all, use(GL_FRAGMENT_SHADER_BIT, bright), "another fragment stage");
  expect_change(t, draw_all, use(GL_VERTEX_SHADER_BIT, pipeline.vertex_program), "the first vertex stage");
}

// Uniform commands set a uniform of the pipeline's active program.
void check_pipeline_uniforms(Test& t, bool is_uniform) {
  const Pipeline pipeline =
      bind_pipeline(t,
                    "layout(location = 0) in vec4 position; layout(location = 3) in vec4 vertex_colour;\n"
                    "uniform float shift; layout(location = 0) out vec4 colour;\n"
                    "void main() { colour = vertex_colour; gl_Position = position + vec4(shift, 0.0, 0.0, 0.0); }\n",
                    "layout(location = 0) in vec4 colour; uniform float tone; out vec4 pixel;\n"
                    "void main() { pixel = vec4(colour.xy, tone, 1.0); }\n");
  const GLuint vertex = pipeline.vertex_program;
  const GLuint fragment = pipeline.fragment_program;
  const GLint shift = gl.GetUniformLocation(vertex, "shift");
  const GLint tone = gl.GetUniformLocation(fragment, "tone");
  gl.UseProgram(0);
  upload(two_triangles());
  refine(is_uniform);
  const auto activate = [&](GLuint program) { gl.ActiveShaderProgram(pipeline.name, program); };
  const std::pair<const char*, Draw> changes[] = {
      {"a uniform of the fragment stage", [&] { gl.Uniform1f(tone, 0.3F); }},
      {"a uniform of the vertex stage",
       [&] {
         activate(vertex);
         gl.Uniform1f(shift, 0.25F);
       }},
      {"the uniform of the vertex stage again", [&] { gl.Uniform1f(shift, -0.2F); }},
      {"ProgramUniform1f of the fragment stage", [&] { gl.ProgramUniform1f(fragment, tone, 1); }},
      {"ProgramUniform1f of the vertex stage", [&] { gl.ProgramUniform1f(vertex, shift, 0.1F); }},
      {"a uniform of the fragment stage again",
       [&] {
         activate(fragment);
         gl.Uniform1f(tone, 0.6F);
       }},
      {"a uniform of the vertex stage, activated while no pipeline is bound",
       [&] {
         gl.BindProgramPipeline(0);
         activate(vertex);
         gl.BindProgramPipeline(pipeline.name);
         gl.Uniform1f(shift, -0.3F);
       }},
  };
  activate(fragment);
  const GLuint count = count_generated(draw_all);
  t.expect(count > 2, "the draws are refined");
  for (const auto& [what, change] : changes) {
    change();
    const Picture refined = picture_of(draw_all);
    gl.Disable(GL_ARK);
    t.expect_same_picture(refined, picture_of(draw_all), std::string("after ") + what, 4, 80);
    gl.Enable(GL_ARK);
  }
  for (const auto& [what, change] : changes) expect_change(t, draw_all, change, what);
  t.expect_equal(count_generated(draw_all), count, "triangles at last");
}

constexpr Area again_case{"ark.draw.again."};

}  // namespace

Cases changed_bindings_cases() {
  Cases cases;
  for (const bool is_uniform : {true, false}) {
    const std::string leaf = is_uniform ? ".uniform" : ".tags";
    cases.push_back(again_case(
        "persistent" + leaf, {"10.R.2-1", "11.R.13-1"}, "Repeat a draw, write to its mapped colours, and repeat it.",
        "The earlier colours of the draw.", [is_uniform](Test& t) { check_persistent(t, is_uniform); }, desktop_apis));
    cases.back().is_optional = true;  // buffers that stay mapped
    cases.push_back(again_case("pipeline_stage" + leaf, {"10.R.2-1", "11.R.10-1"},
                               "Repeat a draw of a program pipeline, give the pipeline another vertex or fragment "
                               "stage by UseProgramStages, and repeat it.",
                               "The earlier stage.", [is_uniform](Test& t) { check_pipeline_stages(t, is_uniform); }));
    cases.push_back(
        again_case("pipeline_uniform" + leaf, {"10.R.2-1", "11.R.10-1"},
                   "Repeat a draw of a program pipeline; make either program the active one and set a uniform.",
                   "The earlier value; the uniform of another program.",
                   [is_uniform](Test& t) { check_pipeline_uniforms(t, is_uniform); }));
    cases.push_back(again_case("object" + leaf, {"10.R.1-28", "10.R.2-1"},
                               "Repeat a draw, delete the vertex array object, make one with fewer arrays, and repeat "
                               "the draw with two current values.",
                               "The arrays or tags of the deleted object with the same name; the first current value.",
                               [is_uniform](Test& t) { check_object_again(t, is_uniform); }));
  }
  for (const bool is_indexed : {false, true})
    cases.push_back(again_case(
        std::string("base_instance") + (is_indexed ? ".indexed" : ".arrays"), {"10.R.2-2"},
        "Repeat a draw of one instance, each time with another base instance.",
        "The attributes of the earlier base instance.", [is_indexed](Test& t) { check_base_instance(t, is_indexed); },
        desktop_apis));
  for (const auto& [leaf, mode] : {std::pair<const char*, GLenum>{"strip", GL_TRIANGLE_STRIP},
                                   {"fan", GL_TRIANGLE_FAN},
                                   {"triangles", GL_TRIANGLES}})
    cases.push_back(again_case(
        std::string("convention.") + leaf, {"11.R.3-2", "11.R.6-10"},
        "Repeat a draw with flat outputs, change the provoking vertex convention, and repeat it.",
        "The order of corners, or the flat values, of the earlier convention.",
        [mode = mode](Test& t) { check_convention(t, mode, GL_LINEAR_OUTPUTS_ARK); }, desktop_apis));
  cases.push_back(again_case("interior", {"11.R.5-12", "11.R.5-13"},
                             "Repeat a draw whose depths differ by five, with either interior in turn.",
                             "The earlier interior of the draw.", check_interior));
  cases.push_back(again_case("feedback_instances", {"10.R.2-2"},
                             "Draw instances of captured vertices, and check the picture and the number of triangles.",
                             "One instance; as many instances as there was memory for.", check_feedback_instances,
                             desktop_apis));
  return cases;
}

}  // namespace glark::conformance
