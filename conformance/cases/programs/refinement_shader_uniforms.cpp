// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Uniforms, blocks, textures and functions of refinement shaders (11.R.9).
#include <array>
#include <set>

#include "conformance/cases/cases.h"
#include "conformance/support/capture.h"
#include "conformance/support/state.h"

namespace glark::conformance {
namespace {

void control(Test& t) {
  gl.UseProgram(capture_program(t));
  upload(one_triangle(), false);
  t.expect_equal(capture(t, [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); }).size(), 3U, "vertices of the coarse draw");
}

// A program in which refine() writes `weights`, and a triangle at depth 1.
GLuint set_up(Test& t, const std::string& refinement) {
  const GLuint program = capture_program(t);
  gl.UseProgram(program);
  upload(one_triangle(), false);
  refine_uniformly(1);
  set_refinement_shader(t, program, refinement);
  return program;
}

void expect_weights(Test& t, const Vec3& weights, const std::string& what) {
  const auto vertices = capture(t, [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); });
  t.expect_equal(vertices.size(), 12U, what + ": vertices");
  for (const CapturedVertex& vertex : vertices) {
    if (vertex.weights == weights) continue;
    t.fail(what + ": expected (" + as_text(weights[0]) + ", " + as_text(weights[1]) + ", " + as_text(weights[2]) +
           "), got (" + as_text(vertex.weights[0]) + ", " + as_text(vertex.weights[1]) + ", " +
           as_text(vertex.weights[2]) + ")");
    return;
  }
}

GLint locate(Test& t, GLuint program, const char* name) {
  const GLint location = gl.GetUniformLocation(program, name);
  t.expect(location >= 0, std::string(name) + " has a location");
  return location;
}

struct UniformType {
  const char* leaf;
  const char* declaration;  // of the uniform `value`
  const char* use;          // a vec3
  std::function<void(GLint)> set;
  Vec3 expected;
};

const std::vector<UniformType>& types() {
  static const GLfloat numbers[16] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};
  static const std::vector<UniformType> all{
      {"float",
       "uniform float value;",
       "vec3(value, 2.0 * value, 1.0)",
       [](GLint at) { gl.Uniform1f(at, 1.25F); },
       {1.25F, 2.5F, 1}},
      {"vec3", "uniform vec3 value;", "value", [](GLint at) { gl.Uniform3fv(at, 1, numbers + 3); }, {4, 5, 6}},
      {"vec4", "uniform vec4 value;", "value.xyw", [](GLint at) { gl.Uniform4f(at, 3, 1, 4, 1.5F); }, {3, 1, 1.5F}},
      {"int", "uniform int value;", "vec3(value, value / 2, 0)", [](GLint at) { gl.Uniform1i(at, -7); }, {-7, -3, 0}},
      {"uint", "uniform uint value;", "vec3(value >> 1u, 0, 1)", [](GLint at) { gl.Uniform1ui(at, 9); }, {4, 0, 1}},
      {"bool",
       "uniform bool value;",
       "value ? vec3(1, 2, 3) : vec3(0)",
       [](GLint at) { gl.Uniform1i(at, 5); },
       {1, 2, 3}},
      {"mat4",
       "uniform mat4 value;",
       "vec3(value[0][1], value[1].x, value[3][2])",
       [](GLint at) { gl.UniformMatrix4fv(at, 1, GL_FALSE, numbers); },
       {2, 5, 15}},
      {"mat4_transposed",
       "uniform mat4 value;",
       "vec3(value[0][1], value[1].x, value[3][2])",
       [](GLint at) { gl.UniformMatrix4fv(at, 1, GL_TRUE, numbers); },
       {5, 2, 12}},
      {"array",
       "uniform float value[3];",
       "vec3(value[2], value[0], value[1])",
       [](GLint at) { gl.Uniform1fv(at, 3, numbers + 5); },
       {8, 6, 7}},
      {"initially_zero", "uniform vec3 value;", "value + vec3(1.0)", [](GLint) {}, {1, 1, 1}},
  };
  return all;
}

void check_type(Test& t, const UniformType& type) {
  const GLuint program = set_up(t, std::string(type.declaration) + "\nvoid refine() { weights = " + type.use + "; }");
  type.set(locate(t, program, "value"));
  t.expect_no_error("the Uniform command");
  expect_weights(t, type.expected, "the uniform's value");
}

