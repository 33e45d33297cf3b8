// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// In transparent refinement by curved triangles, a budget goes to what shows. A ball stands on a floor of flat triangles,
// before a sky. A pass without colours comes before the ball. Links the core without the shim, so that each test has its
// own options and reads the counters.
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
    "layout(location = 2) in vec3 tint;\nout vec3 color;\nout vec3 n;\n"
    "void main() { n = normal; color = tint; gl_Position = vec4(position, 1.0); }\n";
constexpr char fragment_source[] =
    "#version 430\nin vec3 color;\nin vec3 n;\nout vec4 result;\n"
    "void main() { result = vec4(color + 0.001 * n, 1.0); }\n";

SplitMesh placed(SplitMesh mesh, const Vector& scale, const Vector& move, const Vector& color) {
  for (CurvedVertex& vertex : mesh.vertices) {
    for (std::size_t k = 0; k < 3; ++k) vertex.position[k] = vertex.position[k] * scale[k] + move[k];
    vertex.weights = color;
  }
  return mesh;
}

// Cells x cells squares from -1 to 1. The floor slopes away from the viewer.
SplitMesh floor_of(int cells) {
  SplitMesh mesh;
  const auto at = [cells](int i, int k) {
    const auto along = [cells](int c) { return 2 * static_cast<GLfloat>(c) / static_cast<GLfloat>(cells) - 1; };
    return Vector{along(i), 0.35F * along(k) - 0.6F, 0.4F * along(k)};
  };
  const Vector up = unit({0, 0.4F, -0.35F});
  for (int i = 0; i < cells; ++i) {
    for (int k = 0; k < cells; ++k) {
      mesh.add({at(i, k), at(i + 1, k), at(i + 1, k + 1)}, {up, up, up});
      mesh.add({at(i, k), at(i + 1, k + 1), at(i, k + 1)}, {up, up, up});
    }
  }
  return mesh;
}

struct Frame {
  std::uint64_t triangles = 0;  // refined ones
  Pixels pixels;
  // Red is the ball's.
  int ball_pixels() const {
    int count = 0;
    for (std::size_t i = 0; i < pixels.size(); i += 4) count += pixels[i] > 128 ? 1 : 0;
    return count;
  }
};

