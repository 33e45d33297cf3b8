// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A program is refined in many ways, and an implementation may execute another program for each. A uniform, or the binding
// of a block, that is set once holds for all of them (11.R.10).
#include <fmt/core.h>
#include <array>
#include <string>
#include <vector>

#include "conformance/cases/cases.h"
#include "conformance/cases/programs/refinement_source.h"
#include "conformance/support/capture.h"

namespace glark::conformance {
namespace {

struct Variant {
  const char* leaf;
  void (*choose)();
};

void choose_variant(GLenum refinement, GLenum source, GLint morphs = GL_FALSE, GLint welds = GL_FALSE) {
  gl.ARKParameteriARK(GL_REFINEMENT_ARK, static_cast<GLint>(refinement));
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, static_cast<GLint>(source));
  gl.ARKParameteriARK(GL_GEOMORPH_ARK, morphs);
  gl.ARKParameteriARK(GL_WELD_ARK, welds);
}

constexpr Variant variants[] = {
    {"uniform depth", [] { choose_variant(GL_LINEAR_INPUTS_ARK, GL_UNIFORM_DEPTH_ARK); }},
    {"tags", [] { choose_variant(GL_LINEAR_INPUTS_ARK, GL_DEPTH_TAG_ARK); }},
    {"outputs", [] { choose_variant(GL_LINEAR_OUTPUTS_ARK, GL_UNIFORM_DEPTH_ARK); }},
    {"outputs by tags", [] { choose_variant(GL_LINEAR_OUTPUTS_ARK, GL_DEPTH_TAG_ARK); }},
    {"curved", [] { choose_variant(GL_CURVED_PN_ARK, GL_UNIFORM_DEPTH_ARK); }},
    {"tagged", [] { choose_variant(GL_SCALAR_TAGGED_PN_ARK, GL_DEPTH_TAG_ARK); }},
    {"phong", [] { choose_variant(GL_PHONG_ARK, GL_DEPTH_TAG_ARK); }},
    {"measured", [] { choose_variant(GL_LINEAR_INPUTS_ARK, GL_MEASURED_DEPTH_ARK); }},
    {"morphed", [] { choose_variant(GL_LINEAR_INPUTS_ARK, GL_DEPTH_TAG_ARK, GL_TRUE); }},
    {"welded", [] { choose_variant(GL_CURVED_PN_ARK, GL_DEPTH_TAG_ARK, GL_FALSE, GL_TRUE); }},
    {"unrefined", [] { gl.Disable(GL_ARK); }},
};

struct VariantSetting {
  const char* leaf;
  const char* declared;
  const char* value;                         // a float of the vertex stage
  void (*set)(GLuint program, GLint value);  // 1, 2 or 3; the value follows
  Apis apis = every_api;
  bool has_refinement_shader = false;
};

GLint place_of(GLuint program, const char* name) { return gl.GetUniformLocation(program, name); }

const VariantSetting variant_settings[] = {
    {"uniform_block_binding", "layout(std140) uniform Block { vec4 number; };", "number.x",
     [](GLuint program, GLint value) {
       gl.UniformBlockBinding(program, gl.GetUniformBlockIndex(program, "Block"), static_cast<GLuint>(value));
     }},
    {"uniform_block_array", "layout(std140) uniform Block { vec4 number; } blocks[2];", "blocks[1].number.x",
     [](GLuint program, GLint value) {
       gl.UniformBlockBinding(program, gl.GetUniformBlockIndex(program, "Block[1]"), static_cast<GLuint>(value));
     },
     desktop_apis},
    {"storage_block_binding", "layout(std430) readonly buffer Store { vec4 number; };", "number.x",
     [](GLuint program, GLint value) {
       const GLuint block = gl.GetProgramResourceIndex(program, GL_SHADER_STORAGE_BLOCK, "Store");
       gl.ShaderStorageBlockBinding(program, block, static_cast<GLuint>(value));
     },
     desktop_apis},
    {"uniform", "uniform float number;", "number",
     [](GLuint program, GLint value) { gl.Uniform1f(place_of(program, "number"), static_cast<GLfloat>(value)); }},
    {"uniform_integer", "uniform uvec2 number;", "float(number.y)",
     [](GLuint program, GLint value) { gl.Uniform2ui(place_of(program, "number"), 9, static_cast<GLuint>(value)); }},
    {"program_uniform", "uniform vec3 number;", "number.z",
     [](GLuint program, GLint value) {
       gl.ProgramUniform3f(program, place_of(program, "number"), 7, 8, static_cast<GLfloat>(value));
     }},
    {"matrix", "uniform mat2x3 number;", "number[1].z",
     [](GLuint program, GLint value) {
       const GLfloat matrix[6] = {5, 6, 7, 8, 9, static_cast<GLfloat>(value)};
       gl.UniformMatrix2x3fv(place_of(program, "number"), 1, GL_FALSE, matrix);
     }},
    {"element", "uniform float number[3];", "number[2]",
     [](GLuint program, GLint value) { gl.Uniform1f(place_of(program, "number[2]"), static_cast<GLfloat>(value)); }},
    {"member", "struct Pair { float a; float b; }; uniform Pair number;", "number.b",
     [](GLuint program, GLint value) {
       gl.ProgramUniform1f(program, place_of(program, "number.b"), static_cast<GLfloat>(value));
     }},
    {"sampler", "uniform sampler2D number;", "255.0 * textureLod(number, vec2(0.5), 0.0).x",
     [](GLuint program, GLint value) { gl.Uniform1i(place_of(program, "number"), value); }},
    {"of_refinement_shader", "float number = 0.0;", "position.w",
     [](GLuint program, GLint value) { gl.Uniform1f(place_of(program, "own"), static_cast<GLfloat>(value)); },
     every_api, true},
};

// Bindings and units 1 to 3 have buffers and textures whose values are their numbers.
void prepare_bindings(Test& t) {
  std::array<GLuint, 3> buffers{};
  std::array<GLuint, 3> textures{};
  gl.GenBuffers(3, buffers.data());
  gl.GenTextures(3, textures.data());
  for (GLuint i = 0; i < 3; ++i) {
    const auto value = static_cast<GLfloat>(i + 1);
    const std::array<GLfloat, 4> words = {value, 0, 0, 0};
    gl.BindBuffer(GL_UNIFORM_BUFFER, buffers[i]);
    gl.BufferData(GL_UNIFORM_BUFFER, sizeof(words), words.data(), GL_STATIC_DRAW);
    gl.BindBufferBase(GL_UNIFORM_BUFFER, i + 1, buffers[i]);
    if (!t.is_gles()) gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, i + 1, buffers[i]);
    const std::array<GLubyte, 4> texel = {static_cast<GLubyte>(i + 1), 0, 0, 0};
    gl.ActiveTexture(GL_TEXTURE1 + i);
    gl.BindTexture(GL_TEXTURE_2D, textures[i]);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel.data());
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  }
  gl.ActiveTexture(GL_TEXTURE0);
}