constexpr char two_uniforms[] =
    "uniform float first; uniform float second;\n"
    "void refine() { weights = vec3(first, second, first + second); }";

void check_locations(Test& t) {
  const GLuint program = set_up(t, two_uniforms);
  const GLint first = locate(t, program, "first");
  const GLint second = locate(t, program, "second");
  t.expect(first != second, "two uniforms, two locations");
  t.expect_equal(gl.GetUniformLocation(program, "third"), -1, "the location of an undeclared name");
  gl.Uniform1f(first, 1);
  gl.ProgramUniform1f(program, second, 2);
  expect_weights(t, {1, 2, 3}, "set by Uniform1f and ProgramUniform1f");
  gl.UseProgram(0);
  gl.ProgramUniform1f(program, first, 5);
  gl.UseProgram(program);
  expect_weights(t, {5, 2, 7}, "set while the program is not in use");
  gl.Uniform1f(second, -1);
  expect_weights(t, {5, -1, 4}, "set between two draws");
  t.expect_no_error("the commands");
}

void check_relinked(Test& t) {
  const GLuint program = set_up(t, two_uniforms);
  gl.Uniform1f(locate(t, program, "first"), 3);
  expect_weights(t, {3, 0, 3}, "before LinkProgram");
  gl.LinkProgram(program);
  gl.UseProgram(program);
  GLint built = GL_FALSE;
  gl.GetRefinementivARK(program, GL_REFINEMENT_STATUS_ARK, &built);
  t.expect_equal(built, GLint{GL_TRUE}, "the status after LinkProgram");
  gl.Uniform1f(locate(t, program, "second"), 4);
  gl.Uniform1f(locate(t, program, "first"), 1);
  expect_weights(t, {1, 4, 5}, "after LinkProgram, located again");
  set_refinement_shader(t, program, "uniform float other; void refine() { weights = vec3(other); }");
  gl.Uniform1f(locate(t, program, "other"), 8);
  expect_weights(t, {8, 8, 8}, "of the next refinement shader");
}

// Uniforms, functions and constants of the vertex shader.
GLuint program_with_uniform(Test& t) {
  return build_program(
      t,
      {.vertex = "layout(location = 0) in vec4 position; layout(location = 2) in vec3 weights; out vec3 weights_out;\n"
                 "out float triangle_out; out vec4 colour; uniform float scale;\n"
                 "float twice(float x) { return 2.0 * x; }\n"
                 "void main() { weights_out = weights; triangle_out = scale; colour = vec4(weights, twice(scale));\n"
                 "  gl_Position = position; }\n",
       .captured = {"gl_Position", "weights_out", "triangle_out"}});
}

void check_one_uniform(Test& t) {
  const GLuint program = program_with_uniform(t);
  gl.UseProgram(program);
  upload(one_triangle(), false);
  refine_uniformly(1);
  const GLint before = locate(t, program, "scale");
  gl.Uniform1f(before, 3);
  set_refinement_shader(t, program, "uniform float scale; void refine() { weights = vec3(scale, 1.0, twice(scale)); }");
  t.expect_equal(gl.GetUniformLocation(program, "scale"), before, "the location of the uniform that both declare");
  expect_weights(t, {3, 1, 6}, "the earlier value");
  gl.Uniform1f(before, 5);
  expect_weights(t, {5, 1, 10}, "set for both");
  for (const CapturedVertex& vertex : capture(t, [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); }))
    t.expect_equal(vertex.triangle, 5.0F, "what the vertex stage reads");
}

void check_uses_of_vertex_shader(Test& t) {
  const GLuint program = program_with_uniform(t);
  gl.UseProgram(program);
  upload(one_triangle(), false);
  refine_uniformly(1);
  set_refinement_shader(t, program,
                        "float thrice(float x) { return twice(x) + x; }\n"
                        "void refine() { weights = vec3(scale, twice(scale), thrice(scale)); }");
  gl.Uniform1f(locate(t, program, "scale"), 2);
  expect_weights(t, {2, 4, 6}, "a uniform and a function of the vertex shader, a function of its own");
}

