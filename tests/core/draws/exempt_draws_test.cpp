// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Checks each rule by which transparent refinement leaves draws unrefined. Links the core without the shim, so that
// each test has its own options and reads the counters.
#include <GL/osmesa.h>
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "glark/core/context.h"
#include "glark/gl/dispatch.h"
#include "glark/gl/hooks.h"
#include "include/GL/glark.h"

namespace glark::core {
namespace {

constexpr int side = 64;
gl::Dispatch real;

void* get_proc(void* /*user*/, const char* name) { return reinterpret_cast<void*>(OSMesaGetProcAddress(name)); }

constexpr char modern_vertex[] = "#version 430\nlayout(location = 0) in vec4 p;\nvoid main() { gl_Position = p; }\n";
constexpr char modern_fragment[] = "#version 430\nout vec4 color;\nvoid main() { color = vec4(1.0); }\n";
constexpr char old_vertex[] = "void main() { gl_Position = ftransform(); }\n";
constexpr char old_fragment[] = "void main() { gl_FragColor = vec4(1.0); }\n";

class ExemptDraws : public testing::Test {
 public:
  ExemptDraws(const ExemptDraws&) = delete;
  ExemptDraws& operator=(const ExemptDraws&) = delete;

 protected:
  ExemptDraws() {
    const std::array<int, 7> attributes{
        OSMESA_FORMAT, OSMESA_RGBA, OSMESA_DEPTH_BITS, 24, OSMESA_PROFILE, OSMESA_COMPAT_PROFILE, 0};
    window_ = OSMesaCreateContextAttribs(attributes.data(), nullptr);
    OSMesaMakeCurrent(window_, pixels_.data(), GL_UNSIGNED_BYTE, side, side);
    gl::load(real, get_proc, nullptr);
    start({});
  }
  ~ExemptDraws() override {
    context_->release();
    context_.reset();
    OSMesaDestroyContext(window_);
  }

  void start(ContextOptions options) {
    if (context_ != nullptr) context_->release();
    options.transparent = true;
    options.level = 1;
    context_ = Context::create(real, make_share_group(), options);
  }

  void use(const char* vertex, const char* fragment) {
    const GLuint program = real.CreateProgram();
    for (const auto& [stage, text] : {std::pair(GL_VERTEX_SHADER, vertex), std::pair(GL_FRAGMENT_SHADER, fragment)}) {
      const GLuint shader = real.CreateShader(static_cast<GLenum>(stage));
      real.ShaderSource(shader, 1, &text, nullptr);
      hook::CompileShader(*context_, shader);
      real.AttachShader(program, shader);
    }
    hook::LinkProgram(*context_, program);
    hook::UseProgram(*context_, program);
  }

  void ignore_depth(bool blended) {
    hook::Disable(*context_, GL_DEPTH_TEST);
    (blended ? hook::Enable : hook::Disable)(*context_, GL_BLEND);
  }
  void test_depth(GLenum function = GL_LESS, bool writes = true) {
    hook::Enable(*context_, GL_DEPTH_TEST);
    hook::DepthFunc(*context_, function);
    hook::DepthMask(*context_, writes ? GL_TRUE : GL_FALSE);
  }
  void project(const std::vector<GLfloat>& matrix, GLenum mode = GL_PROJECTION) {
    hook::MatrixMode(*context_, mode);
    real.LoadMatrixf(matrix.data());
    context_->changes().touch_matrices();
  }

  static std::string outcome(const std::array<std::uint64_t, cause_count + 1>& before) {
    std::string text = statistics().draws_refined != before[cause_count] ? "refined" : "";
    for (unsigned i = 0; i < cause_count; ++i)
      if (statistics().passed_through[i] != before[i]) text += text_of(static_cast<Cause>(i)).key;
    return text;
  }
  static std::array<std::uint64_t, cause_count + 1> counts() {
    std::array<std::uint64_t, cause_count + 1> all{};
    for (unsigned i = 0; i < cause_count; ++i) all[i] = statistics().passed_through[i];
    all[cause_count] = statistics().draws_refined;
    return all;
  }

