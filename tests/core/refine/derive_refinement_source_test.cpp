// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The application's own refinement shader.
#include <gtest/gtest.h>

#include "glark/core/refine/refinement_log.h"
#include "tests/core/refine/support/derive_harness.h"

namespace glark::refine::test {
namespace {

Experiment experiment(const std::string& refinement_source) {
  Experiment e;
  e.request.vertex_sources = {
      "#version 120\nattribute vec2 extra[2]; varying vec4 o; void main() { gl_Position = gl_Vertex; o = "
      "vec4(extra[0], extra[1]); }"};
  e.request.refinement_source = refinement_source;
  e.record = make_record(
      {{"gl_Vertex", GL_FLOAT_VEC4, {{{0, 0, 0, 1}, {8, 0, 2, 1}, {0, 16, 4, 1}}}},
       {"extra", GL_FLOAT_VEC2, {{{1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10, 11, 12}}}, capture::Role::other, 2, true}});
  e.varyings = {"gl_Position", "o"};
  e.captured_words = 8;
  return e;
}

TEST(DeriveRefinementSource, SeesTheBuiltInRefinementAndChangesInputs) {
  ASSERT_TRUE(make_current(Api::compatibility));
  const Refined refined = run(experiment("void refine() { gl_Vertex.z += 10.0; extra[1].y = -1.0; }"));
  ASSERT_EQ(refined.error, "");
  EXPECT_EQ(refined.values[3], (std::vector<float>{4, 4, 12, 1, 5, 6, 7, -1}));
}

TEST(DeriveRefinementSource, SeesCornersAndBarycentrics) {
  ASSERT_TRUE(make_current(Api::compatibility));
  const Refined refined =
      run(experiment("void refine() {\n  gl_Vertex = vec4(ark_barycentric, ark_corner_gl_Vertex[1].x);\n  extra[0] = "
                     "ark_corner_extra[2 * 2 + 1];\n}\n"));
  ASSERT_EQ(refined.error, "");
  EXPECT_EQ(refined.values[3], (std::vector<float>{0.25F, 0.5F, 0.25F, 8, 11, 12, 7, 8}));
}

TEST(DeriveRefinementSource, MayHaveMacrosFunctionsUniformsAndDirectives) {
  ASSERT_TRUE(make_current(Api::compatibility));
  const Refined refined =
      run(experiment("#extension GL_ARB_gpu_shader5 : enable\n#define POSITION gl_Vertex // the position\n"
                     "uniform vec4 offset = vec4(1.0);\nvec4 moved(vec4 p) { return p + offset; }\n"
                     "void refine(void) { POSITION = moved(POSITION); }"));
  ASSERT_EQ(refined.error, "");
  EXPECT_EQ(refined.values[3][0], 5.0F);
}

TEST(DeriveRefinementSource, WorksBesideAnApplicationFunctionOfTheSameName) {
  ASSERT_TRUE(make_current(Api::compatibility));
  Experiment e = experiment("void refine() { gl_Vertex.x = 1.0; }");
  e.request.vertex_sources = {
      "varying vec4 o; void refine() { gl_Position = gl_Vertex; o = vec4(3.0); } void main() { refine(); }"};
  const Refined refined = run(e);
  ASSERT_EQ(refined.error, "");
  EXPECT_EQ(refined.values[3], (std::vector<float>{1, 4, 2, 1, 3, 3, 3, 3}));
}

TEST(DeriveRefinementSource, ErrorsNameItsOwnLines) {
  for (const std::string version : {"110", "120", "150", "330", "450"}) {
    ASSERT_TRUE(make_current(Api::compatibility));
    Experiment e = experiment("uniform float h;\nvoid refine() {\n  undeclared_name = h;\n}\n");
    e.request.vertex_sources = {"#version " + version + "\nvoid main() { gl_Position = vec4(1.0); }"};
    e.varyings = {"gl_Position"};
    const std::string log = run(e).error;
    EXPECT_NE(log.find("#line " + std::string(version < "330" ? "1000000" : "1000001") + " 7001\n"), std::string::npos)
        << log;
    EXPECT_NE(log_for_author(log, "glark_").find("refinement shader:3("), std::string::npos) << log;
  }
}

TEST(DeriveRefinementSource, MistakesAreToldInTheAuthorsWords) {
  ASSERT_TRUE(make_current(Api::compatibility));
  const auto error = [](const std::string& source) { return run(experiment(source)).error; };
  EXPECT_EQ(error("void refine() {}"), "");
  EXPECT_EQ(
      error("\n#version 120\nvoid refine() {}"),
      "refinement shader:2: error: a refinement shader has no #version directive; it is written in the version of the "
      "vertex shader");
  EXPECT_EQ(error("void refined() {}"), "refinement shader:1: error: it defines no function void refine()");
  EXPECT_EQ(error("#define ENTRY void refine()\nENTRY {}"), "");
  const std::string inactive = error("void refine() {\n  gl_Vertex.x = ark_corner_nb[0].x;\n}");
  EXPECT_TRUE(inactive.starts_with("refinement shader:2: error: ark_corner_nb: nb is not an active input")) << inactive;
  EXPECT_TRUE(inactive.ends_with("the active inputs are gl_Vertex, extra")) << inactive;
  EXPECT_EQ(
      error("uniform float a;\nuniform vec4 o;\nvoid refine() {}"),
      "refinement shader:2: error: the uniform o has the name of an output of the vertex stage; rename the uniform");
}

TEST(DeriveRefinementSource, AnApplicationVariableCalledLikeTheInterfaceIsRenamed) {
  ASSERT_TRUE(make_current(Api::compatibility));
  Experiment e = experiment("void refine() { gl_Vertex.x = ark_barycentric.x; }");
  e.request.vertex_sources = {
      "varying vec4 o; float ark_barycentric = 5.0; void main() { gl_Position = gl_Vertex; o = vec4(ark_barycentric); "
      "}"};
  const Refined refined = run(e);
  ASSERT_EQ(refined.error, "");
  EXPECT_EQ(refined.values[3], (std::vector<float>{0.25F, 4, 2, 1, 5, 5, 5, 5}));
}

TEST(DeriveRefinementSource, FollowsPnTriangles) {
  ASSERT_TRUE(make_current(Api::compatibility));
  Experiment e;
  e.request.vertex_sources = {"void main() { gl_Position = gl_Vertex; }"};
  e.request.refinement = core::Refinement::pn;
  e.record =
      make_record({{"gl_Vertex", GL_FLOAT_VEC4, {{{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}}}, capture::Role::position},
                   {"gl_Normal", GL_FLOAT_VEC3, {{{-1, 0, 1}, {1, 0, 1}, {0, 1, 1}}}, capture::Role::normal}});
  e.varyings = {"gl_Position"};
  e.lattice = {{0.5F, 0}};
  e.request.refinement_source = "void refine() { gl_Vertex.w = gl_Normal.z; }";
  const Refined refined = run(e);
  ASSERT_EQ(refined.error, "");
  EXPECT_GT(refined.values[0][2], 0.1F);
  EXPECT_GT(refined.values[0][3], 1.0F);
}

}  // namespace
}  // namespace glark::refine::test