// An implementation may need another program for another source of depths. Elements keep their values there.
void check_array_elements(Test& t) {
  const GLuint program = set_up(t, "uniform float s[3]; void refine() { weights = vec3(s[0], s[1], s[2]); }");
  gl.Uniform1f(locate(t, program, "s[1]"), 2);
  gl.Uniform1f(locate(t, program, "s[2]"), 4);
  gl.Uniform1f(locate(t, program, "s"), 1);
  expect_weights(t, {1, 2, 4}, "elements set one by one");
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_DEPTH_TAG_ARK);
  gl.DepthTag1i(1);
  expect_weights(t, {1, 2, 4}, "with another source of depths");
  const GLfloat values[] = {16, 32};
  gl.Uniform1fv(locate(t, program, "s[1]"), 2, values);
  expect_weights(t, {1, 16, 32}, "two elements at once");
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK);
  gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, 1);
  expect_weights(t, {1, 16, 32}, "with measured depths");
}

// Elements that are set through the location of another one, and members of structures.
void check_whole_arrays(Test& t) {
  const GLuint program =
      set_up(t,
             "struct Pair { float low[2]; float high; }; uniform float s[3]; uniform float z[3]; uniform Pair p[2];\n"
             "void refine() { weights = vec3(s[2] + z[1], p[1].low[1], p[0].high + p[1].high); }");
  const GLfloat values[] = {1, 2, 4}, others[] = {8, 16, 32}, low[] = {64, 128};
  gl.Uniform1fv(locate(t, program, "s"), 3, values);
  gl.Uniform1fv(locate(t, program, "z[0]"), 3, others);
  gl.Uniform1fv(locate(t, program, "p[1].low"), 2, low);
  gl.Uniform1f(locate(t, program, "p[0].high"), 256);
  gl.Uniform1f(locate(t, program, "p[1].high"), 512);
  expect_weights(t, {20, 128, 768}, "arrays and members");
  if (gl.ProvokingVertex != nullptr) gl.ProvokingVertex(GL_FIRST_VERTEX_CONVENTION);  // OpenGL ES has none
  expect_weights(t, {20, 128, 768}, "under the other provoking vertex convention");
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_DEPTH_TAG_ARK);
  gl.DepthTag1i(1);
  expect_weights(t, {20, 128, 768}, "with another source of depths");
}

void check_compiled(Test& t) {
  const GLuint program = set_up(t, two_uniforms);
  const GLint first = locate(t, program, "first"), second = locate(t, program, "second");
  gl.Uniform1f(first, 1);
  gl.Uniform1f(second, 2);
  const GLuint list = gl.GenLists(1);
  for (const GLenum mode : {GL_COMPILE, GL_COMPILE_AND_EXECUTE}) {
    gl.NewList(list, mode);
    const GLfloat value = 7;
    gl.Uniform1fv(first, 1, &value);
    t.expect_error(GL_INVALID_OPERATION, "Uniform1fv of a refinement shader's uniform while a list is compiled");
    gl.ProgramUniform1f(program, second, 7);
    t.expect_error(GL_INVALID_OPERATION, "ProgramUniform1f of such a uniform while a list is compiled");
    gl.EndList();
    gl.CallList(list);
    t.expect_no_error("the list");
    expect_weights(t, {1, 2, 3}, "after the list");
  }
}

std::set<std::string> active_uniforms(GLuint program) {
  GLint count = 0;
  gl.GetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
  std::set<std::string> names;
  for (GLint i = 0; i < count; ++i) {
    char name[100] = "";
    GLint size = 0;
    GLenum type = 0;
    gl.GetActiveUniform(program, static_cast<GLuint>(i), sizeof(name), nullptr, &size, &type, name);
    names.insert(name);
  }
  return names;
}

