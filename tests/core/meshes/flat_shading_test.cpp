// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// --refine smooth: what glShadeModel(GL_FLAT) shows in one colour a triangle.
#include <string>
#include <vector>

#include "tests/core/meshes/ball.h"
#include "tests/core/meshes/under_glark_run.h"

namespace glark::core::test {
namespace {

class FlatShading : public testing::TestWithParam<Source> {
 protected:
  FlatShading() {
    for (const GLenum capability : {GL_DEPTH_TEST, GL_LIGHTING, GL_LIGHT0}) glEnable(capability);
  }
  // The last of five frames.
  static int pixels(const Ball& ball) {
    return covered_pixels(draw_frames(5, [&] { ball.draw(); })[4]);
  }

 private:
  const OsmesaContext context_{Profile::compatibility};
};

TEST_P(FlatShading, KeepsTrianglesFlat) {
  ASSERT_TRUE(as_under_glark_run);
  const Ball ball(GetParam());
  glShadeModel(GL_FLAT);
  EXPECT_NEAR(pixels(ball), octahedron_pixels, octahedron_pixels / 50);
}

TEST_P(FlatShading, Matters) {
  ASSERT_TRUE(as_under_glark_run);
  const Ball ball(GetParam());
  EXPECT_GT(pixels(ball), round_pixels);
}

TEST_P(FlatShading, FlattensARoundMeshAtOnce) {
  ASSERT_TRUE(as_under_glark_run);
  const Ball ball(GetParam());
  EXPECT_GT(pixels(ball), round_pixels);
  glShadeModel(GL_FLAT);
  EXPECT_NEAR(covered_pixels(draw_frames(1, [&] { ball.draw(); })[0]), octahedron_pixels, octahedron_pixels / 50);
}

// What a program shows of the normal: a value of one corner, or values between the corners.
struct Shading {
  const char* name;
  std::string vertex;
  std::string fragment;
  GLenum shade_model = GL_SMOOTH;
  bool is_flat = false;
};

class ProgramShading : public testing::TestWithParam<Shading> {
 private:
  const OsmesaContext context_{Profile::compatibility};
};

TEST_P(ProgramShading, KeepsFacets) {
  ASSERT_TRUE(as_under_glark_run);
  const Shading& shading = GetParam();
  const Ball ball(Source::buffer);
  glEnable(GL_DEPTH_TEST);
  glUseProgram(
      link_program({.vertex = "#version 130\n" + shading.vertex, .fragment = "#version 130\n" + shading.fragment}));
  const auto pixels = [&] { return covered_pixels(draw_frames(5, [&] { ball.draw(); })[4]); };
  if (shading.shade_model == GL_FLAT) {
    EXPECT_GT(pixels(), round_pixels);
    glShadeModel(GL_FLAT);
  }
  if (shading.is_flat) {
    EXPECT_NEAR(pixels(), octahedron_pixels, octahedron_pixels / 50);
  } else {
    EXPECT_GT(pixels(), round_pixels);
  }
}

const std::string placed = " gl_Position = gl_Vertex; }";
const std::string lit = "vec4(vec3(0.6 + 0.4 * gl_Normal.z), 1.0);";
const std::string shows_shade = "in vec4 shade; void main() { gl_FragColor = shade; }";
const std::string shows_color = "void main() { gl_FragColor = gl_Color; }";
INSTANTIATE_TEST_SUITE_P(
    AllOutputs, ProgramShading,
    testing::Values(
        Shading{"flat", "flat out vec4 shade; void main() { shade = " + lit + placed, "flat " + shows_shade, GL_SMOOTH,
                true},
        Shading{"smooth", "out vec4 shade; void main() { shade = " + lit + placed, shows_shade},
        Shading{"flat_without_normal",
                "flat out vec4 shade; out vec3 n; void main() { n = gl_Normal; shade = gl_Color;" + placed,
                "in vec3 n; flat in vec4 shade; void main() { gl_FragColor = shade + vec4(0.6 + 0.4 * n, 0.0); }"},
        Shading{"smooth_color", "void main() { gl_FrontColor = " + lit + placed, shows_color},
        Shading{"flat_color", "void main() { gl_FrontColor = " + lit + placed, shows_color, GL_FLAT, true},
        Shading{"color_without_normal", "out vec3 n; void main() { n = gl_Normal; gl_FrontColor = gl_Color;" + placed,
                "in vec3 n; void main() { gl_FragColor = gl_Color + vec4(0.6 + 0.4 * n, 0.0); }", GL_FLAT}),
    [](const testing::TestParamInfo<Shading>& parameter) { return std::string(parameter.param.name); });

// Smooth does not overrule a program that asks for a curved refinement itself.
TEST_P(FlatShading, IsWhatAProgramThatCallsTheExtensionMayAskFor) {
  ASSERT_TRUE(as_under_glark_run);
  const Ball ball(GetParam());
  glShadeModel(GL_FLAT);
  glARKinit(3);
  glEnable(GL_ARK);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 3);
  EXPECT_GT(pixels(ball), round_pixels);
}

INSTANTIATE_TEST_SUITE_P(AllSources, FlatShading,
                         testing::Values(Source::buffer, Source::client_memory, Source::list, Source::immediate),
                         source_name);

}  // namespace
}  // namespace glark::core::test
