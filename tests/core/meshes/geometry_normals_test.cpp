// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// --normals geometry: meshes without normals are curved by normals made from positions. Links the core without the shim,
// so that each test has its own options.
#include <gtest/gtest.h>

#include <memory>

#include "glark/core/context.h"
#include "glark/gl/hooks.h"
#include "tests/core/support/meshes/creased_meshes.h"
#include "tests/core/support/plain_context.h"

namespace glark::core::test {
namespace {

using Pixels = std::vector<GLubyte>;

// The second one reads positions and normals; its colour depends on both, so that nothing is removed.
constexpr char bare_source[] =
    "#version 430\nlayout(location = 0) in vec3 position;\nout vec3 color;\nuniform vec3 tint;\n"
    "void main() { color = tint; gl_Position = vec4(0.6 * position, 1.0); }\n";
constexpr char normal_source[] =
    "#version 430\nlayout(location = 0) in vec3 position;\nlayout(location = 1) in vec3 normal;\n"
    "out vec3 color;\nuniform vec3 tint;\n"
    "void main() { color = tint + 0.001 * normal; gl_Position = vec4(0.6 * position, 1.0); }\n";
constexpr char bent_source[] =
    "#version 430\nlayout(location = 0) in vec3 position;\nout vec3 color;\nuniform vec3 tint;\n"
    "void main() { color = tint; gl_Position = vec4(0.6 * position * (1.0 + 0.1 * dot(position, position)), 1.0); }\n";
constexpr char fragment_source[] =
    "#version 430\nin vec3 color;\nout vec4 result;\nvoid main() { result = vec4(color, 1.0); }\n";

class GeometryNormals : public testing::Test {
 protected:
  GeometryNormals() { start({.smooth = true, .geometry_normals = true}); }
  ~GeometryNormals() override { context_->release(); }
  void start(ContextOptions options) {
    if (context_ != nullptr) context_->release();
    options.transparent = true;
    options.level = 4;
    options.refinement = Refinement::pn;
    context_ = Context::create(window_.gl, make_share_group(), options);
    hook::Enable(*context_, GL_DEPTH_TEST);
    hook::DepthFunc(*context_, GL_LEQUAL);
  }
  GLuint link(const char* vertex) {
    const gl::Dispatch& gl = window_.gl;
    const GLuint program = gl.CreateProgram();
    for (const auto& [stage, text] :
         {std::pair(GL_VERTEX_SHADER, vertex), std::pair(GL_FRAGMENT_SHADER, fragment_source)}) {
      const GLuint shader = gl.CreateShader(static_cast<GLenum>(stage));
      gl.ShaderSource(shader, 1, &text, nullptr);
      hook::CompileShader(*context_, shader);
      gl.AttachShader(program, shader);
    }
    hook::LinkProgram(*context_, program);
    return program;
  }
  void draw(GLuint program, const SplitMesh& mesh, bool normals = false, const Vector& tint = {1, 0, 0}) {
    const gl::Dispatch& gl = window_.gl;
    hook::UseProgram(*context_, program);
    gl.Uniform3f(gl.GetUniformLocation(program, "tint"), tint[0], tint[1], tint[2]);
    gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(CurvedVertex), mesh.vertices.front().position.data());
    gl.VertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(CurvedVertex), mesh.vertices.front().normal.data());
    gl.EnableVertexAttribArray(0);
    (normals ? gl.EnableVertexAttribArray : gl.DisableVertexAttribArray)(1);
    context_->state().arrays().vertex_arrays().forget_current();
    hook::DrawArrays(*context_, GL_TRIANGLES, 0, static_cast<GLsizei>(mesh.vertices.size()));
  }
  template <typename Draw>
  Pixels picture(Draw&& draw_all, int frames = 4) {
    const gl::Dispatch& gl = window_.gl;
    for (int frame = 0; frame < frames; ++frame) {
      gl.ClearColor(0, 0, 0, 0);
      gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
      draw_all();
      context_->frame_finished();
    }
    Pixels pixels(static_cast<std::size_t>(4) * plain_side * plain_side);
    gl.ReadPixels(0, 0, plain_side, plain_side, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    return pixels;
  }
  Pixels picture_of(const char* source, const SplitMesh& mesh, bool normals = false) {
    const GLuint program = link(source);
    return picture([&] { draw(program, mesh, normals); });
  }
  static int count(const Pixels& pixels, std::size_t channel) {
    int found = 0;
    for (std::size_t i = 0; i < pixels.size(); i += 4) found += pixels[i + channel] > 128 ? 1 : 0;
    return found;
  }
  static int red(const Pixels& pixels) { return count(pixels, 0); }
  static int green(const Pixels& pixels) { return count(pixels, 1); }

  PlainContext window_;
  std::unique_ptr<Context> context_;
  const SplitMesh ball_ = averaged(octahedron());
};

constexpr double octahedron_pixels = 0.18 * plain_side * plain_side;  // a square of half diagonal 0.6
constexpr double round_pixels = 1.25 * octahedron_pixels;

TEST_F(GeometryNormals, ABallWithoutNormalsBecomesRound) {
  EXPECT_GT(red(picture_of(bare_source, ball_)), round_pixels);
  start({.smooth = false, .geometry_normals = true});
  EXPECT_GT(red(picture_of(bare_source, ball_)), round_pixels);
}

TEST_F(GeometryNormals, ItStaysFlatByDefault) {
  for (const bool smooth : {false, true}) {
    start({.smooth = smooth});
    EXPECT_NEAR(red(picture_of(bare_source, ball_)), octahedron_pixels, octahedron_pixels / 50) << smooth;
  }
}

// The mean of four equal faces of an octahedron is its axis, as the program's own normals are.
TEST_F(GeometryNormals, EqualGoodNormalsOfTheProgram) {
  const SplitMesh finer = sphere(12, 6);
  for (const SplitMesh* mesh : {&ball_, &finer}) {
    const int made = red(picture_of(bare_source, *mesh));
    start({.smooth = true});
    EXPECT_NEAR(red(picture_of(normal_source, *mesh, true)), made, 40);
    start({.smooth = true, .geometry_normals = true});
  }
}

// More faces meet at the poles than the fan holds.
TEST_F(GeometryNormals, APoleOfManyFacesIsRound) {
  const SplitMesh many = sphere(40, 4);
  const int made = red(picture_of(bare_source, many));
  start({.smooth = true});
  EXPECT_NEAR(red(picture_of(normal_source, many, true)), made, 60);
}

TEST_F(GeometryNormals, ACubeStaysACube) {
  SplitMesh turned_cube = averaged(cube());
  for (CurvedVertex& vertex : turned_cube.vertices) {  // about y, then about x
    const Vector p = vertex.position;
    const GLfloat z = 0.8F * p[2] - 0.6F * p[0];
    vertex.position = {0.8F * p[0] + 0.6F * p[2], 0.8F * p[1] - 0.6F * z, 0.6F * p[1] + 0.8F * z};
  }
  const GLuint program = link(bare_source);
  const auto draw_cube = [&] { draw(program, turned_cube); };
  const int coarse = red(picture(draw_cube, 1));  // nothing is curved in the first frame
  EXPECT_NEAR(red(picture(draw_cube)), coarse, 2);
  start({.smooth = true, .crease = 180, .geometry_normals = true});
  EXPECT_GT(red(picture_of(bare_source, turned_cube)), coarse + 100) << "the control";
}

// The program that reads a normal gets the same one for all vertices: this tells nothing about the surface.
TEST_F(GeometryNormals, ProgramsMeetToTheBit) {
  const GLuint first = link(bare_source);
  const GLuint second = link(normal_source);
  const Pixels pixels = picture([&] {
    draw(first, ball_, false, {1, 0, 0});
    hook::DepthFunc(*context_, GL_EQUAL);
    draw(second, ball_, false, {0, 1, 0});
    hook::DepthFunc(*context_, GL_LEQUAL);
  });
  EXPECT_EQ(red(pixels), 0);
  EXPECT_GT(green(pixels), round_pixels);
}

TEST_F(GeometryNormals, ADepthPrepassFollows) {
  const GLuint program = link(bare_source);
  const Pixels pixels = picture([&] {
    hook::ColorMask(*context_, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    draw(program, ball_);
    hook::ColorMask(*context_, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    hook::DepthFunc(*context_, GL_EQUAL);
    draw(program, ball_);
    hook::DepthFunc(*context_, GL_LEQUAL);
  });
  EXPECT_GT(red(pixels), round_pixels);
}

// Another pass has normals, which this pass cannot read.
TEST_F(GeometryNormals, AMeshWithNormalsGetsNoOthers) {
  const GLuint bare = link(bare_source);
  const GLuint with_normals = link(normal_source);
  for (const bool bare_first : {true, false}) {
    const SplitMesh ball = averaged(octahedron());
    const Pixels pixels = picture([&] {
      draw(bare_first ? bare : with_normals, ball, !bare_first);
      draw(bare_first ? with_normals : bare, ball, bare_first);
    });
    EXPECT_NEAR(red(pixels), octahedron_pixels, octahedron_pixels / 50) << bare_first;
  }
}

// A volume that casts a shadow is no surface.
TEST_F(GeometryNormals, WhatNeverShowsIsNotCurved) {
  const GLuint program = link(bare_source);
  const std::uint64_t refined = statistics().draws_refined;
  picture([&] {
    hook::ColorMask(*context_, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    draw(program, ball_);
    hook::ColorMask(*context_, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  });
  EXPECT_EQ(statistics().draws_refined, refined);
}

// The stage may be an impostor's.
TEST_F(GeometryNormals, ABentStageKeepsItsPicture) {
  const GLuint program = link(bent_source);
  const auto draw_ball = [&] { draw(program, ball_); };
  const Pixels coarse = picture(draw_ball, 1);
  EXPECT_EQ(picture(draw_ball), coarse);
}

TEST_F(GeometryNormals, ObjectsOfOneDrawDoNotMatter) {
  const SplitMesh several = rows_of(ball_, 60);  // more triangles than one work group takes
  EXPECT_EQ(picture_of(bare_source, several), picture_of(bare_source, ball_));
}

}  // namespace
}  // namespace glark::core::test