struct VariantVertex {
  Vec4 position;
  float value;
};

GLuint variant_program(Test& t, const VariantSetting& setting) {
  return build_program(t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 1) in vec3 normal;\n" +
                                     std::string(setting.declared) +
                                     "\nout float value; out vec4 colour;\n"
                                     "void main() { value = " +
                                     setting.value + "; colour = vec4(normal, 1.0); gl_Position = position; }\n",
                           .captured = {"gl_Position", "value"}});
}

void expect_values(Test& t, const Variant& variant, GLint value, const std::string& what) {
  gl.Enable(GL_ARK);
  variant.choose();
  const bool is_refined = gl.IsEnabled(GL_ARK) != GL_FALSE;
  const auto vertices = capture_as<VariantVertex>(t, 1000, [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); });
  const std::string of_variant = fmt::format("{}, {}", variant.leaf, what);
  t.expect_equal(vertices.size() > 3, is_refined, of_variant + ": refined");
  for (const VariantVertex& vertex : vertices)
    if (!t.expect_near(vertex.value, value, 1e-3, of_variant)) return;
}

GLuint set_up_variants(Test& t, const VariantSetting& setting) {
  prepare_bindings(t);
  upload(one_triangle({1, 2, 1}));
  refine_by_tags(2);
  gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 1);
  const GLuint program = variant_program(t, setting);
  gl.UseProgram(program);
  if (setting.has_refinement_shader)
    set_refinement_shader(t, program, "uniform float own; void refine() { position.w = own; }");
  return program;
}

// An unrefined draw executes no refinement shader.
bool concerns(const VariantSetting& setting, const Variant& variant) {
  return !setting.has_refinement_shader || std::string(variant.leaf) != "unrefined";
}

// Each step sets the value, then refines in one more way and in all ways of before. Then all ways exist, and the value
// changes between rounds.
void check_variants(Test& t, const VariantSetting& setting) {
  const GLuint program = set_up_variants(t, setting);
  GLint value = 1;
  const auto set_next = [&] {
    value = value % 3 + 1;
    setting.set(program, value);
  };
  for (std::size_t i = 0; i < std::size(variants); ++i) {
    if (!concerns(setting, variants[i])) continue;
    set_next();
    for (std::size_t k = 0; k <= i; ++k) expect_values(t, variants[i - k], value, fmt::format("step {}", i));
  }
  for (int round = 0; round < 2; ++round) {
    set_next();
    for (const Variant& variant : variants)
      if (concerns(setting, variant)) expect_values(t, variant, value, fmt::format("round {}", round));
  }
  t.expect_no_error("the draws");
}

}  // namespace

Cases settings_of_variants_cases() {
  Cases cases;
  for (const VariantSetting& setting : variant_settings)
    cases.push_back({.name = std::string("ark.stage.variants.") + setting.leaf,
                     .clauses = {"11.R.10-1", "11.R.10-2"},
                     .plan = "Refine a program in eleven ways, one more at each step, and set it between the steps.",
                     .wrong = "The setting reaches one of the programs that an implementation executes, not all; or a "
                              "new one begins with the setting of before.",
                     .apis = setting.apis,
                     .check = [&setting](Test& t) { check_variants(t, setting); }});
  return cases;
}

}  // namespace glark::conformance