void check_not_active(Test& t) {
  const GLuint program = program_with_uniform(t);
  const auto before = active_uniforms(program);
  GLint longest_before = 0;
  gl.GetProgramiv(program, GL_ACTIVE_UNIFORM_MAX_LENGTH, &longest_before);
  gl.UseProgram(program);
  upload(one_triangle(), false);
  refine_uniformly(1);
  set_refinement_shader(t, program, "uniform vec3 a_rather_long_name; void refine() { weights = a_rather_long_name; }");
  gl.Uniform3f(locate(t, program, "a_rather_long_name"), 1, 2, 4);
  expect_weights(t, {1, 2, 4}, "the uniform's value");
  GLint longest = 0;
  gl.GetProgramiv(program, GL_ACTIVE_UNIFORM_MAX_LENGTH, &longest);
  t.expect(active_uniforms(program) == before, "the active uniforms are the same as before");
  t.expect_equal(longest, longest_before, "and the length of the longest name");
  GLint resources = 0;
  gl.GetProgramInterfaceiv(program, GL_UNIFORM, GL_ACTIVE_RESOURCES, &resources);
  t.expect_equal(resources, static_cast<GLint>(before.size()), "and the number of resources");
}

void check_block(Test& t) {
  const GLuint program = set_up(t,
                                "layout(std140, binding = 3) uniform Shape { vec4 first; vec3 second; };\n"
                                "void refine() { weights = first.xyz + second; }");
  const GLfloat values[] = {1, 2, 3, 4, 10, 20, 30, 40};
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBufferBase(GL_UNIFORM_BUFFER, 3, buffer);
  gl.BufferData(GL_UNIFORM_BUFFER, sizeof(values), values, GL_STATIC_DRAW);
  expect_weights(t, {11, 22, 33}, "the block's values");
  const GLfloat other = 100;
  gl.BufferSubData(GL_UNIFORM_BUFFER, 4, sizeof(other), &other);
  expect_weights(t, {11, 120, 33}, "after BufferSubData");
  t.expect(program != 0, "there is a program");
}

GLuint texture_of(const std::array<GLfloat, 4>& texel) {
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, 1, 1, 0, GL_RGBA, GL_FLOAT, texel.data());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  return texture;
}

void check_texture(Test& t) {
  const GLuint program = set_up(
      t,
      "uniform sampler2D height; uniform sampler2D other;\n"
      "void refine() { weights = textureLod(height, weights.xy, 0.0).xyz + textureLod(other, vec2(0.5), 0.0).xxx; }");
  gl.ActiveTexture(GL_TEXTURE2);
  texture_of({1, 2, 3, 4});
  gl.ActiveTexture(GL_TEXTURE5);
  texture_of({10, 0, 0, 0});
  gl.ActiveTexture(GL_TEXTURE0);
  texture_of({100, 100, 100, 100});
  gl.Uniform1i(locate(t, program, "height"), 2);
  gl.Uniform1i(locate(t, program, "other"), 5);
  expect_weights(t, {11, 12, 13}, "texels of units 2 and 5");
  gl.Uniform1i(locate(t, program, "other"), 2);
  expect_weights(t, {2, 3, 4}, "both of unit 2");
  t.expect_no_error("the draws");
}

void check_locations_survive(Test& t) {
  const GLuint program = set_up(t, two_uniforms);
  const GLint first = locate(t, program, "first");
  gl.Uniform1f(first, 1);
  gl.ARKParameteriARK(GL_PATTERN_INTERIOR_ARK, GL_SMOOTH_INTERIOR_ARK);
  gl.ARKParameteriARK(GL_REFINEMENT_ARK, GL_LINEAR_OUTPUTS_ARK);
  gl.ARKinit(2);
  expect_weights(t, {1, 0, 1}, "after other parameters were set");
  gl.Uniform1f(first, 2);
  expect_weights(t, {2, 0, 2}, "set by the earlier location");
  t.expect_equal(gl.GetUniformLocation(program, "first"), first, "the location");
}

