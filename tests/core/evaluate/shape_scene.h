// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Curved triangles with depth tags, scalar tags and texture coordinates, for tests that link the core without the shim.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "glark/core/context.h"
#include "glark/core/report/statistics.h"
#include "glark/core/stages.h"
#include "glark/gl/hooks.h"
#include "include/GL/glark.h"
#include "tests/core/support/plain_context.h"

namespace glark::core::test {

enum class ShapeKind { uniform, tagged, deep, displaced };

struct SceneVertex {
  std::array<GLfloat, 3> position;
  std::array<GLfloat, 3> normal;
  std::array<GLfloat, 4> discontinuity;
  std::array<GLfloat, 2> coordinate;
  GLfloat tag;
};

class ShapeScene {
 public:
  static constexpr GLsizei vertices = 6;
  static constexpr GLint unit = 2;

  // `dispatch` outlives the scene. Its context is current.
  ShapeScene(const gl::Dispatch& dispatch, ShapeKind kind)
      : gl_(dispatch), context_(Context::create(dispatch, make_share_group(), ContextOptions{})) {
    hook::ARKinit(*context_, kind == ShapeKind::deep ? 9 : 4);
    upload();
    set_parameters(kind);
    hook::Enable(*context_, GL_ARK);
  }
  ~ShapeScene() { context_->release(); }
  ShapeScene(const ShapeScene&) = delete;
  ShapeScene& operator=(const ShapeScene&) = delete;

  Context& context() { return *context_; }
  std::vector<GLubyte> draw_frame() {
    gl_.Clear(GL_COLOR_BUFFER_BIT);
    hook::DrawArrays(*context_, GL_TRIANGLES, 0, vertices);
    std::vector<GLubyte> pixels(static_cast<std::size_t>(4) * plain_side * plain_side);
    gl_.ReadPixels(0, 0, plain_side, plain_side, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    context_->frame_finished();
    return pixels;
  }
  // Returns how many of so many frames are drawn from kept vertices.
  std::uint64_t kept_of(int frames) {
    const std::uint64_t before = statistics().draws_of_kept_vertices;
    for (int frame = 0; frame < frames; ++frame) draw_frame();
    EXPECT_EQ(hook::GetError(*context_), static_cast<GLenum>(GL_NO_ERROR));
    return statistics().draws_of_kept_vertices - before;
  }

 private:
  static const void* offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

  void upload() {
    std::vector<SceneVertex> mesh;
    for (const auto& [x, y] :
         {std::pair{-0.9F, -0.8F}, {0.8F, -0.7F}, {0.1F, 0.1F}, {0.1F, 0.1F}, {0.8F, -0.7F}, {0.7F, 0.9F}}) {
      mesh.push_back({{x, y, 0.2F * x},
                      {0.6F * x, 0.5F * y, 1},
                      {0.3F, 0.2F, -0.5F, 1},
                      {0.5F + x / 2, 0.5F + y / 2},
                      x > 0.5F ? 3.0F : 1.0F});
    }
    GLuint buffer = 0;
    gl_.GenBuffers(1, &buffer);
    hook::BindBuffer(*context_, GL_ARRAY_BUFFER, buffer);
    gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.size() * sizeof(SceneVertex)), mesh.data(),
                   GL_STATIC_DRAW);
    constexpr GLsizei stride = sizeof(SceneVertex);
    hook::VertexPointer(*context_, 3, GL_FLOAT, stride, offset(offsetof(SceneVertex, position)));
    hook::NormalPointer(*context_, GL_FLOAT, stride, offset(offsetof(SceneVertex, normal)));
    hook::TexCoordPointer(*context_, 2, GL_FLOAT, stride, offset(offsetof(SceneVertex, coordinate)));
    hook::VertexAttribPointer(*context_, 14, 4, GL_FLOAT, GL_FALSE, stride,
                              offset(offsetof(SceneVertex, discontinuity)));
    for (const GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY}) {
      hook::EnableClientState(*context_, array);
    }
    hook::EnableVertexAttribArray(*context_, 14);
    hook::Enable(*context_, GL_LIGHTING);
    hook::Enable(*context_, GL_LIGHT0);
  }

  void set_parameters(ShapeKind kind) {
    const bool tagged = kind == ShapeKind::tagged;
    const auto set = [this](GLenum name, GLenum value) {
      hook::ARKParameteriARK(*context_, name, static_cast<GLint>(value));
    };
    set(GL_REFINEMENT_ARK, tagged ? GL_SCALAR_TAGGED_PN_ARK : GL_CURVED_PN_ARK);
    set(GL_DEPTH_SOURCE_ARK, tagged ? GL_DEPTH_TAG_ARK : GL_UNIFORM_DEPTH_ARK);
    set(GL_UNIFORM_DEPTH_LEVEL_ARK, kind == ShapeKind::deep ? 9 : 3);
    if (tagged) {
      hook::DepthTagPointerARK(*context_, GL_FLOAT, sizeof(SceneVertex), offset(offsetof(SceneVertex, tag)));
      hook::Enable(*context_, GL_DEPTH_TAG_ARRAY_ARK);
    }
    if (kind == ShapeKind::displaced) {
      bind_heights();
      set(GL_DISPLACEMENT_UNIT_ARK, unit);
      hook::ARKParameterfARK(*context_, GL_DISPLACEMENT_SCALE_ARK, 0.2F);
    }
  }

  void bind_heights() {
    const std::array<GLubyte, 16> heights{0, 200, 30, 90, 120, 10, 250, 40, 80, 160, 20, 220, 60, 140, 5, 70};
    GLuint texture = 0;
    gl_.GenTextures(1, &texture);
    gl_.ActiveTexture(GL_TEXTURE0 + unit);
    gl_.BindTexture(GL_TEXTURE_2D, texture);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_R8, 4, 4, 0, GL_RED, GL_UNSIGNED_BYTE, heights.data());
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_.ActiveTexture(GL_TEXTURE0);
    context_->textures().bound();
  }

  const gl::Dispatch& gl_;
  std::unique_ptr<Context> context_;
};

}  // namespace glark::core::test
