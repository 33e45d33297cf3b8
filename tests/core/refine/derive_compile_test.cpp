// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Hand-written vertex stages of every desktop version. If the driver accepts a stage, it also accepts the derived text,
// in every refinement.
#include <gtest/gtest.h>

#include "tests/core/refine/support/derive_harness.h"

namespace glark::refine::test {
namespace {

struct Stage {
  const char* what;
  Api api;
  std::vector<std::string> sources;
  std::vector<FieldValues> inputs;
};

FieldValues input(const std::string& name, GLenum type, std::size_t words, int array_size = 1, bool is_array = false) {
  const std::vector<float> zeros(words);
  return {name, type, {{zeros, zeros, zeros}}, capture::Role::other, array_size, is_array};
}
const FieldValues vertex = input("gl_Vertex", GL_FLOAT_VEC4, 4);
const FieldValues position = input("position", GL_FLOAT_VEC3, 3);

const std::vector<Stage>& stages() {
  static const std::vector<Stage> all = {
      {"no version, ftransform, every built-in",
       Api::compatibility,
       {"void main() { gl_Position = ftransform(); gl_FrontColor = gl_Color; gl_BackColor = gl_Color; gl_TexCoord[0] = "
        "gl_MultiTexCoord0;\n"
        "  gl_TexCoord[7] = gl_MultiTexCoord7; gl_FogFragCoord = gl_FogCoord; gl_ClipVertex = vec4(gl_Normal, 1.0); }"},
       {vertex, input("gl_Color", GL_FLOAT_VEC4, 4), input("gl_MultiTexCoord0", GL_FLOAT_VEC4, 4),
        input("gl_FogCoord", GL_FLOAT, 1), input("gl_Normal", GL_FLOAT_VEC3, 3)}},
      {"void main(void) and comments that speak of attributes",
       Api::compatibility,
       {"/* attribute vec3 no; */ // attribute vec4 never; void main() {}\n#version 110 // old\n// #define attribute\n"
        "attribute /* in */ vec3 position; // attribute\nvoid main ( void ) /* main */\n{ gl_Position = vec4 ( "
        "position , 1.0 ) ; }\n"},
       {position}},
      {"macros hide attribute and main",
       Api::compatibility,
       {"#version 120\n#define ATTRIBUTE attribute\n#define DECLARE(type, name) ATTRIBUTE type name\n#define ENTRY(x) "
        "void x##n()\n#define NEGATIVE -1.0\n"
        "DECLARE(vec3, position);\nENTRY(mai) { gl_Position = vec4(position, - NEGATIVE); }\n"},
       {position}},
      {"lists, matrices and arrays",
       Api::compatibility,
       {"#version 150 compatibility\nattribute vec3 position, unused, other; attribute mat2 m; attribute vec2 a[2]; "
        "invariant varying vec4 c;\n"
        "void main() { gl_Position = vec4(m * position.xy, other.x, a[1].x); c = vec4(a[0], a[1]); }"},
       {position, input("other", GL_FLOAT_VEC3, 3), input("m", GL_FLOAT_MAT2, 4),
        input("a", GL_FLOAT_VEC2, 4, 2, true)}},
      {"arrays in GLSL 1.10",
       Api::compatibility,
       {"#version 110\nattribute vec3 position; varying vec2 v[20]; void main() { for (int i = 0; i < 20; ++i) v[i] = "
        "position.xy; gl_Position = vec4(1.0); }"},
       {position}},
      {"integers, gl_VertexID",
       Api::compatibility,
       {"#version 130\nin ivec3 i; in uvec2 n; in vec3 position; flat out ivec3 o; void main() { o = i + ivec3(n.x) + "
        "gl_VertexID; gl_Position = vec4(position, 1); }"},
       {position, input("i", GL_INT_VEC3, 3), input("n", GL_UNSIGNED_INT_VEC2, 2), input("gl_VertexID", GL_INT, 1)}},
      {"150 compatibility, extension lines",
       Api::compatibility,
       {"#version 150 compatibility\n#extension GL_ARB_explicit_attrib_location : require\n#extension "
        "GL_ARB_draw_instanced : enable\n"
        "layout(location = 3) in vec3 position; noperspective centroid out vec3 c;\n"
        "void main() { c = position; gl_Position = gl_ModelViewProjectionMatrix * (gl_Vertex + "
        "float(gl_InstanceIDARB)); }"},
       {vertex, position, input("gl_InstanceID", GL_INT, 1)}},
      {"extension macros of the driver",
       Api::compatibility,
       {"#version 120\n#ifdef GL_EXT_gpu_shader4\n#extension GL_EXT_gpu_shader4 : enable\nflat varying int "
        "f;\n#endif\nattribute vec3 position;\n"
        "void main() {\n#ifdef GL_EXT_gpu_shader4\n  f = gl_VertexID;\n#endif\n  gl_Position = vec4(position, 1.0); }"},
       {position, input("gl_VertexID", GL_INT, 1)}},
      {"330 with blocks and initialised globals",
       Api::core,
       {"#version 330 core\nlayout(location=0) in vec3 position; const int n = 2; float g = 1.0, h[2] = float[2](1.0, "
        "2.0);\n"
        "out Block { vec3 a[n]; flat int k; } block; layout(std140) uniform U { mat4 m; }; uniform struct { vec4 x; } "
        "s;\n"
        "void main() { block.a[0] = position; block.a[1] = s.x.xyz * h[1]; block.k = 1; g += 1.0; gl_Position = m * "
        "vec4(position, g); }"},
       {position}},
      {"400 with precise and subroutines",
       Api::core,
       {"#version 400\nin vec3 position; subroutine vec4 Place(vec3 p); subroutine uniform Place place;\n"
        "subroutine(Place) vec4 plain(vec3 p) { return vec4(p, 1.0); } void main() { precise vec4 p = place(position); "
        "gl_Position = p; }"},
       {position}},
      {"450, everything qualified",
       Api::core,
       {"#version 450 core\n#pragma optimize(on)\nlayout(location = 0) in highp vec3 position; layout(location = 2, "
        "component = 1) out float c; out gl_PerVertex { vec4 gl_Position; };\n"
        "layout(binding = 1, std430) readonly buffer B { vec4 data[]; }; layout(location = 4) uniform float t = 2.0; "
        "vec2[2] pair = {{1, 2}, {3, 4}};\n"
        "void main() { c = t; gl_Position = vec4(position, pair[1].y) + data[gl_VertexID]; }"},
       {position, input("gl_VertexID", GL_INT, 1)}},
      {"draw parameters",
       Api::core,
       {"#version 450 core\n#extension GL_ARB_shader_draw_parameters : enable\nin vec3 position; void main() { "
        "gl_Position = vec4(position, float(gl_BaseVertexARB + gl_DrawIDARB + gl_BaseInstanceARB)); }"},
       {position, input("gl_BaseVertex", GL_INT, 1)}},
      {"names that collide with ours",
       Api::core,
       {"#version 330 core\nin vec3 glark_chunk0; in vec3 glark_main; uniform float glark_weights; float glark_patch = "
        "1.0; out vec3 glark_lattice1;\n"
        "vec3 glark_mix(vec3 a, vec3 b, vec3 c) { return a; } void glark_place() {} vec3 refine() { return "
        "vec3(glark_patch); }\n"
        "void main() { glark_lattice1 = glark_mix(glark_main, glark_chunk0, refine()) * glark_weights; gl_Position = "
        "vec4(glark_chunk0, 1.0); }"},
       {input("glark_chunk0", GL_FLOAT_VEC3, 3), input("glark_main", GL_FLOAT_VEC3, 3)}},
      {"precise and sample as names",
       Api::core,
       {"#version 150\nin vec3 position; out vec3 o; void main() { vec3 sample = position; float precise = 2.0; o = "
        "sample * precise; gl_Position = vec4(o, 1.0); }"},
       {position}},
      {"several sources",
       Api::compatibility,
       {"#version 120\nattribute vec3 position; vec4 place(); void main() { gl_Position = place(); gl_FrontColor = "
        "gl_Color; }",
        "#version 120\nattribute vec3 position; attribute vec3 side; varying vec4 v; vec4 place() { v = gl_Color; "
        "return gl_ModelViewMatrix * vec4(position + side, 1.0); }"},
       {position, input("side", GL_FLOAT_VEC3, 3), input("gl_Color", GL_FLOAT_VEC4, 4)}},
      {"line directives and continuations",
       Api::compatibility,
       {"#version 330 compatibility\n#line 100 3\n#define LONG \\\n  in vec3 \\\n  position;\nLONG\nvoid main() { "
        "gl_Position = vec4(position, 1.0); }\n"},
       {position}},
  };
  return all;
}

std::vector<std::string> extensions_of_context() {
  const auto get_string = reinterpret_cast<const GLubyte* (*)(GLenum, GLuint)>(get_proc("glGetStringi"));
  const auto get_integer = reinterpret_cast<void (*)(GLenum, GLint*)>(get_proc("glGetIntegerv"));
  GLint count = 0;
  get_integer(GL_NUM_EXTENSIONS, &count);
  std::vector<std::string> names;
  for (GLint i = 0; i < count; ++i) names.emplace_back(reinterpret_cast<const char*>(get_string(GL_EXTENSIONS, i)));
  return names;
}

class DeriveCompile : public testing::TestWithParam<Stage> {};

TEST_P(DeriveCompile, InEveryRefinement) {
  const Stage& stage = GetParam();
  ASSERT_TRUE(make_current(stage.api));
  ASSERT_EQ(link_error(stage.sources), "") << "the test's own shader is wrong";
  const std::vector<std::string> extensions = extensions_of_context();
  const Inspection inspection = inspect_vertex_stage(stage.sources, false, extensions);
  EXPECT_TRUE(inspection.ok) << inspection.error;
  std::vector<FieldValues> inputs = stage.inputs;
  for (FieldValues& values : inputs) {
    if (values.name == "position" || values.name == "gl_Vertex") values.role = capture::Role::position;
    if (values.name == "gl_Normal" || values.name == "side" || values.name == "other")
      values.role = capture::Role::normal;
  }
  for (const auto refinement :
       {core::Refinement::linear_inputs, core::Refinement::linear_outputs, core::Refinement::pn}) {
    for (const bool flat_colors : {false, true}) {
      DeriveRequest request;
      request.vertex_sources = stage.sources;
      request.layout = make_record(inputs).layout;
      request.refinement = refinement;
      request.outputs.flat_colors = flat_colors;
      request.extensions = extensions;
      const Derivation derivation = derive_vertex_stage(request);
      ASSERT_TRUE(derivation.ok) << derivation.error;
      EXPECT_EQ(derivation.vertex_sources.size(), stage.sources.size());
      EXPECT_EQ(link_error(derivation.vertex_sources), "");
    }
  }
}

std::string name_of(const testing::TestParamInfo<Stage>& info) {
  std::string name;
  for (const char c : std::string(info.param.what)) name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return name;
}
INSTANTIATE_TEST_SUITE_P(Stages, DeriveCompile, testing::ValuesIn(stages()), name_of);

// Mesa gives `precise` to every version through ARB_gpu_shader5: the derived text relies on it.
TEST(DeriveCompile, PreciseIsAKeywordInEveryVersion) {
  ASSERT_TRUE(make_current(Api::compatibility));
  for (const std::string version : {"110", "120", "130", "140", "150", "330"}) {
    const std::string head =
        "#version " + version +
        "\n#ifndef GL_ARB_gpu_shader5\n#error no gpu_shader5\n#endif\n#extension GL_ARB_gpu_shader5 : require\n";
    EXPECT_EQ(link_error({head + "void main() { precise vec4 p = vec4(1.0); gl_Position = p; }"}), "");
  }
}

TEST(DeriveCompile, AShaderOfOneMegabyte) {
  ASSERT_TRUE(make_current(Api::core));
  std::string source = "#version 330 core\nin vec3 position;\n";
  for (int i = 0; source.size() < (1U << 20); ++i) {
    source += "float f" + std::to_string(i) + "(float x) { return x * " + std::to_string(i) +
              ".0 + 1.0; } // attribute in out main\n";
  }
  source += "void main() { gl_Position = vec4(position, f0(1.0)); }\n";
  DeriveRequest request;
  request.vertex_sources = {source};
  request.layout = make_record({position}).layout;
  const Derivation derivation = derive_vertex_stage(request);
  ASSERT_TRUE(derivation.ok) << derivation.error;
  EXPECT_TRUE(link_error(derivation.vertex_sources).empty());
}

}  // namespace
}  // namespace glark::refine::test
