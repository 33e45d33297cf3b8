// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Scalar tags and displacement in every version of the language, in both families of contexts; and the constant tags.
#include <gtest/gtest.h>

#include "tests/core/refine/support/derive_harness.h"

namespace glark::refine::test {
namespace {

struct Version {
  Api api;
  const char* line;
  bool modern;  // in and out instead of attribute and varying
};

constexpr Version versions[] = {
    {Api::compatibility, "", false},
    {Api::compatibility, "#version 110\n", false},
    {Api::compatibility, "#version 120\n", false},
    {Api::compatibility, "#version 130\n", true},
    {Api::compatibility, "#version 150 compatibility\n", true},
    {Api::core, "#version 330 core\n", true},
    {Api::core, "#version 430 core\n", true},
    {Api::es, "", false},
    {Api::es, "#version 100\nprecision mediump float;\n", false},
    {Api::es, "#version 300 es\nprecision mediump float;\n", true},
    {Api::es, "#version 310 es\n", true},
    {Api::es, "#version 320 es\n", true},
};

std::string source_for(const Version& version) {
  const std::string in = version.modern ? "in" : "attribute";
  const std::string out = version.modern ? "out" : "varying";
  const std::string precision = version.api == Api::es ? " highp" : "";
  return version.line + in + precision + " vec3 position; " + in + precision + " vec3 normal; " + in + precision +
         " vec2 texcoord; " + out + precision +
         " vec4 passed;\nvoid main() { passed = vec4(normal, texcoord.x); gl_Position = vec4(position, 1.0); }\n";
}

// Three corners of a bent triangle, with tags and a texture coordinate.
Record record() {
  return make_record({{"position", GL_FLOAT_VEC3, {{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}}}, capture::Role::position},
                      {"normal", GL_FLOAT_VEC3, {{{-1, 0, 1}, {1, 0, 1}, {0, 1, 1}}}, capture::Role::normal},
                      {"texcoord", GL_FLOAT_VEC2, {{{0, 0}, {1, 0}, {0, 1}}}, capture::Role::texture_coordinate},
                      {"glark_discontinuity", GL_FLOAT_VEC4, {{{0, 0, 0, 1}, {0, 0, 0, 1}, {0, 0, 0, 1}}}},
                      {"glark_scalar_tags", GL_FLOAT_VEC3, {{{0, 0, 0}, {0, 1, 0}, {0, 0, 0}}}}});
}

Experiment experiment(const Version& version, core::Refinement refinement, bool displaced) {
  Experiment e;
  e.request.vertex_sources = {source_for(version)};
  e.request.es = version.api == Api::es;
  e.request.refinement = refinement;
  e.record = record();
  e.request.discontinuity_field = 3;
  e.request.scalar_tag_field = 4;
  e.request.coordinate_field = displaced ? 2 : -1;
  e.varyings = {"gl_Position", "passed"};
  e.captured_words = 8;
  e.lattice = {{0, 0}, {1, 0}, {0.5F, 0}, {0.25F, 0.25F}};
  return e;
}

TEST(DeriveShape, EveryVersionLinksAndRuns) {
  int contexts = 0;
  for (const Version& version : versions) {
    if (!make_current(version.api)) continue;
    ++contexts;
    for (const core::RefinementTraits& row : core::refinements) {
      for (const bool displaced : {false, true}) {
        const Refined refined = run(experiment(version, row.refinement, displaced));
        ASSERT_EQ(refined.error, "") << version.line << row.word;
        EXPECT_EQ(refined.values[1][0], 8.0F) << "no texture, no height";
        EXPECT_EQ(refined.values[1][3], 1.0F);
      }
    }
  }
  EXPECT_GT(contexts, 0) << "nothing was tried";
}

TEST(DeriveShape, ATagReachesItsOwnCornerOnly) {
  for (const Version& version : versions) {
    if (!make_current(version.api)) continue;
    const Refined plain = run(experiment(version, core::Refinement::pn, false));
    const Refined tagged = run(experiment(version, core::Refinement::scalar_tagged_pn, false));
    ASSERT_EQ(plain.error + tagged.error, "");
    // Corner 1 alone is tense: the other control point of the edge lifts its middle by 3/8 of a third of 4.
    EXPECT_NEAR(plain.values[2][2], 3.0F / 8 * 2 * 4 / 3, 1e-5F);
    EXPECT_NEAR(tagged.values[2][2], 3.0F / 8 * 4 / 3, 1e-5F);
  }
}

// With corners' tangent planes of 45 degrees, the middle of edge 0 rises by a quarter of the shape times 4 + 4.
TEST(DeriveShape, PhongBendsByItsNumber) {
  for (const Version& version : versions) {
    if (!make_current(version.api)) continue;
    for (const float shape : {0.0F, 0.75F, 1.0F}) {
      Experiment e = experiment(version, core::Refinement::phong, false);
      e.shape_number = shape;
      const Refined refined = run(e);
      ASSERT_EQ(refined.error, "");
      EXPECT_NEAR(refined.values[2][0], 4.0F, 1e-5F);
      EXPECT_NEAR(refined.values[2][2], shape * 2, 1e-5F);
      EXPECT_EQ(refined.values[2][4], 0.0F) << "the normal is linear";
      EXPECT_EQ(refined.values[2][6], 1.0F);
    }
  }
}

TEST(DeriveShape, ConstantTensionOfAllVertices) {
  for (const Version& version : versions) {
    if (!make_current(version.api)) continue;
    for (const float tension : {-1.0F, 0.0F, 0.25F, 1.0F}) {
      Experiment e = experiment(version, core::Refinement::scalar_tagged_pn, false);
      e.request.discontinuity_field = e.request.scalar_tag_field = -1;
      e.request.scalar_tags.tension = tension;
      const Refined refined = run(e);
      ASSERT_EQ(refined.error, "");
      EXPECT_NEAR(refined.values[2][2], (1 - tension) * 3.0F / 8 * 2 * 4 / 3, 1e-5F);
    }
  }
}

TEST(DeriveShape, NamesOfTheApplicationGiveWay) {
  for (const Version& version : versions) {
    if (!make_current(version.api)) continue;
    Experiment e = experiment(version, core::Refinement::scalar_tagged_pn, true);
    std::string& source = e.request.vertex_sources[0];
    source.insert(source.find("void main"),
                  "float glark_height_range = 1.0; float glark_st_corner() { return 1.0; }\n");
    EXPECT_EQ(run(e).error, "") << version.line;
    source.insert(source.find("void main"), "uniform vec4 glark_height_channel;\n");
    EXPECT_NE(run(e).error.find("glark_height_channel"), std::string::npos) << "the application can see it";
  }
}

}  // namespace
}  // namespace glark::refine::test
