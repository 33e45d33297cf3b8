// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Transparent refinement of thin things on the screen: no pixel appears far from the coarse triangles. Links the core
// without the shim, so that each test has its own options.
#include <gtest/gtest.h>

#include <memory>

#include "glark/core/context.h"
#include "glark/gl/hooks.h"
#include "tests/core/support/meshes/creased_meshes.h"
#include "tests/core/support/plain_context.h"

namespace glark::core::test {
namespace {

using Pixels = std::vector<GLubyte>;

constexpr char vertex_source[] =
    "#version 430\nlayout(location = 0) in vec3 position;\nlayout(location = 1) in vec3 normal;\n"
    "out vec3 n;\nuniform vec4 scale;\n"
    "void main() { n = normal; gl_Position = vec4(position.xzy * scale.xyz - vec3(0.0, scale.w, 0.0), 1.0); }\n";
constexpr char fragment_source[] =
    "#version 430\nin vec3 n;\nout vec4 color;\nvoid main() { color = vec4(1.0, 0.5 + 0.4 * normalize(n).xy, 1.0); }\n";

class CreasedPictures : public testing::Test {
 protected:
  CreasedPictures() { start({}); }
  ~CreasedPictures() override { context_->release(); }
  void start(ContextOptions options) {
    if (context_ != nullptr) context_->release();
    options.transparent = true;
    options.level = 4;
    context_ = Context::create(window_.gl, make_share_group(), options);
    use_program();
    hook::Enable(*context_, GL_DEPTH_TEST);
  }
  void use_program() {
    const gl::Dispatch& gl = window_.gl;
    program_ = gl.CreateProgram();
    for (const auto& [stage, text] :
         {std::pair(GL_VERTEX_SHADER, vertex_source), std::pair(GL_FRAGMENT_SHADER, fragment_source)}) {
      const GLuint shader = gl.CreateShader(static_cast<GLenum>(stage));
      gl.ShaderSource(shader, 1, &text, nullptr);
      hook::CompileShader(*context_, shader);
      gl.AttachShader(program_, shader);
    }
    hook::LinkProgram(*context_, program_);
    hook::UseProgram(*context_, program_);
  }
  // Call it once after start(): the derived program takes the scale when it is made.
  Pixels draw(const SplitMesh& mesh, const std::array<GLfloat, 4>& scale) {
    const gl::Dispatch& gl = window_.gl;
    gl.ClearColor(0, 0, 0, 0);
    gl.Uniform4f(gl.GetUniformLocation(program_, "scale"), scale[0], scale[1], scale[2], scale[3]);
    gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(CurvedVertex), mesh.vertices.data()->position.data());
    gl.VertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(CurvedVertex), mesh.vertices.data()->normal.data());
    gl.EnableVertexAttribArray(0);
    gl.EnableVertexAttribArray(1);
    context_->state().arrays().vertex_arrays().forget_current();
    return draw_again(mesh);
  }
  // The same arrays, which the context may keep.
  Pixels draw_again(const SplitMesh& mesh) {
    const gl::Dispatch& gl = window_.gl;
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const std::uint64_t refined = statistics().draws_refined;
    hook::DrawArrays(*context_, GL_TRIANGLES, 0, static_cast<GLsizei>(mesh.vertices.size()));
    EXPECT_EQ(statistics().draws_refined, refined + 1);
    Pixels pixels(static_cast<std::size_t>(4) * plain_side * plain_side);
    gl.ReadPixels(0, 0, plain_side, plain_side, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    return pixels;
  }
  // Pixels of `a` that are background in `b`.
  static int grown(const Pixels& a, const Pixels& b) {
    int count = 0;
    for (std::size_t i = 0; i < a.size(); i += 4) count += a[i] > b[i] ? 1 : 0;
    return count;
  }
  static int covered(const Pixels& pixels) { return grown(pixels, Pixels(pixels.size())); }

  PlainContext window_;
  std::unique_ptr<Context> context_;
  GLuint program_ = 0;
};

constexpr std::array<GLfloat, 4> whole_pole{0.04F, 0.03F, 0.04F, 0.9F};
constexpr std::array<GLfloat, 4> whole_ball{0.6F, 0.6F, 0.6F, 0};

struct Kind {
  Refinement refinement;
  const char* word;
};

class CreasesOf : public CreasedPictures, public testing::WithParamInterface<Kind> {
 protected:
  Pixels flat(const SplitMesh& mesh, const std::array<GLfloat, 4>& scale) {
    start({.refinement = Refinement::linear_inputs});
    return draw(mesh, scale);
  }
  Pixels curved(const SplitMesh& mesh, const std::array<GLfloat, 4>& scale, float crease = 80) {
    start({.refinement = GetParam().refinement, .crease = crease});
    return draw(mesh, scale);
  }
};

TEST_P(CreasesOf, APoleDoesNotSwell) {
  const SplitMesh mesh = pole(4, 60);
  const Pixels coarse = flat(mesh, whole_pole);
  ASSERT_GT(covered(coarse), 200);
  EXPECT_EQ(grown(curved(mesh, whole_pole), coarse), 0);
  EXPECT_GT(grown(curved(mesh, whole_pole, 180), coarse), 3 * covered(coarse)) << "the control does not swell";
}

TEST_P(CreasesOf, ACubeKeepsItsPicture) {
  const SplitMesh mesh = averaged(cube());
  const std::array<GLfloat, 4> scale{0.5F, 0.45F, 0.3F, 0};
  const Pixels coarse = flat(mesh, scale);
  const Pixels cube = curved(mesh, scale);
  EXPECT_EQ(grown(cube, coarse) + grown(coarse, cube), 0);
  EXPECT_GT(grown(curved(mesh, scale, 180), coarse), 500);
}

TEST_P(CreasesOf, ABallRoundsAsWithoutLimits) {
  const SplitMesh mesh = averaged(octahedron());
  const Pixels ball = curved(mesh, whole_ball);
  EXPECT_GT(grown(ball, flat(mesh, whole_ball)), 400);
  EXPECT_EQ(ball, curved(mesh, whole_ball, 180));
}

INSTANTIATE_TEST_SUITE_P(All, CreasesOf,
                         testing::Values(Kind{Refinement::pn, "pn"}, Kind{Refinement::scalar_tagged_pn, "stpn"},
                                         Kind{Refinement::phong, "phong"}),
                         [](const auto& kind) { return std::string(kind.param.word); });

// The light on a cube with mean normals is as before: normals are curved as without limits.
TEST_F(CreasedPictures, NormalsAreStillInterpolated) {
  start({.refinement = Refinement::phong});  // its normals are linear, as in a coarse triangle
  const SplitMesh mesh = averaged(cube());
  const Pixels creased = draw(mesh, {0.5F, 0.45F, 0.3F, 0});
  start({.refinement = Refinement::linear_inputs});
  const Pixels coarse = draw(mesh, {0.5F, 0.45F, 0.3F, 0});
  int differ = 0;
  for (std::size_t i = 0; i < coarse.size(); ++i) differ += std::abs(creased[i] - coarse[i]) > 2 ? 1 : 0;
  EXPECT_EQ(differ, 0);
}

// Normals that lean along straight edges are not reflected, neither at first nor in refined vertices that are kept.
TEST_F(CreasedPictures, NormalsTurnEvenlyAlongStraightEdges) {
  const SplitMesh mesh = leaning_ring();
  const std::array<GLfloat, 4> scale{1.1F, 1, 1.1F, 0.1F};
  start({.refinement = Refinement::linear_inputs});
  const Pixels coarse = draw(mesh, scale);
  ASSERT_GT(covered(coarse), 100);
  start({.refinement = Refinement::pn});
  Pixels curved = draw(mesh, scale);
  for (int again = 0; again < 30; ++again) {
    int differ = 0;
    for (std::size_t i = 0; i < coarse.size(); ++i) differ += std::abs(curved[i] - coarse[i]) > 8 ? 1 : 0;
    EXPECT_LE(differ, 8) << again;
    curved = draw_again(mesh);
  }
}

// Edges measured by curvature, vertices that move between levels, and polygons split at their centroids.
TEST_F(CreasedPictures, DepthsAndPolygonsDoNotMatter) {
  start({.refinement = Refinement::linear_inputs});
  const SplitMesh mesh = pole(4, 60);
  const Pixels coarse = draw(mesh, whole_pole);
  for (const bool geomorph : {false, true}) {
    start({.refinement = Refinement::pn, .measure = {.degrees = 4}, .geomorph = geomorph});
    EXPECT_EQ(grown(draw(mesh, whole_pole), coarse), 0);
    start({.refinement = Refinement::pn, .measure = {.pixels = 4}, .geomorph = geomorph, .centroids = true});
    EXPECT_EQ(grown(draw(mesh, whole_pole), coarse), 0);
  }
}

}  // namespace
}  // namespace glark::core::test
