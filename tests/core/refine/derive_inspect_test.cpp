// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The traits of a vertex stage, and the errors of malformed ones.
#include <gtest/gtest.h>

#include <thread>

#include "glark/core/refine/derive.h"

namespace glark::refine {
namespace {

VertexStageTraits traits_of(const std::string& source, bool es = false) {
  const Inspection inspection = inspect_vertex_stage({source}, es);
  EXPECT_TRUE(inspection.ok) << inspection.error << "\n" << source;
  return inspection.traits;
}

TEST(DeriveInspect, PlainStageHasNoTraits) {
  const VertexStageTraits traits = traits_of("void main() { gl_Position = gl_Vertex; }");
  EXPECT_FALSE(traits.reads_vertex_id || !traits.system_values.empty() || traits.has_side_effects ||
               traits.writes_flat_outputs);
}

TEST(DeriveInspect, SystemValues) {
  EXPECT_TRUE(traits_of("#version 130\nvoid main() { gl_Position = vec4(gl_VertexID); }").reads_vertex_id);
  EXPECT_FALSE(traits_of("#version 130\nvoid main() { /* gl_VertexID */ gl_Position = vec4(1); }").reads_vertex_id);
  EXPECT_TRUE(traits_of("#version 450\nvoid main() { gl_Position = vec4(gl_InstanceID); }")
                  .system_values.contains("gl_InstanceID"));
  EXPECT_TRUE(traits_of("#version 460\nvoid main() { gl_Position = vec4(gl_BaseVertex); }")
                  .system_values.contains("gl_BaseVertex"));
  EXPECT_TRUE(traits_of("#version 300 es\nvoid main() { gl_Position = vec4(gl_InstanceID); }", true)
                  .system_values.contains("gl_InstanceID"));
}

// Blender finds its object's matrix by gl_BaseInstanceARB in GLSL 4.30.
TEST(DeriveInspect, DrawParametersOfOlderVersions) {
  const VertexStageTraits traits = traits_of(
      "#version 430\n#extension GL_ARB_shader_draw_parameters : enable\nin vec3 position; uniform mat4 matrices[4];\n"
      "void main() { gl_Position = matrices[gl_BaseInstanceARB + gl_InstanceID] * vec4(position, 1.0); }");
  EXPECT_TRUE(traits.system_values.contains("gl_BaseInstance"));
  for (const OutputVariation& output : traits.variation.outputs) EXPECT_NE(output.variation, Variation::undefined);
}

TEST(DeriveInspect, SideEffects) {
  const std::string head =
      "#version 450\nlayout(rgba8, binding = 0) uniform image2D i; layout(binding = 0, offset = 0) uniform atomic_uint "
      "c;\n"
      "layout(binding = 1) buffer B { int n; vec4 v[]; } b; layout(binding = 2) buffer P { int plain; };\nvoid "
      "change(out int x) { x = 1; }\nvoid main() { gl_Position = vec4(1); ";
  for (const char* statement : {"imageStore(i, ivec2(0), vec4(1));", "atomicCounterIncrement(c);", "atomicAdd(b.n, 1);",
                                "b.v[3].x = 1.0;", "plain += 2;", "plain++;", "change(b.n);", "atomicCounter(c);"}) {
    EXPECT_TRUE(traits_of(head + statement + "}").has_side_effects) << statement;
  }
  for (const char* statement :
       {"int k = b.n; k = plain; k++;", "gl_Position = b.v[2];", "imageLoad(i, ivec2(0));", "b.v.length();"}) {
    EXPECT_FALSE(traits_of(head + statement + "}").has_side_effects) << statement;
  }
}

TEST(DeriveInspect, FlatOutputs) {
  EXPECT_TRUE(
      traits_of("#version 130\nflat out vec4 f; void main() { f = vec4(1); gl_Position = f; }").writes_flat_outputs);
  EXPECT_TRUE(traits_of("#version 150\nout B { flat ivec2 f; }; void main() { f = ivec2(1); gl_Position = vec4(1); }")
                  .writes_flat_outputs);
  EXPECT_FALSE(
      traits_of("#version 130\nsmooth out vec4 f; void main() { f = vec4(1); gl_Position = f; }").writes_flat_outputs);
}

TEST(DeriveInspect, ValuesOfTheProvokingVertex) {
  const std::string end = " void main() { gl_Position = vec4(1); }";
  EXPECT_TRUE(traits_of("#version 330\nflat out vec4 f;" + end).copies_provoking_vertex);
  EXPECT_TRUE(traits_of("#version 330\nout int i;" + end).copies_provoking_vertex);
  EXPECT_TRUE(traits_of("#version 330\nstruct S { ivec2 i; }; struct T { vec4 f; S s; }; out T t;" + end)
                  .copies_provoking_vertex);
  EXPECT_FALSE(
      traits_of("#version 330\nstruct S { vec4 f; mat2 m; }; out S s; out vec4 f;" + end).copies_provoking_vertex);
}

TEST(DeriveInspect, ExtensionMacrosAreThoseOfTheContext) {
  const std::string source =
      "#version 130\n#if defined(GL_ARB_shader_draw_parameters)\nvoid main() { gl_Position = vec4(gl_VertexID); "
      "}\n#else\nvoid main() { gl_Position = vec4(1); }\n#endif\n";
  EXPECT_TRUE(inspect_vertex_stage({source}, false, {"GL_ARB_shader_draw_parameters"}).traits.reads_vertex_id);
  EXPECT_FALSE(inspect_vertex_stage({source}, false, {"GL_ARB_other"}).traits.reads_vertex_id);
  const std::string unknown =
      "#version 130\n#ifdef GL_MESA_only\nvoid main() { gl_Position = vec4(gl_VertexID); }\n#endif\n";
  EXPECT_TRUE(inspect_vertex_stage({unknown}, false, {"GL_MESA_only"}).traits.reads_vertex_id);
}

TEST(DeriveInspect, ShadersOfExtensionsUnknownToTheFrontEndAreReadByTheirTokens) {
  const Inspection inspection =
      inspect_vertex_stage({"#version 120\n#extension GL_EXT_gpu_shader4 : require\nflat varying ivec2 f; void main() "
                            "{ f = ivec2(gl_VertexID); gl_Position = vec4(1.0); }"},
                           false);
  EXPECT_TRUE(inspection.ok) << inspection.error;
  EXPECT_TRUE(inspection.traits.reads_vertex_id && inspection.traits.writes_flat_outputs);
}

struct Malformed {
  const char* source;
  const char* expected;  // part of the error
};
TEST(DeriveInspect, MalformedStagesGiveAnErrorThatNamesTheLine) {
  for (const Malformed& m : {Malformed{"void main() {\n gl_Position = vec4(1.0);", "1"},
                             {"attribute vec3 a\nvoid main() { }", "2"},
                             {"\n\nvoid main() { gl_Position = nothing; }", ":3"},
                             {"#version 150\n#if\nvoid main() {}\n", ""},
                             {"", "main"},
                             {"void other() {}", "main"},
                             {")", "1"},
                             {"void main() } {", "1"},
                             {"#version 999\nvoid main() {}", ""},
                             {"in", ""},
                             {"layout(", ""},
                             {"struct { ", ""},
                             {"varying vec4 v[", ""},
                             {"float x =", ""},
                             {"\\", ""},
                             {"/* open", ""},
                             {"#version", ""},
                             {"#", ""},
                             {"#define", ""},
                             {"void main(", ""},
                             {"\x80\xff\x01", ""},
                             {"out B { vec4", ""}}) {
    const Inspection inspection = inspect_vertex_stage({m.source}, false);
    EXPECT_FALSE(inspection.ok) << m.source;
    EXPECT_NE(inspection.error.find(m.expected), std::string::npos) << m.source << ": " << inspection.error;
    EXPECT_FALSE(inspection.error.empty());
    DeriveRequest request;
    request.vertex_sources = {m.source};
    derive_vertex_stage(request);  // must not crash; the driver judges the result
  }
  EXPECT_FALSE(inspect_vertex_stage({}, false).ok);
}

TEST(DeriveInspect, EveryPrefixOfAShaderIsSurvived) {
  const std::string source =
      "#version 330\nlayout(location = 0) in vec3 a, b[2]; struct S { vec2 x[2]; }; out B { flat int k; S s; } "
      "block[2];\n"
      "float g = (1.0 + 2.0); subroutine void T(); void main(void) { gl_Position = vec4(a, 1.0); block[0].k = 1; }";
  for (std::size_t length = 0; length < source.size(); ++length) {
    DeriveRequest request;
    request.vertex_sources = {source.substr(0, length)};
    request.refinement = core::Refinement::linear_outputs;
    EXPECT_FALSE(derive_vertex_stage(request).ok) << request.vertex_sources[0];
  }
}

TEST(DeriveInspect, ManyThreads) {
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i) {
    threads.emplace_back([i] {
      const std::string version = i % 2 == 0 ? "#version 450\nin" : "#version 120\nattribute";
      for (int round = 0; round < 5; ++round) {
        EXPECT_TRUE(inspect_vertex_stage({version + " vec4 a; void main() { gl_Position = a; }"}, false).ok);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
}

}  // namespace
}  // namespace glark::refine
