// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// OpenGL ES: GLSL ES 1.00, 3.00, 3.10 and 3.20 in a real ES context.
#include <gtest/gtest.h>

#include <bit>
#include <regex>

#include "glark/core/refine/refinement_log.h"
#include "tests/core/refine/support/derive_harness.h"

namespace glark::refine::test {
namespace {

struct EsStage {
  const char* version;
  std::string source;
};

std::vector<EsStage> stages() {
  std::vector<EsStage> all = {{"100",
                               "attribute highp vec3 position; attribute mediump vec2 a; precision mediump float; "
                               "varying lowp vec4 c; varying vec2 v[2]; invariant gl_Position;\n"
                               "void main() { c = vec4(a, a); v[0] = a; v[1] = position.xy; gl_Position = "
                               "vec4(position, 1.0); gl_PointSize = 2.0; }"}};
  for (const char* version : {"300", "310", "320"}) {
    all.push_back({version, "#version " + std::string(version) +
                                " es\nprecision mediump float; layout(location = 0) in highp vec3 position; in mediump "
                                "vec2 a; in ivec2 i;\n"
                                "struct S { vec2 x; mediump float y; }; out S s; out vec2 z[2]; flat out ivec2 o; "
                                "centroid out vec4 c; float start = 1.0;\n"
                                "void main() { s.x = a; s.y = a.x; z[0] = a; z[1] = a; o = i + gl_VertexID; c = "
                                "vec4(start); start += 1.0; gl_Position = vec4(position, 1.0); }"});
  }
  return all;
}

std::vector<FieldValues> inputs(bool integers) {
  std::vector<FieldValues> fields = {
      {"position", GL_FLOAT_VEC3, {{{0, 0, 0}, {8, 0, 2}, {0, 16, 4}}}, capture::Role::position},
      {"a", GL_FLOAT_VEC2, {{{0, 1}, {8, 1}, {4, 1}}}}};
  if (integers) {
    fields.push_back({"i", GL_INT_VEC2, {{{bits(1), bits(2)}, {bits(3), bits(4)}, {bits(-5), bits(6)}}}});
    fields.push_back({"gl_VertexID", GL_INT, {{{bits(10)}, {bits(20)}, {bits(30)}}}});
  }
  return fields;
}

TEST(DeriveEs, EveryVersionLinksInEveryRefinement) {
  if (!make_current(Api::es)) GTEST_SKIP() << "no ES context";
  for (const EsStage& stage : stages()) {
    for (const auto refinement :
         {core::Refinement::linear_inputs, core::Refinement::linear_outputs, core::Refinement::pn}) {
      ASSERT_EQ(link_error({stage.source}), "");
      EXPECT_TRUE(inspect_vertex_stage({stage.source}, true).ok) << inspect_vertex_stage({stage.source}, true).error;
      DeriveRequest request;
      request.vertex_sources = {stage.source};
      request.es = true;
      std::vector<FieldValues> fields = inputs(std::string(stage.version) != "100");
      fields.push_back({"a_normal", GL_FLOAT_VEC3, {{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}}, capture::Role::normal});
      request.vertex_sources[0].insert(stage.source.find("void main() {"),
                                       std::string(stage.version) == "100"
                                           ? "attribute vec3 a_normal; varying vec3 vn;\n"
                                           : "in vec3 a_normal; out vec3 vn;\n");
      request.vertex_sources[0].insert(request.vertex_sources[0].find("void main() {") + 13, " vn = a_normal; ");
      request.layout = make_record(fields).layout;
      request.refinement = refinement;
      const Derivation derivation = derive_vertex_stage(request);
      ASSERT_TRUE(derivation.ok) << derivation.error;
      EXPECT_EQ(link_error(derivation.vertex_sources), "") << stage.version;
    }
  }
}

TEST(DeriveEs, NumbersOfLinearInputsAndOutputs) {
  if (!make_current(Api::es)) GTEST_SKIP() << "no ES context";
  for (const EsStage& stage : stages()) {
    const bool modern = std::string(stage.version) != "100";
    for (const auto refinement : {core::Refinement::linear_inputs, core::Refinement::linear_outputs}) {
      Experiment e;
      e.request.vertex_sources = {stage.source};
      e.request.es = true;
      e.request.refinement = refinement;
      e.record = make_record(inputs(modern));
      e.varyings = {"gl_Position", modern ? "o" : "v[1]"};
      e.captured_words = 6;
      const Refined refined = run(e);
      ASSERT_EQ(refined.error, "");
      const std::vector<float>& middle = refined.values[3];
      EXPECT_EQ(std::vector<float>(middle.begin(), middle.begin() + 4), (std::vector<float>{4, 4, 2, 1}));
      if (modern) {
        EXPECT_EQ(std::bit_cast<int>(middle[4]), 25);
      } else {
        EXPECT_EQ(middle[5], 4.0F);
      }
    }
  }
}

TEST(DeriveEs, RefinementSourceErrorsNameTheirLine) {
  if (!make_current(Api::es)) GTEST_SKIP() << "no ES context";
  for (const EsStage& stage : stages()) {
    Experiment e;
    e.request.vertex_sources = {stage.source};
    e.request.es = true;
    e.request.refinement_source = "void refine() {\n  position.z += 1.0;\n  nonsense;\n}";
    e.record = make_record(inputs(std::string(stage.version) != "100"));
    e.varyings = {"gl_Position"};
    const std::string log = run(e).error;
    EXPECT_TRUE(std::regex_search(log_for_author(log, "glark_"), std::regex("refinement shader:3\\b"))) << log;
    e.request.refinement_source = "void refine() {\n  position.z += 1.0;\n}";
    const Refined refined = run(e);
    ASSERT_EQ(refined.error, "");
    EXPECT_EQ(refined.values[3][2], 3.0F);
  }
}

}  // namespace
}  // namespace glark::refine::test
