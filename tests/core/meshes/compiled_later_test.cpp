// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// --refine smooth without --wait: the passes over a mesh stay as they are until all programs are compiled. Then all of
// them are curved. Nobody knows in which frame that is.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "tests/core/meshes/ball.h"

namespace glark::core::test {
namespace {

// The program runs as under `glark run`. The library reads the variables when the first context is made.
const bool as_under_glark_run = [] {
  return setenv("GLARK_CONFIG", "/dev/null", 1) == 0 && setenv("GLARK_ENABLE", "1", 1) == 0 &&
         setenv("GLARK_REFINE", "smooth", 1) == 0 && setenv("GLARK_LEVEL", "3", 1) == 0 &&
         setenv("MESA_SHADER_CACHE_DISABLE", "true", 1) == 0;
}();

constexpr int enough_frames = 60;  // each compiles a program

class CompiledLater : public testing::TestWithParam<Source> {
 protected:
  CompiledLater() : ball_(GetParam()) {
    EXPECT_TRUE(as_under_glark_run);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_COLOR_MATERIAL);
    glEnable(GL_LIGHT0);
  }
  // In red with light, and once more in green by a program, where both meet to the bit.
  void draw_twice(GLuint program) const {
    glEnable(GL_LIGHTING);
    glColor3f(1, 0, 0);
    ball_.draw();
    glUseProgram(program);
    glDepthFunc(GL_EQUAL);
    ball_.draw();
    glDepthFunc(GL_LESS);
    glUseProgram(0);
  }
  // Milliseconds of processor time. Prints the figures of docs/explanation/compiling.md.
  static void print_times(const std::vector<std::clock_t>& begins, std::ptrdiff_t round_from) {
    std::clock_t longest = 0;
    for (std::size_t i = 1; i < begins.size(); ++i) longest = std::max(longest, begins[i] - begins[i - 1]);
    std::printf("longest frame: %.0f ms, round from frame %td\n", 1e3 * static_cast<double>(longest) / CLOCKS_PER_SEC,
                round_from + 1);
  }
  static bool is_round(const Picture& picture) { return covered_pixels(picture) > round_pixels; }

  OsmesaContext context_{Profile::compatibility};
  Ball ball_;
};

TEST_P(CompiledLater, AllPassesBecomeRoundInOneFrame) {
  const GLuint green =
      link_program({.vertex = "varying vec3 normal;\n"
                              "void main() { normal = gl_Normal; gl_Position = ftransform(); }",
                    .fragment = "varying vec3 normal;\n"
                                "void main() { gl_FragColor = vec4(0.0, 1.0, 0.001 * normal.x, 1.0); }"});
  std::vector<std::clock_t> begins;
  const std::vector<Picture> frames = draw_frames(enough_frames, [&] {
    begins.push_back(std::clock());
    draw_twice(green);
  });
  for (std::size_t i = 0; i < frames.size(); ++i) EXPECT_EQ(red_pixels(frames[i]), 0) << i;
  const auto first = std::find_if(frames.begin(), frames.end(), is_round);
  ASSERT_NE(first, frames.end());
  print_times(begins, first - frames.begin());
  if (std::getenv("GLARK_WAIT") == nullptr) {
    EXPECT_GT(first - frames.begin(), 2) << "the passes cannot be compiled in one frame";
  }
  EXPECT_TRUE(std::all_of(first, frames.end(), is_round)) << "round meshes stay round";
  for (auto frame = frames.begin(); frame != first; ++frame) {
    EXPECT_NEAR(covered_pixels(*frame), octahedron_pixels, octahedron_pixels / 50) << frame - frames.begin();
  }
}

// Its mesh is round already: the new pass must follow at once.
TEST_P(CompiledLater, ANewPassOverARoundMeshIsRoundAtOnce) {
  const std::vector<Picture> before = draw_frames(enough_frames, [&] {
    glEnable(GL_LIGHTING);
    ball_.draw();
  });
  ASSERT_TRUE(is_round(before.back()));
  const GLuint green =
      link_program({.vertex = "varying vec3 normal;\n"
                              "void main() { normal = gl_Normal; gl_Position = ftransform(); }",
                    .fragment = "varying vec3 normal;\n"
                                "void main() { gl_FragColor = vec4(0.0, 1.0, 0.002 * normal.x, 1.0); }"});
  const std::vector<Picture> frames = draw_frames(3, [&] { draw_twice(green); });
  for (const Picture& frame : frames) {
    EXPECT_EQ(red_pixels(frame), 0);
    EXPECT_TRUE(is_round(frame));
  }
}

INSTANTIATE_TEST_SUITE_P(Sources, CompiledLater,
                         testing::Values(Source::buffer, Source::client_memory, Source::list, Source::immediate),
                         source_name);

}  // namespace
}  // namespace glark::core::test
