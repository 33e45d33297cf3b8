// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Resources that the vertex stage of a refined draw reads (11.R.10): uniforms, blocks, textures, fixed-function state.
#include <algorithm>
#include <set>
#include <utility>

#include "conformance/cases/cases.h"
#include "conformance/cases/programs/recorded_value.h"
#include "conformance/support/refined_draw.h"

namespace glark::conformance {
namespace {

// A resource from which the vertex stage takes its colour. The captured colour of every refined vertex shows whether it
// was read.
struct Resource {
  const char* name;
  const char* declarations;
  const char* value;  // a vec4: (0.25, 0.5, 0.75, 1)
  void (*bind)(GLuint program);
};

GLuint buffer_of(GLenum target, GLuint index) {
  const GLfloat values[8] = {9, 9, 9, 9, 0.25F, 0.5F, 0.75F, 1};
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBufferBase(target, index, buffer);
  gl.BufferData(target, sizeof(values), values, GL_STATIC_DRAW);
  return buffer;
}

void bind_uniform(GLuint program) { gl.Uniform4f(gl.GetUniformLocation(program, "u"), 0.25F, 0.5F, 0.75F, 1); }

void bind_array(GLuint program) {
  const GLfloat values[8] = {9, 9, 9, 9, 0.25F, 0.5F, 0.75F, 1};
  gl.Uniform4fv(gl.GetUniformLocation(program, "u"), 2, values);
}

void bind_block(GLuint program) {
  gl.UniformBlockBinding(program, gl.GetUniformBlockIndex(program, "Block"), 3);
  buffer_of(GL_UNIFORM_BUFFER, 3);
}

void bind_storage(GLuint) { buffer_of(GL_SHADER_STORAGE_BUFFER, 2); }

void bind_texture(GLuint program) {
  GLuint texture = 0;
  gl.ActiveTexture(GL_TEXTURE3);
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  const GLfloat texels[4] = {0.25F, 0.5F, 0.75F, 1};
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, 1, 1, 0, GL_RGBA, GL_FLOAT, texels);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.ActiveTexture(GL_TEXTURE0);
  gl.Uniform1i(gl.GetUniformLocation(program, "image"), 3);
}

constexpr Resource resources[] = {
    {"uniform", "uniform vec4 u;", "u", bind_uniform},
    {"uniform_array", "uniform vec4 u[2];", "u[1]", bind_array},
    {"uniform_block", "layout(std140) uniform Block { vec4 first; vec4 second; };", "second", bind_block},
    {"storage_block", "layout(std430, binding = 2) buffer Store { vec4 first; vec4 second; };", "second", bind_storage},
    {"texture", "uniform sampler2D image;", "textureLod(image, vec2(0.5), 0.0)", bind_texture}};

void check_resource(Test& t, const Resource& resource, GLenum refinement) {
  GLint blocks = 1;
  if (resource.bind == bind_storage) gl.GetIntegerv(GL_MAX_VERTEX_SHADER_STORAGE_BLOCKS, &blocks);
  if (blocks < 1) t.not_supported("no storage blocks in vertex stages");
  const GLuint program = record_program(t, resource.declarations, resource.value);
  gl.UseProgram(program);
  resource.bind(program);
  upload(one_triangle());
  refine_uniformly(2, refinement);
  const auto records = capture_as<RecordedVertex>(t, 1000, draw_one);
  t.expect_equal(records.size(), 48U, "refined vertices");
  for (const RecordedVertex& record : records)
    if (record[4] != 0.25F || record[5] != 0.5F || record[6] != 0.75F || record[7] != 1)
      return t.fail("the value read is " + as_text(record[4]) + " " + as_text(record[5]) + " " + as_text(record[6]));
}

// The draw after a change of the resource reads the new value.
void check_changed_uniform(Test& t) {
  const GLuint program = record_program(t, "uniform vec4 u;", "u");
  gl.UseProgram(program);
  upload(one_triangle());
  refine_uniformly(1);
  const GLint at = gl.GetUniformLocation(program, "u");
  for (const float value : {1.0F, 3.0F, -2.0F}) {
    if (value < 0)
      gl.ProgramUniform4f(program, at, value, 0, 0, 0);
    else
      gl.Uniform4f(at, value, 0, 0, 0);
    for (const RecordedVertex& record : capture_as<RecordedVertex>(t, 1000, draw_one))
      if (record[4] != value) return t.fail("the uniform is " + as_text(record[4]) + ", not " + as_text(value));
  }
}

// Between draws, the block gets another binding, and a binding gets another buffer.
void check_changed_block(Test& t, const std::string& name) {
  const GLuint program = record_program(t, "layout(std140) uniform " + name + " { vec4 value; };", "value");
  gl.UseProgram(program);
  upload(one_triangle());
  refine_uniformly(1);
  GLuint buffers[3] = {};
  gl.GenBuffers(3, buffers);
  for (GLuint i = 0; i < 3; ++i) {
    const GLfloat value[4] = {static_cast<GLfloat>(i + 1), 0, 0, 1};
    gl.BindBufferBase(GL_UNIFORM_BUFFER, i, buffers[i]);
    gl.BufferData(GL_UNIFORM_BUFFER, sizeof(value), value, GL_STATIC_DRAW);
  }
  const auto expect = [&](float value, const char* what) {
    for (const RecordedVertex& record : capture_as<RecordedVertex>(t, 1000, draw_one))
      if (!t.expect_equal(record[4], value, what)) return;
  };
  expect(1, "the initial binding");
  const GLuint block = gl.GetUniformBlockIndex(program, name.c_str());
  for (const GLuint binding : {2U, 1U, 0U}) {
    gl.UniformBlockBinding(program, block, binding);
    expect(static_cast<float>(binding + 1), "after UniformBlockBinding");
  }
  gl.BindBufferBase(GL_UNIFORM_BUFFER, 0, buffers[2]);
  expect(3, "after BindBufferBase");
}

void check_changed_storage(Test& t, const std::string& name) {
  GLint blocks = 0;
  gl.GetIntegerv(GL_MAX_VERTEX_SHADER_STORAGE_BLOCKS, &blocks);
  if (blocks < 1) t.not_supported("no storage blocks in vertex stages");
  const GLuint program = record_program(t, "layout(std430, binding = 2) buffer " + name + " { vec4 value; };", "value");
  gl.UseProgram(program);
  upload(one_triangle());
  refine_uniformly(1);
  GLuint buffers[4] = {};
  gl.GenBuffers(4, buffers);
  for (GLuint i = 0; i < 4; ++i) {
    const GLfloat value[4] = {static_cast<GLfloat>(i + 1), 0, 0, 1};
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, i, buffers[i]);
    gl.BufferData(GL_SHADER_STORAGE_BUFFER, sizeof(value), value, GL_STATIC_DRAW);
  }
  for (const GLuint binding : {2U, 1U, 3U, 0U}) {
    if (binding != 2) gl.ShaderStorageBlockBinding(program, 0, binding);
    for (const RecordedVertex& record : capture_as<RecordedVertex>(t, 1000, draw_one))
      if (!t.expect_equal(record[4], static_cast<float>(binding + 1), "after ShaderStorageBlockBinding")) return;
  }
}