class BudgetPictures : public testing::TestWithParam<bool> {
 protected:
  ~BudgetPictures() override { context_->release(); }
  void start(unsigned budget, Refinement refinement = Refinement::pn) {
    if (context_ != nullptr) context_->release();
    context_ = Context::create(window_.gl, make_share_group(),
                               {.transparent = true,
                                .max_level = 6,
                                .refinement = refinement,
                                .smooth = GetParam() && refinement == Refinement::pn,
                                .measure = {.pixels = 2, .budget = budget},
                                .read_counts = true});
    use_program();
    hook::Enable(*context_, GL_DEPTH_TEST);
    hook::DepthFunc(*context_, GL_LEQUAL);
  }
  void use_program() {
    const gl::Dispatch& gl = window_.gl;
    const GLuint program = gl.CreateProgram();
    for (const auto& [stage, text] :
         {std::pair(GL_VERTEX_SHADER, vertex_source), std::pair(GL_FRAGMENT_SHADER, fragment_source)}) {
      const GLuint shader = gl.CreateShader(static_cast<GLenum>(stage));
      gl.ShaderSource(shader, 1, &text, nullptr);
      hook::CompileShader(*context_, shader);
      gl.AttachShader(program, shader);
    }
    hook::LinkProgram(*context_, program);
    hook::UseProgram(*context_, program);
  }
  void draw(const SplitMesh& mesh) {
    const gl::Dispatch& gl = window_.gl;
    const auto point = [&](GLuint attribute, const Vector& first) {
      gl.VertexAttribPointer(attribute, 3, GL_FLOAT, GL_FALSE, sizeof(CurvedVertex), first.data());
      gl.EnableVertexAttribArray(attribute);
    };
    point(0, mesh.vertices.front().position);
    point(1, mesh.vertices.front().normal);
    point(2, mesh.vertices.front().weights);
    context_->state().arrays().vertex_arrays().forget_current();
    hook::DrawArrays(*context_, GL_TRIANGLES, 0, static_cast<GLsizei>(mesh.vertices.size()));
  }
  void draw_sky() {
    hook::DepthMask(*context_, GL_FALSE);
    draw(sky_);
    hook::DepthMask(*context_, GL_TRUE);
  }
  void draw_ball(bool prepass) {
    if (prepass) {
      hook::ColorMask(*context_, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
      draw(ball_);
      hook::ColorMask(*context_, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
      hook::DepthFunc(*context_, GL_EQUAL);
    }
    draw(ball_);
    hook::DepthFunc(*context_, GL_LEQUAL);
  }
  template <typename Draw>
  Frame frame_of(Draw&& draw_all) {
    const gl::Dispatch& gl = window_.gl;
    Frame frame;
    for (int settling = 0; settling < 10; ++settling) {
      gl.ClearColor(0, 0, 0, 0);
      gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
      const std::uint64_t before = statistics().refined_triangles;
      draw_all();
      context_->frame_finished();
      frame.triangles = statistics().refined_triangles - before;
    }
    frame.pixels.resize(static_cast<std::size_t>(4) * plain_side * plain_side);
    gl.ReadPixels(0, 0, plain_side, plain_side, GL_RGBA, GL_UNSIGNED_BYTE, frame.pixels.data());
    return frame;
  }
  Frame scene() {
    return frame_of([this] {
      draw_sky();
      draw(floor_);
      draw_ball(true);
    });
  }

  PlainContext window_;
  std::unique_ptr<Context> context_;
  const SplitMesh ball_ = placed(averaged(octahedron()), {0.6F, 0.6F, 0.3F}, {0, 0.2F, -0.5F}, {1, 0, 0});
  const SplitMesh sky_ = placed(sphere(16, 8), {1.9F, 1.9F, 0.9F}, {0, 0, 0}, {0, 0, 1});
  const SplitMesh floor_ = placed(floor_of(12), {1, 1, 1}, {0, 0, 0}, {0, 1, 0});
};

TEST_P(BudgetPictures, TheBallGetsTheTriangles) {
  start(0);
  const Frame ball = frame_of([this] { draw_ball(false); });
  ASSERT_GT(ball.triangles, 4000U);
  const Frame unlimited = scene();
  EXPECT_GT(unlimited.triangles, 3 * ball.triangles) << "sky and floor need no triangles even without a budget";
  start(static_cast<unsigned>(ball.triangles));
  const Frame limited = scene();
  EXPECT_EQ(limited.triangles, 2 * ball.triangles + floor_.triangles());
  EXPECT_EQ(limited.ball_pixels(), unlimited.ball_pixels());
}

// The control: by another refinement, flat triangles may gain from depth, too.
TEST_P(BudgetPictures, LinearRefinementSharesTheBudget) {
  start(0);
  const Frame ball = frame_of([this] { draw_ball(false); });
  start(static_cast<unsigned>(ball.triangles), Refinement::linear_inputs);
  const Frame limited = scene();
  EXPECT_LE(limited.triangles, ball.triangles);
}

TEST_P(BudgetPictures, TheBallKeepsTheBudget) {
  for (const unsigned budget : {300U, 2000U}) {
    start(budget);
    const std::uint64_t counted = (scene().triangles - floor_.triangles()) / 2;
    EXPECT_LE(counted, budget);
    EXPECT_GE(counted, budget / 4);
  }
}

// As the panel and a changed configuration file do it.
TEST_P(BudgetPictures, TheBudgetOfTheNextFramesIsTheNewOne) {
  start(0);
  const auto draw_one_ball = [this] { draw_ball(false); };
  const std::uint64_t unlimited = frame_of(draw_one_ball).triangles;
  const auto triangles_with = [&](unsigned budget) {
    ContextOptions wanted = context_->options();
    wanted.measure.budget = budget;
    context_->change_options(wanted);
    return frame_of(draw_one_ball).triangles;
  };
  const std::uint64_t few = triangles_with(300), more = triangles_with(2000);
  EXPECT_LE(few, 300U);
  EXPECT_GT(more, 2 * few);
  EXPECT_LE(more, 2000U);
  EXPECT_EQ(triangles_with(0), unlimited);
}

// Many triangles at once are sorted in other passes than few.
TEST_P(BudgetPictures, ManyTrianglesOfOneDrawAlsoCountWhereTheyCurve) {
  SplitMesh both = floor_;
  for (const CurvedVertex& vertex : ball_.vertices) both.vertices.push_back(vertex);
  start(2000);
  const std::uint64_t triangles = frame_of([&] { draw(both); }).triangles;
  EXPECT_GE(triangles, floor_.triangles() + 500);
  EXPECT_LE(triangles, floor_.triangles() + 2000);
}

// Straight edges of a cylinder have depth 0, where a flat triangle beside it has it, too: no gap opens.
TEST_P(BudgetPictures, ACylinderIsCutAlongItsAxisOnly) {
  const SplitMesh tube = [] {
    SplitMesh mesh = averaged(turned({{1, 0}, {1, 1}}, 8));
    for (CurvedVertex& vertex : mesh.vertices) {
      vertex.position = {vertex.position[0], vertex.position[2], -vertex.position[1]};
      vertex.normal = unit({vertex.position[0], 0, vertex.position[2]});
    }
    return placed(mesh, {0.8F, 1.2F, 0.5F}, {0, -0.6F, 0}, {1, 0, 0});
  }();
  const auto draw_tube = [&] { draw(tube); };
  start(0);
  const Frame free = frame_of(draw_tube);
  start(100000);
  const Frame limited = frame_of(draw_tube);
  EXPECT_LT(2 * limited.triangles, free.triangles);
  EXPECT_EQ(limited.ball_pixels(), free.ball_pixels());
}

TEST_P(BudgetPictures, ABackgroundIsCounted) {
  start(100000);
  const std::uint64_t before = statistics().passed_through.at(static_cast<std::size_t>(Cause::budget));
  scene();
  EXPECT_GE(statistics().passed_through.at(static_cast<std::size_t>(Cause::budget)), before + 8);
}

INSTANTIATE_TEST_SUITE_P(Refinement, BudgetPictures, testing::Bool(),
                         [](const auto& parameter) { return parameter.param ? "smooth" : "pn"; });

}  // namespace
}  // namespace glark::core::test