  // Returns "refined", or the cause why the draw was not refined.
  std::string draw(int triangles) {
    const std::vector<GLfloat> vertices(static_cast<std::size_t>(triangles) * 12, 0.25F);
    real.VertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, 0, vertices.data());
    real.EnableVertexAttribArray(0);
    context_->state().arrays().vertex_arrays().forget_current();
    const auto before = counts();
    hook::DrawArrays(*context_, GL_TRIANGLES, 0, triangles * 3);
    return outcome(before);
  }
  std::string draw_immediately(int triangles) {
    const auto before = counts();
    hook::Begin(*context_, GL_TRIANGLES);
    for (int i = 0; i < triangles * 3; ++i) {
      real.Vertex2f(i % 3 == 0 ? -1.0F : 1.0F, i % 3 == 1 ? -1.0F : 1.0F);
      context_->state().immediate().count(3);
    }
    hook::End(*context_);
    return outcome(before);
  }

  inline static const std::vector<GLfloat> identity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  inline static const std::vector<GLfloat> ortho_2d{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1};
  inline static const std::vector<GLfloat> sheet{0.01F, 0, 0, 0, 0, 0.01F, 0, 0, 0, 0, -0.5F, 0, -1, -1, 0.25F, 1};
  inline static const std::vector<GLfloat> ortho_deep{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -0.01F, 0, 0, 0, 0, 1};
  inline static const std::vector<GLfloat> perspective{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, -1, 0, 0, -2, 0};
  inline static const std::vector<GLfloat> turned{1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1};