void lit_triangle() {
  clear_surface();
  gl.Begin(GL_TRIANGLES);
  for (const MeshVertex& vertex : one_triangle()) {
    gl.Color4f(0.2F + 0.5F * vertex.colour[0], 0.9F - 0.6F * vertex.colour[1], 0.3F, 1);
    gl.SecondaryColor3f(0.1F, 0.3F * vertex.colour[2], 0.5F);
    gl.Normal3f(vertex.position[0], 2 * vertex.position[1], 3);
    gl.TexCoord2f(vertex.position[0], vertex.position[1]);
    gl.FogCoordf(0.7F);
    gl.Vertex4f(vertex.position[0], vertex.position[1], 0.4F, 1);
  }
  gl.End();
}

// Enables and disables a capability between refined draws. Each draw gives the same picture as the unrefined one.
void check_changed_capability(Test& t, const std::vector<GLenum>& before, GLenum capability) {
  const GLfloat colour[] = {0.1F, 0.8F, 0.6F, 1};
  const GLfloat position[] = {0.2F, 0.4F, 1, 0};
  gl.Fogfv(GL_FOG_COLOR, colour);
  gl.Lightfv(GL_LIGHT0, GL_POSITION, position);
  gl.Fogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
  for (const GLenum each : before) gl.Enable(each);
  const auto picture = [&](bool is_enabled, bool is_refined) {
    (is_enabled ? gl.Enable : gl.Disable)(capability);
    (is_refined ? gl.Enable : gl.Disable)(GL_ARK);
    lit_triangle();
    return read_picture(surface_size, surface_size);
  };
  refine_uniformly(2, GL_LINEAR_OUTPUTS_ARK);
  const Picture without = picture(false, false);
  const Picture with = picture(true, false);
  t.expect(count_different(with, without, 8) > 1000, "the capability shows");
  gl.Disable(capability);
  gl.Enable(GL_ARK);
  for (const bool is_enabled : {false, true, false, true}) {
    (is_enabled ? gl.Enable : gl.Disable)(capability);
    lit_triangle();
    t.expect_same_picture(read_picture(surface_size, surface_size), is_enabled ? with : without,
                          is_enabled ? "enabled" : "disabled", 3, 40);
  }
}

