// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Flat colours of quads and polygons on a GL whose captured triangles do not end with the provoking vertex. NVIDIA (580)
// captures (0, 1, 2) and (0, 2, 3) of a quad under either convention. Here the captures of OSMesa do so.
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <vector>

#include "glark/core/context.h"
#include "glark/core/report/statistics.h"
#include "glark/core/stages.h"
#include "glark/gl/hooks.h"
#include "tests/core/support/plain_context.h"

namespace glark::core::test {
namespace {

const gl::Dispatch* real = nullptr;

void begin_as_first(GLenum mode) {
  real->ProvokingVertex(GL_FIRST_VERTEX_CONVENTION);
  real->BeginTransformFeedback(mode);
}
void end_as_last() {
  real->EndTransformFeedback();
  real->ProvokingVertex(GL_LAST_VERTEX_CONVENTION);
}

struct Vertex {
  std::array<GLfloat, 2> position;
  std::array<GLubyte, 4> color;
};
using Picture = std::vector<GLubyte>;

class ProvokingVertex : public testing::TestWithParam<GLenum> {
 protected:
  ProvokingVertex() : strange_(window_.gl) {
    real = &window_.gl;
    strange_.BeginTransformFeedback = begin_as_first;
    strange_.EndTransformFeedback = end_as_last;
    options_.transparent = true;
    options_.level = 2;
    options_.refinement = Refinement::linear_outputs;
    options_.left_draws = 0;
    context_ = Context::create(strange_, make_share_group(), options_);
    hook::ShadeModel(*context_, GL_FLAT);
    window_.gl.EnableClientState(GL_VERTEX_ARRAY);
    window_.gl.EnableClientState(GL_COLOR_ARRAY);
    window_.gl.VertexPointer(2, GL_FLOAT, sizeof(Vertex), vertices_[0].position.data());
    window_.gl.ColorPointer(4, GL_UNSIGNED_BYTE, sizeof(Vertex), vertices_[0].color.data());
  }
  ~ProvokingVertex() override {
    context_->release();
    context_.reset();
  }

  Picture picture(bool refined) {
    window_.gl.Clear(GL_COLOR_BUFFER_BIT);
    if (refined) {
      context_->state().refresh();
      hook::DrawArrays(*context_, GetParam(), 0, static_cast<GLsizei>(vertices_.size()));
    } else {
      window_.gl.DrawArrays(GetParam(), 0, static_cast<GLsizei>(vertices_.size()));
    }
    Picture pixels(std::size_t{4} * plain_side * plain_side);
    window_.gl.ReadPixels(0, 0, plain_side, plain_side, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    return pixels;
  }

  // Two rows of vertices: a strip of quads, which are convex as a polygon too. Every vertex has a colour of its own.
  std::vector<Vertex> vertices_ = make_vertices();
  PlainContext window_;
  gl::Dispatch strange_;
  ContextOptions options_;
  std::unique_ptr<Context> context_;

 private:
  static std::vector<Vertex> make_vertices() {
    const bool strip = GetParam() == GL_QUAD_STRIP;
    std::vector<Vertex> all;
    for (int i = 0; i < 8; ++i) {
      const auto n = static_cast<GLfloat>(strip ? i / 2 : i % 4);
      const bool upper = strip ? i % 2 == 1 : n > 1;
      const GLfloat along = strip ? 0.5F * n - 0.75F : (n == 1 || n == 2 ? 0.4F : -0.4F) + (i < 4 ? -0.5F : 0.5F);
      const auto shade = static_cast<GLubyte>(30 * i + 20);
      all.push_back({{along, upper ? 0.75F : -0.75F}, {shade, static_cast<GLubyte>(255 - shade), 90, 255}});
    }
    if (GetParam() == GL_POLYGON) all.resize(4);
    return all;
  }
};

TEST_P(ProvokingVertex, GivesTheColour) {
  const Picture plain = picture(false);
  const std::uint64_t before = statistics().refined_triangles;
  for (int again = 0; again < 8; ++again) EXPECT_EQ(picture(true), plain) << "draw " << again;
  EXPECT_GT(statistics().refined_triangles, before) << "the draws were refined";
}

INSTANTIATE_TEST_SUITE_P(Modes, ProvokingVertex, testing::Values(GL_QUADS, GL_QUAD_STRIP, GL_POLYGON),
                         [](const auto& mode) {
                           return mode.param == GL_QUADS ? "Quads" : mode.param == GL_POLYGON ? "Polygon" : "QuadStrip";
                         });

}  // namespace
}  // namespace glark::core::test