  std::vector<GLubyte> pixels_ = std::vector<GLubyte>(side * side * 4);
  OSMesaContext window_ = nullptr;
  std::unique_ptr<Context> context_;
};

TEST_F(ExemptDraws, AProgramsDrawsWithDepthAreRefined) {
  use(modern_vertex, modern_fragment);
  test_depth();
  EXPECT_EQ(draw(8), "refined");
  EXPECT_EQ(draw(2), "refined");
}

// A second pass over the same triangles must follow the first.
TEST_F(ExemptDraws, PassesThatMeetByDepthAreRefined) {
  use(modern_vertex, modern_fragment);
  hook::Enable(*context_, GL_BLEND);
  for (const GLenum function : {GL_EQUAL, GL_LEQUAL}) {
    test_depth(function, false);
    EXPECT_EQ(draw(8), "refined");
    EXPECT_EQ(draw(2), "refined");
  }
  test_depth(GL_ALWAYS, true);  // later draws meet the written depth
  EXPECT_EQ(draw(2), "refined");
}

TEST_F(ExemptDraws, FullScreenPassesAreLeft) {
  use(modern_vertex, modern_fragment);
  ignore_depth(false);
  EXPECT_EQ(draw(2), "screen_quad");
  EXPECT_EQ(draw(1), "screen_quad");
  EXPECT_EQ(draw(3), "refined");
  test_depth(GL_ALWAYS, false);
  EXPECT_EQ(draw(2), "screen_quad");
}

TEST_F(ExemptDraws, AFramebufferWithoutDepthTestsNone) {
  use(modern_vertex, modern_fragment);
  test_depth(GL_LEQUAL);
  EXPECT_EQ(draw(2), "refined");
  GLuint framebuffer = 0;
  real.GenFramebuffers(1, &framebuffer);
  std::array<GLuint, 2> targets{};
  real.GenRenderbuffers(2, targets.data());
  hook::BindFramebuffer(*context_, GL_FRAMEBUFFER, framebuffer);
  for (int i = 0; i < 2; ++i) {
    real.BindRenderbuffer(GL_RENDERBUFFER, targets.at(i));
    real.RenderbufferStorage(GL_RENDERBUFFER, i == 0 ? GL_RGBA8 : GL_DEPTH_COMPONENT24, side, side);
  }
  real.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, targets[0]);
  EXPECT_EQ(draw(2), "screen_quad");
  hook::BindFramebuffer(*context_, GL_FRAMEBUFFER, 0);
  EXPECT_EQ(draw(2), "refined");
  hook::BindFramebuffer(*context_, GL_DRAW_FRAMEBUFFER, framebuffer);
  EXPECT_EQ(draw(2), "screen_quad");
  real.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, targets[1]);
  context_->state().attachments_changed();
  EXPECT_EQ(draw(2), "refined");
  hook::BindFramebuffer(*context_, GL_READ_FRAMEBUFFER, 0);
  EXPECT_EQ(draw(2), "refined");
  EXPECT_EQ(real.GetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(ExemptDraws, ARuleLeavesDrawsByTheirState) {
  use(modern_vertex, modern_fragment);
  test_depth();
  context_->options().rules = {{.depth_only = true, .refinement = std::nullopt}};
  EXPECT_EQ(draw(8), "refined");
  hook::ColorMask(*context_, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  EXPECT_EQ(draw(8), "rule");
  hook::ColorMaski(*context_, 0, GL_FALSE, GL_TRUE, GL_FALSE, GL_FALSE);
  EXPECT_EQ(draw(8), "refined");
  context_->options().rules = {{.blend = true, .refinement = std::nullopt}};
  EXPECT_EQ(draw(8), "refined");
  hook::Enable(*context_, GL_BLEND);
  EXPECT_EQ(draw(8), "rule");
  EXPECT_EQ(real.GetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(ExemptDraws, AFramebufferWithoutColourIsDepthOnly) {
  use(modern_vertex, modern_fragment);
  test_depth();
  context_->options().rules = {{.depth_only = true, .refinement = std::nullopt}};
  GLuint framebuffer = 0;
  GLuint depth = 0;
  real.GenFramebuffers(1, &framebuffer);
  real.GenRenderbuffers(1, &depth);
  hook::BindFramebuffer(*context_, GL_FRAMEBUFFER, framebuffer);
  real.BindRenderbuffer(GL_RENDERBUFFER, depth);
  real.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, side, side);
  real.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
  EXPECT_EQ(draw(8), "rule");
  hook::BindFramebuffer(*context_, GL_FRAMEBUFFER, 0);
  EXPECT_EQ(draw(8), "refined");
  real.DrawBuffer(GL_NONE);
  context_->state().framebuffers().forget_attachments();
  EXPECT_EQ(draw(8), "rule");
  EXPECT_EQ(real.GetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(ExemptDraws, ACulledFaceMayHaveLines) {
  use(modern_vertex, modern_fragment);
  test_depth();
  hook::PolygonMode(*context_, GL_BACK, GL_LINE);
  EXPECT_EQ(draw(8), "polygon_mode");
  hook::Enable(*context_, GL_CULL_FACE);
  EXPECT_EQ(draw(8), "refined");
  hook::CullFace(*context_, GL_FRONT);
  EXPECT_EQ(draw(8), "polygon_mode");
  hook::PolygonMode(*context_, GL_FRONT_AND_BACK, GL_FILL);
  EXPECT_EQ(draw(8), "refined");
  EXPECT_EQ(real.GetError(), static_cast<GLenum>(GL_NO_ERROR));
}

// Indirect draws read their commands anyway; unchanged ones are captured once.
TEST_F(ExemptDraws, UnchangedIndirectDrawsAreKept) {
  use(modern_vertex, modern_fragment);
  test_depth();
  std::array<GLuint, 2> buffers{};
  real.GenBuffers(2, buffers.data());
  const std::vector<GLfloat> vertices(24 * 4, 0.25F);
  hook::BindBuffer(*context_, GL_ARRAY_BUFFER, buffers[0]);
  real.BufferData(GL_ARRAY_BUFFER, 24 * 16, vertices.data(), GL_STATIC_DRAW);
  hook::VertexAttribPointer(*context_, 0, 4, GL_FLOAT, GL_FALSE, 0, nullptr);
  hook::EnableVertexAttribArray(*context_, 0);
  const std::array<GLuint, 8> commands{12, 1, 0, 0, 12, 1, 12, 0};
  hook::BindBuffer(*context_, GL_DRAW_INDIRECT_BUFFER, buffers[1]);
  real.BufferData(GL_DRAW_INDIRECT_BUFFER, sizeof(commands), commands.data(), GL_STATIC_DRAW);
  const std::uint64_t reused = statistics().captures_reused;
  for (int i = 0; i < 5; ++i) hook::MultiDrawArraysIndirect(*context_, GL_TRIANGLES, nullptr, 2, 0);
  EXPECT_EQ(statistics().captures_reused, reused + 3);
  EXPECT_EQ(real.GetError(), static_cast<GLenum>(GL_NO_ERROR));
}

// Interpolated values of the whole triangle and values that cull the whole triangle cannot be had at once.
TEST_F(ExemptDraws, CullDistancesThatAreReadAreLeft) {
  const std::string extension = "#version 430\n#extension GL_ARB_cull_distance : require\n";
  const std::string vertex = extension +
                             "layout(location = 0) in vec4 p; out float gl_CullDistance[1];\n"
                             "void main() { gl_Position = p; gl_CullDistance[0] = p.x; }\n";
  const std::string fragment = extension +
                               "in float gl_CullDistance[1]; out vec4 color;\n"
                               "void main() { color = vec4(gl_CullDistance[0]); }\n";
  test_depth();
  use(vertex.c_str(), fragment.c_str());
  EXPECT_EQ(draw(8), "cull_distance");
  use(vertex.c_str(), modern_fragment);
  EXPECT_EQ(draw(8), "refined");
}

TEST_F(ExemptDraws, OverlaysAreLeft) {
  use(modern_vertex, modern_fragment);
  ignore_depth(true);
  EXPECT_EQ(draw(100), "overlay");
  real.Disablei(GL_BLEND, 0);
  hook::Disablei(*context_, GL_BLEND, 0);
  EXPECT_EQ(draw(100), "refined");
}

TEST_F(ExemptDraws, ImmediateQuadsAreLeftWhenTheyAreCounted) {
  use(modern_vertex, modern_fragment);
  ignore_depth(false);
  EXPECT_EQ(draw_immediately(2), "screen_quad");
  EXPECT_EQ(draw_immediately(3), "refined");
  EXPECT_EQ(real.GetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(ExemptDraws, ThePopOfAttributesIsSeen) {
  use(modern_vertex, modern_fragment);
  test_depth();
  hook::PushAttrib(*context_, GL_ENABLE_BIT);
  ignore_depth(false);
  EXPECT_EQ(draw(2), "screen_quad");
  hook::PopAttrib(*context_);
  EXPECT_EQ(draw(2), "refined");
}

TEST_F(ExemptDraws, TheFixedFunctionIsLeftWithoutPerspectiveAndDepth) {
  ignore_depth(true);
  project(ortho_deep);
  EXPECT_EQ(draw_immediately(8), "overlay");
  ignore_depth(false);
  EXPECT_EQ(draw_immediately(8), "orthographic");
  test_depth();
  EXPECT_EQ(draw_immediately(8), "refined");
}

TEST_F(ExemptDraws, WhatIsDrawnInPerspectiveIsRefined) {
  project(perspective);
  ignore_depth(true);
  EXPECT_EQ(draw_immediately(8), "refined");
  EXPECT_EQ(draw_immediately(2), "refined");
  use(old_vertex, old_fragment);  // it reads the same matrix
  EXPECT_EQ(draw_immediately(8), "refined");
  project(ortho_deep);
  EXPECT_EQ(draw_immediately(8), "overlay");
}

TEST_F(ExemptDraws, DrawingsInThePlaneAreLeftWithDepthToo) {
  test_depth();
  project(ortho_2d);
  project(identity, GL_MODELVIEW);
  EXPECT_EQ(draw_immediately(8), "orthographic");
  hook::Enable(*context_, GL_BLEND);
  test_depth(GL_EQUAL, false);
  EXPECT_EQ(draw_immediately(8), "orthographic") << "passes meet";
  project(turned, GL_MODELVIEW);
  EXPECT_EQ(draw_immediately(8), "refined");
  project(identity, GL_MODELVIEW);
  project(sheet);  // a scene graph's near and far planes about it
  EXPECT_EQ(draw_immediately(8), "orthographic");
  project(ortho_deep);
  EXPECT_EQ(draw_immediately(8), "refined");
  project(identity);  // a program that has set no matrix at all
  EXPECT_EQ(draw_immediately(8), "refined");
}

TEST_F(ExemptDraws, OneRuleAloneHolds) {
  start({.left_draws = left_draws::overlays});
  use(modern_vertex, modern_fragment);
  ignore_depth(false);
  EXPECT_EQ(draw(2), "refined");
  ignore_depth(true);
  EXPECT_EQ(draw(2), "overlay");
}

TEST_F(ExemptDraws, TheUsersRulesHold) {
  for (const auto& [bits, depth, key] :
       {std::tuple(left_draws::blended, true, "blended"), std::tuple(left_draws::no_depth_test, false, "no_depth_test"),
        std::tuple(left_draws::no_depth_writes, false, "no_depth_writes")}) {
    start({.left_draws = bits});
    use(modern_vertex, modern_fragment);
    ignore_depth(true);
    if (depth) test_depth();
    EXPECT_EQ(draw(8), key);
    ignore_depth(false);
    test_depth();
    EXPECT_EQ(draw(8), "refined") << key;
  }
}

TEST_F(ExemptDraws, AShaderProgramIsLeftByItsHash) {
  const auto source = [](const char* text) { return std::make_shared<const std::string>(text); };
  const std::uint64_t hash =
      source_hash({{GL_FRAGMENT_SHADER, source(modern_fragment)}, {GL_VERTEX_SHADER, source(modern_vertex)}});
  start({.left_shaders = {1, hash}});
  test_depth();
  use(modern_vertex, modern_fragment);
  EXPECT_EQ(draw(8), "left_shader");
  use(old_vertex, old_fragment);
  EXPECT_EQ(draw(8), "refined");
}

TEST_F(ExemptDraws, NothingIsLeftWithoutRules) {
  start({.left_draws = 0});
  ignore_depth(true);
  EXPECT_EQ(draw_immediately(2), "refined");
  use(modern_vertex, modern_fragment);
  EXPECT_EQ(draw(2), "refined");
}

TEST_F(ExemptDraws, AProgramThatEnablesTheExtensionIsNeverExempt) {
  context_->ark().pool_level = 4;
  hook::Enable(*context_, GL_ARK);
  use(modern_vertex, modern_fragment);
  ignore_depth(true);
  EXPECT_EQ(draw(2), "refined");
}

TEST(SourceHash, IsTheSameInEveryVersion) {
  const auto text = std::make_shared<const std::string>("void main() {}");
  EXPECT_EQ(hash_text(source_hash({})), "cbf29ce484222325");
  EXPECT_EQ(hash_text(source_hash({{GL_VERTEX_SHADER, text}})), "d1098884e0dc9531");
}

// The two triangles of a quad, or the four about its centre, become four triangles each.
TEST_F(ExemptDraws, QuadsAreSplitAtTheirCentresOnRequest) {
  for (const bool centroids : {false, true}) {
    start({.centroids = centroids});
    test_depth();
    const std::uint64_t before = statistics().refined_triangles;
    hook::Begin(*context_, GL_QUADS);
    for (const auto& [x, y] : {std::pair(-1.0F, -1.0F), {1.0F, -1.0F}, {1.0F, 1.0F}, {-1.0F, 1.0F}}) {
      real.Vertex2f(x, y);
      context_->state().immediate().count(3);
    }
    hook::End(*context_);
    EXPECT_EQ(statistics().refined_triangles - before, centroids ? 16U : 8U);
  }
}

}  // namespace
}  // namespace glark::core