// The refinement shader of the fixed-function stage moves the triangle, in any state of that stage.
void check_fixed_function_shader(Test& t) {
  const char* const source = "void refine() { gl_Vertex.xyz += vec3(5.0); }";
  refine_uniformly(2);
  gl.RefinementShaderSourceARK(0, 1, &source, nullptr);
  const Picture nothing(surface_size, surface_size);
  const auto expect_moved = [&](const char* what) {
    lit_triangle();
    t.expect_same_picture(read_picture(surface_size, surface_size), nothing, what);
  };
  expect_moved("the initial state");
  for (const GLenum capability : {GL_LIGHTING, GL_FOG, GL_COLOR_SUM, GL_NORMALIZE}) {
    gl.Enable(static_cast<GLenum>(capability));
    expect_moved("with more state enabled");
  }
  gl.Disable(GL_LIGHTING);
  expect_moved("with lighting disabled again");
  gl.RefinementShaderSourceARK(0, 0, nullptr, nullptr);
  lit_triangle();
  t.expect(count_different(read_picture(surface_size, surface_size), nothing, 8) > 1000, "without a refinement shader");
}

void check_program_kept(Test& t) {
  const GLuint program =
      record_program(t, "layout(location = 3) in vec4 c; uniform vec4 u; uniform float v;", "u * v + c");
  const auto properties = [program] {
    std::vector<GLint> all;
    for (const GLenum name : {GL_ACTIVE_UNIFORMS, GL_ACTIVE_ATTRIBUTES, GL_ATTACHED_SHADERS, GL_LINK_STATUS,
                              GL_TRANSFORM_FEEDBACK_VARYINGS, GL_ACTIVE_UNIFORM_BLOCKS, GL_INFO_LOG_LENGTH}) {
      GLint value = -1;
      gl.GetProgramiv(program, name, &value);
      all.push_back(value);
    }
    for (const char* const name : {"u", "v", "ark_barycentric"}) all.push_back(gl.GetUniformLocation(program, name));
    for (const char* const name : {"position", "c"}) all.push_back(gl.GetAttribLocation(program, name));
    return all;
  };
  const auto before = properties();
  gl.UseProgram(program);
  gl.Uniform1f(gl.GetUniformLocation(program, "v"), 0.5F);
  upload(one_triangle({2, 3, 1}));
  refine_by_tags(3);
  draw_one();
  t.expect(properties() == before, "properties and locations are the same as before");
  GLint current = 0;
  gl.GetIntegerv(GL_CURRENT_PROGRAM, &current);
  t.expect_equal(static_cast<GLuint>(current), program, "CURRENT_PROGRAM");
  GLfloat v = 0;
  gl.GetUniformfv(program, gl.GetUniformLocation(program, "v"), &v);
  t.expect_equal(v, 0.5F, "the value of a uniform");
}

void check_fixed_function(Test& t) {
  const auto picture = [] {
    clear_surface();
    gl.MatrixMode(GL_MODELVIEW);
    gl.LoadIdentity();
    gl.Rotatef(30, 0, 0, 1);
    gl.Scalef(0.7F, 0.9F, 1);
    gl.Begin(GL_TRIANGLES);
    for (const MeshVertex& vertex : one_triangle()) {
      gl.Color4f(vertex.colour[0], vertex.colour[1], vertex.colour[2], 1);
      gl.Vertex4f(vertex.position[0], vertex.position[1], 0, 1);
    }
    gl.End();
    gl.LoadIdentity();
    return read_picture(surface_size, surface_size);
  };
  const Picture plain = picture();
  refine_uniformly(3);
  t.expect_same_picture(picture(), plain, "matrices and colours", 2, 40);
}