// The uniform is set once, under one refinement parameter, and read under all others.
void check_uniform_stays(Test& t) {
  const GLuint program = colour_program(t);
  gl.UseProgram(program);
  upload(one_triangle());
  refine_uniformly(2);
  set_refinement_shader(t, program, "uniform vec4 shift;\nvoid refine() { position.xy += shift.zw; }\n");
  const auto picture = [] { return picture_of([] { gl.DrawArrays(GL_TRIANGLES, 0, 3); }); };
  const Picture unmoved = picture();
  gl.Uniform4f(gl.GetUniformLocation(program, "shift"), 9, 9, 0.25F, -0.125F);
  const Picture moved = picture();
  t.expect(count_different(moved, unmoved, 8) > 500, "the uniform shows");
  struct Parameter {
    GLenum name;
    GLenum value;
  };
  for (const Parameter& parameter :
       {Parameter{GL_DEPTH_SOURCE_ARK, GL_DEPTH_TAG_ARK}, Parameter{GL_REFINEMENT_ARK, GL_CURVED_PN_ARK},
        Parameter{GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK}, Parameter{GL_REFINEMENT_ARK, GL_LINEAR_OUTPUTS_ARK},
        Parameter{GL_GEOMORPH_ARK, GL_TRUE}, Parameter{GL_WELD_ARK, GL_TRUE},
        Parameter{GL_REFINEMENT_ARK, GL_LINEAR_INPUTS_ARK}, Parameter{GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK}}) {
    gl.ARKParameteriARK(parameter.name, static_cast<GLint>(parameter.value));
    t.expect_same_picture(picture(), moved, "with parameter " + as_text(parameter.name), 4, 60);
  }
}

constexpr Area look{"ark.shader.uniform.", control};

}  // namespace

Cases refinement_shader_uniforms_cases() {
  Cases cases{
      look("locations", {"11.R.9-21"},
           "Two uniforms, set by Uniform1f and ProgramUniform1f, while the program is in use and while it is not, and "
           "between draws.",
           "-1; INVALID_OPERATION; the value only counts after the next link.", check_locations),
      look("relinked", {"11.R.9-21", "11.R.9-22", "11.R.9-6"},
           "Link again, build, locate and set; then the same with another refinement shader.",
           "No locations after LinkProgram; locations of the first refinement shader.", check_relinked),
      look("locations_kept", {"11.R.9-22"}, "Change refinement parameters and set a uniform by its old location.",
           "Another refinement program has other locations.", check_locations_survive),
      look("both_declare", {"11.R.9-23", "11.R.9-20"},
           "A uniform of the vertex shader that the refinement shader declares, too: one location, one value.",
           "Two uniforms of the same name; a redeclaration is an error; the earlier value is lost.", check_one_uniform),
      look("vertex_shader", {"11.R.9-20"}, "Use a uniform and a function of the vertex shader without declaring them.",
           "The refinement shader is compiled separately.", check_uses_of_vertex_shader),
      look("array_elements", {"11.R.9-21"}, "Set elements of an array, and change the source of depths in between.",
           "Elements lose their values.", check_array_elements),
      look("whole_arrays", {"11.R.9-21", "11.R.9-22"},
           "Set arrays by one location, and members of structures, and change what needs another refinement program.",
           "Only the first element keeps its value, and no member.", check_whole_arrays),
      look("not_active", {"11.R.9-24"}, "Ask for all active uniforms before and after.",
           "The refinement program's uniforms are counted.", check_not_active),
      look("block", {"11.R.9-20"}, "A uniform block with a binding of its own, and a change of its buffer.",
           "Blocks are not bound for the refinement program.", check_block),
      look("texture", {"11.R.9-20", "11.R.9-21"}, "Two samplers, set to units 2 and 5, then to the same.",
           "Unit 0 for all samplers.", check_texture),
  };
  cases.push_back(Area{.prefix = "ark.shader.uniform.", .apis = compat_only}(
      "compiled", {"11.R.9-44"}, "Set uniforms of the refinement shader while a list is compiled.",
      "The list is silent, and the uniform keeps its value; the list sets a uniform of the program.", check_compiled));
  cases.push_back(
      Area{"ark.shader.uniform."}("stays", {"11.R.9-21", "11.R.9-22"},
                                  "Set a uniform of the refinement shader once, and change every refinement parameter.",
                                  "The uniform is 0 in the programs of other parameters.", check_uniform_stays));
  for (const UniformType& type : types()) {
    cases.push_back(look(std::string("type.") + type.leaf, {"11.R.9-20", "11.R.9-21"},
                         "Set a uniform of this type that the refinement shader declares, and draw.",
                         "Only floats are passed on; a matrix is transposed; only the first element of an array.",
                         [type](Test& t) { check_type(t, type); }));
  }
  return cases;
}

}  // namespace glark::conformance