constexpr Area stage_case{"ark.stage."};

}  // namespace

Cases vertex_stage_inputs_cases() {
  Cases cases;
  for (const Resource& resource : resources)
    for (const GLenum refinement : {GL_LINEAR_INPUTS_ARK, GL_LINEAR_OUTPUTS_ARK})
      cases.push_back({.name = std::string("ark.stage.reads.") + resource.name +
                               (refinement == GL_LINEAR_INPUTS_ARK ? ".inputs" : ".outputs"),
                       .clauses = {"11.R.10-1"},
                       .plan = "Capture the value that the vertex stage reads.",
                       .wrong = "Zeros; the value of another binding or location.",
                       .is_optional = resource.bind == bind_storage,
                       .check = [&resource, refinement](Test& t) { check_resource(t, resource, refinement); }});
  const auto add = [&](const char* leaf, std::vector<std::string> clauses, const char* plan, const char* wrong,
                       const std::function<void(Test&)>& check,
                       Apis apis) { cases.push_back(stage_case(leaf, std::move(clauses), plan, wrong, check, apis)); };
  add("reads.changed_uniform", {"11.R.10-1"}, "Change a uniform between draws.", "The value of the first draw.",
      check_changed_uniform, every_api);
  add("reads.fixed_function", {"11.R.10-1"}, "Draw with matrices of the fixed-function stage.", "Other matrices.",
      check_fixed_function, compat_only);
  const std::string long_name(300, 'b');
  add(
      "reads.changed_block", {"11.R.10-1"}, "Change the binding of a uniform block, and of a buffer, between draws.",
      "The binding of the first draw.", [](Test& t) { check_changed_block(t, "Block"); }, every_api);
  add(
      "reads.changed_block.long_name", {"11.R.10-1"}, "The same; the block's name has 300 letters.",
      "The binding of the first draw, if the name is cut.", [=](Test& t) { check_changed_block(t, long_name); },
      every_api);
  const auto add_capability = [&](const char* leaf, GLenum capability, const std::vector<GLenum>& before) {
    cases.push_back(
        {.name = std::string("ark.stage.reads.changed_") + leaf,
         .clauses = {"11.R.10-1"},
         .plan = "Enable and disable the capability between refined draws, and compare with unrefined draws.",
         .wrong = "The state of the first draw.",
         .apis = compat_only,
         .check = [=](Test& t) { check_changed_capability(t, before, capability); }});
  };
  add_capability("lighting", GL_LIGHTING, {GL_LIGHT0});
  add_capability("light_0", GL_LIGHT0, {GL_LIGHTING});
  add_capability("normalize", GL_NORMALIZE, {GL_LIGHTING, GL_LIGHT0});
  add_capability("fog", GL_FOG, {});
  add_capability("color_sum", GL_COLOR_SUM, {});
  add(
      "reads.changed_storage_block", {"11.R.10-1"}, "Change the binding of a storage block between draws.",
      "The binding of the first draw.", [](Test& t) { check_changed_storage(t, "Store"); }, desktop_apis);
  cases.back().is_optional = true;  // storage blocks in vertex stages
  add(
      "reads.changed_storage_block.long_name", {"11.R.10-1"}, "The same; the block's name has 300 letters.",
      "The binding of the first draw, if the name is cut.", [=](Test& t) { check_changed_storage(t, long_name); },
      desktop_apis);
  cases.back().is_optional = true;
  add("refinement_shader_of_fixed_function", {"11.R.9-4"},
      "A refinement shader of program 0 moves the triangle out of sight, in several states of the fixed-function "
      "stage.",
      "The shader is lost when state changes.", check_fixed_function_shader, compat_only);
  add("program_kept", {"11.R.10-2"}, "Query the program before and after a refined draw.",
      "More uniforms; another current program; locations that moved.", check_program_kept, every_api);
  return cases;
}

}  // namespace glark::conformance
