// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// OpenGL ES 3.2 through EGL without a surface: refinement by tags and by a uniform depth, errors, and kept captures.
#include <GLES3/gl32.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "include/GL/glark.h"
#include "tests/clients/scene/egl_display.h"

namespace glark::core::test {
namespace {

constexpr int size = 64;

const char* const vertex_shader =
    "#version 320 es\nlayout(location = 0) in vec2 position; layout(location = 1) in vec3 color; uniform vec2 scale; "
    "out vec3 c;\n"
    "void main() { gl_Position = vec4(position * scale, 0.0, 1.0); c = color; }\n";
const char* const fragment_shader =
    "#version 320 es\nprecision highp float; in vec3 c; out vec4 result;\nvoid main() { result = vec4(c, 1.0); }\n";

class Es : public testing::Test {
 protected:
  void SetUp() override {
    display_ = open_egl_display();
    if (display_ == EGL_NO_DISPLAY) GTEST_SKIP() << "no EGL";
    eglBindAPI(EGL_OPENGL_ES_API);
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 2, EGL_NONE};
    context_ = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    if (eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE)
      GTEST_SKIP() << "no OpenGL ES 3.2";
    bind_framebuffer();
    link_program();
    upload();
  }
  void TearDown() override {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
  }
  static void bind_framebuffer() {
    GLuint framebuffer = 0;
    GLuint color = 0;
    glGenFramebuffers(1, &framebuffer);
    glGenRenderbuffers(1, &color);
    glBindRenderbuffer(GL_RENDERBUFFER, color);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, size, size);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color);
    glViewport(0, 0, size, size);
  }
  static void attach(GLuint program, GLenum stage, const char* source) {
    const GLuint shader = glCreateShader(stage);
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    glAttachShader(program, shader);
  }
  void link_program() {
    program_ = glCreateProgram();
    attach(program_, GL_VERTEX_SHADER, vertex_shader);
    attach(program_, GL_FRAGMENT_SHADER, fragment_shader);
    const char* const varyings[] = {"gl_Position"};
    glTransformFeedbackVaryings(program_, 1, varyings, GL_INTERLEAVED_ATTRIBS);
    glLinkProgram(program_);
    GLint linked = GL_FALSE;
    glGetProgramiv(program_, GL_LINK_STATUS, &linked);
    ASSERT_EQ(linked, GL_TRUE);
    glUseProgram(program_);
    glUniform2f(glGetUniformLocation(program_, "scale"), 0.9F, 0.8F);
  }
  void upload() {
    const GLfloat data[] = {-1, -1, 1, 0, 0, 1, -1, 0, 1, 0, -1, 1, 0, 0, 1, 1, 1, 1, 1, 0};
    const GLubyte tags[] = {3, 1, 1, 2};
    const GLushort indices[] = {0, 1, 2, 3, 0xFFFF, 0, 1, 3};
    GLuint buffers[3] = {};
    GLuint array = 0;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glGenBuffers(3, buffers);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[2]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof(indices), indices, GL_STATIC_DRAW);
    glBindBuffer(GL_ARRAY_BUFFER, buffers[1]);
    glBufferData(GL_ARRAY_BUFFER, sizeof(tags), tags, GL_STATIC_DRAW);
    glDepthTagPointerARK(GL_UNSIGNED_BYTE, 0, nullptr);
    glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    glBufferData(GL_ARRAY_BUFFER, sizeof(data), data, GL_STATIC_DRAW);
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 20, nullptr);
    glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, 20, reinterpret_cast<const void*>(8));
    glEnableVertexAttribArray(0);
    glEnableVertexAttribArray(1);
  }
  template <typename Draw>
  static std::vector<GLubyte> picture_of(Draw&& draw, GLuint& triangles) {
    GLuint query = 0;
    glGenQueries(1, &query);
    glClear(GL_COLOR_BUFFER_BIT);
    glBeginQuery(GL_PRIMITIVES_GENERATED, query);
    draw();
    glEndQuery(GL_PRIMITIVES_GENERATED);
    glGetQueryObjectuiv(query, GL_QUERY_RESULT, &triangles);
    glDeleteQueries(1, &query);
    std::vector<GLubyte> picture(4 * size * size);
    glReadPixels(0, 0, size, size, GL_RGBA, GL_UNSIGNED_BYTE, picture.data());
    return picture;
  }
  static int differing_pixels(const std::vector<GLubyte>& a, const std::vector<GLubyte>& b) {
    int count = 0;
    for (std::size_t i = 0; i < a.size(); i += 4)
      count += std::memcmp(&a[i], &b[i], 4) != 0 && std::abs(a[i] - b[i]) > 2 ? 1 : 0;
    return count;
  }
  template <typename Draw>
  void expect_same_picture(GLuint refined_triangles, Draw&& draw) {
    GLuint triangles = 0;
    glDisable(GL_ARK);
    const std::vector<GLubyte> plain = picture_of(draw, triangles);
    EXPECT_GT(differing_pixels(plain, std::vector<GLubyte>(plain.size())), size * size / 8);
    glEnable(GL_ARK);
    EXPECT_LE(differing_pixels(plain, picture_of(draw, triangles)), size * size / 200);
    EXPECT_EQ(triangles, refined_triangles);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  }
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
  GLuint program_ = 0;
};

void draw_strip() { glDrawArrays(GL_TRIANGLE_STRIP, 0, 4); }

TEST_F(Es, SeparateProgramsInAPipeline) {
  const char* const source =
      "#version 320 es\nlayout(location = 0) in vec2 position; layout(location = 1) in vec3 color; uniform vec2 scale; "
      "layout(location = 3) out vec3 c;\nvoid main() { gl_Position = vec4(position * scale, 0.0, 1.0); c = color; }\n";
  const char* const shading =
      "#version 320 es\nprecision highp float; layout(location = 3) in vec3 c; out vec4 result;\n"
      "void main() { result = vec4(c, 1.0); }\n";
  const GLuint vertex = glCreateShaderProgramv(GL_VERTEX_SHADER, 1, &source);
  const GLuint fragment = glCreateShaderProgramv(GL_FRAGMENT_SHADER, 1, &shading);
  GLuint pipeline = 0;
  glGenProgramPipelines(1, &pipeline);
  glUseProgramStages(pipeline, GL_VERTEX_SHADER_BIT, vertex);
  glUseProgramStages(pipeline, GL_FRAGMENT_SHADER_BIT, fragment);
  glActiveShaderProgram(pipeline, vertex);
  glUseProgram(0);
  glBindProgramPipeline(pipeline);
  glARKinit(2);
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 2);
  for (const GLfloat height : {0.9F, 0.6F}) {
    glUniform2f(glGetUniformLocation(vertex, "scale"), 0.8F, height);
    expect_same_picture(2 * 16, draw_strip);
  }
}

TEST_F(Es, ExtensionAndLevel) {
  const std::string extensions = reinterpret_cast<const char*>(glGetString(GL_EXTENSIONS));
  EXPECT_NE(extensions.find("GL_ARK_adaptive_refinement"), std::string::npos);
  GLint level = -9;
  glGetIntegerv(GL_POOL_LEVEL_ARK, &level);
  EXPECT_EQ(level, -1);
  glARKinit(12);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_VALUE));
  glEnable(GL_ARK);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
  glARKinit(3);
  glDrawARP(0x0007, 0, 4);  // GL_QUADS
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_ENUM));
  glGetRefinementivARK(0, GL_REFINEMENT_STATUS_ARK, &level);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_VALUE));
}

TEST_F(Es, UniformDepth) {
  glARKinit(3);
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 3);
  for (const GLint refinement : {GL_LINEAR_INPUTS_ARK, GL_LINEAR_OUTPUTS_ARK}) {
    glARKParameteriARK(GL_REFINEMENT_ARK, refinement);
    expect_same_picture(2 * 64, draw_strip);
    expect_same_picture(4 * 64, [] { glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, 2); });
    expect_same_picture(2 * 64, [] { glDrawElements(GL_TRIANGLE_STRIP, 4, GL_UNSIGNED_SHORT, nullptr); });
  }
}

TEST_F(Es, RestartAtTheFixedIndex) {
  glARKinit(2);
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 2);
  glEnable(GL_PRIMITIVE_RESTART_FIXED_INDEX);
  expect_same_picture(3 * 16, [] { glDrawElements(GL_TRIANGLE_STRIP, 8, GL_UNSIGNED_SHORT, nullptr); });
}

TEST_F(Es, TagsFromAnArray) {
  glARKinit(4);
  glEnable(GL_DEPTH_TAG_ARRAY_ARK);
  expect_same_picture(8 + 4, draw_strip);  // tags 3 1 1: depths 2 1 2; tags 1 1 2: depths 1 1 1
}

TEST_F(Es, MeasuredDepths) {
  glARKinit(4);
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK);
  glARKParameteriARK(GL_EDGE_PIXELS_ARK, 16);
  // 57.6 and 51.2 pixels, the diagonal 77.1: depths 2, 2 and 3, and one less in a viewport of half the size.
  expect_same_picture(2 * 20, draw_strip);
  glViewport(0, 0, size / 2, size / 2);
  expect_same_picture(2 * 6, draw_strip);
}

// Depths between two levels: as many triangles as the finer level, except for corners and the middle, which are cut in
// another way.
TEST_F(Es, Geomorphing) {
  glARKinit(4);
  glARKParameteriARK(GL_GEOMORPH_ARK, GL_TRUE);
  GLint attribute = 0;
  glGetIntegerv(GL_DEPTH_TAG_ATTRIBUTE_ARK, &attribute);
  for (const GLfloat tag : {1.25F, 1.75F, 2.0F}) {
    glVertexAttrib1f(static_cast<GLuint>(attribute), tag);
    expect_same_picture(2 * 16, draw_strip);
  }
  for (const GLfloat tag : {0.5F, 1.0F}) {
    glVertexAttrib1f(static_cast<GLuint>(attribute), tag);
    expect_same_picture(2 * 6, draw_strip);
  }
  glDepthTag1i(1);  // cut like a fraction, not as a uniform pattern
  expect_same_picture(2 * 6, draw_strip);
}

// The middle of an edge is half way from the middle of its ends to its own place. The vertex stage squares positions.
TEST_F(Es, GeomorphingMovesVertices) {
  const GLuint bent = glCreateProgram();
  attach(bent, GL_VERTEX_SHADER,
         "#version 320 es\nlayout(location = 0) in vec2 position;\n"
         "void main() { gl_Position = vec4(position * position, position.x * position.y, 1.0); }\n");
  attach(bent, GL_FRAGMENT_SHADER,
         "#version 320 es\nprecision highp float; out vec4 result; void main() { result = vec4(1.0); }\n");
  const char* const varyings[] = {"gl_Position"};
  glTransformFeedbackVaryings(bent, 1, varyings, GL_INTERLEAVED_ATTRIBS);
  glLinkProgram(bent);
  glUseProgram(bent);
  glARKinit(4);
  glARKParameteriARK(GL_GEOMORPH_ARK, GL_TRUE);
  glEnable(GL_ARK);
  GLint attribute = 0;
  glGetIntegerv(GL_DEPTH_TAG_ATTRIBUTE_ARK, &attribute);
  glVertexAttrib1f(static_cast<GLuint>(attribute), 0.5F);
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
  constexpr std::size_t vertices = 3 * 6;
  glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, vertices * 16, nullptr, GL_STREAM_READ);
  glBeginTransformFeedback(GL_TRIANGLES);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glEndTransformFeedback();
  const void* mapped = glMapBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, vertices * 16, GL_MAP_READ_BIT);
  ASSERT_NE(mapped, nullptr);
  std::array<std::array<GLfloat, 4>, vertices> refined{};
  std::memcpy(refined.data(), mapped, sizeof(refined));
  glUnmapBuffer(GL_TRANSFORM_FEEDBACK_BUFFER);
  // From (-1, -1) to (1, -1): the ends go to (1, 1, 1) and (1, 1, -1), their middle to (0, 1, 0).
  const std::array<GLfloat, 4> halfway{0.5F, 1, 0, 1};
  EXPECT_EQ(std::count(refined.begin(), refined.end(), halfway), 2);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(Es, CurrentTag) {
  glARKinit(4);
  glDepthTag1i(2);
  expect_same_picture(2 * 16, draw_strip);
}

// A shared edge in both orientations: every refined edge inside the square has a partner with the same bits.
TEST_F(Es, NoCracks) {
  glARKinit(4);
  glEnable(GL_ARK);
  glEnable(GL_DEPTH_TAG_ARRAY_ARK);
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
  constexpr std::size_t triangles = 12;
  glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, triangles * 48, nullptr, GL_STREAM_READ);
  const GLushort indices[] = {0, 1, 2, 2, 1, 3};
  glBufferSubData(GL_ELEMENT_ARRAY_BUFFER, 0, sizeof(indices), indices);
  glBeginTransformFeedback(GL_TRIANGLES);
  glDrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_SHORT, nullptr);
  glEndTransformFeedback();
  const auto* vertices =
      static_cast<const GLubyte*>(glMapBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, triangles * 48, GL_MAP_READ_BIT));
  ASSERT_NE(vertices, nullptr);
  using Vertex = std::array<GLfloat, 4>;
  std::map<std::pair<Vertex, Vertex>, int> edges;
  for (std::size_t i = 0; i < 3 * triangles; ++i) {
    Vertex a{};
    Vertex b{};
    std::memcpy(a.data(), vertices + 16 * i, 16);
    std::memcpy(b.data(), vertices + 16 * (i % 3 == 2 ? i - 2 : i + 1), 16);
    ++edges[{a, b}];
  }
  int open = 0;
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    open += edges.count({edge.second, edge.first}) == 0 ? 1 : 0;
  }
  EXPECT_EQ(open, 4 + 4 + 2 + 2) << "the border of the square: depths 2, 2, 1 and 1";
  glUnmapBuffer(GL_TRANSFORM_FEEDBACK_BUFFER);
}

TEST_F(Es, BindingsAreKept) {
  GLuint buffers[3] = {};
  glGenBuffers(3, buffers);
  for (GLuint i = 0; i < 3; ++i) {
    glBindBuffer(GL_COPY_READ_BUFFER, buffers[i]);
    glBufferData(GL_COPY_READ_BUFFER, 1024, nullptr, GL_STATIC_DRAW);
    glBindBufferRange(GL_SHADER_STORAGE_BUFFER, i, buffers[i], 0, 512);
  }
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, buffers[1]);
  glARKinit(4);
  glEnable(GL_ARK);
  glEnable(GL_DEPTH_TAG_ARRAY_ARK);
  const auto values = [] {
    std::vector<GLint64> result;
    for (GLuint i = 0; i < 3; ++i) {
      for (const GLenum name :
           {GL_SHADER_STORAGE_BUFFER_BINDING, GL_SHADER_STORAGE_BUFFER_START, GL_SHADER_STORAGE_BUFFER_SIZE}) {
        glGetInteger64i_v(name, i, &result.emplace_back());
      }
    }
    for (const GLenum name :
         {GL_DRAW_INDIRECT_BUFFER_BINDING, GL_VERTEX_ARRAY_BINDING, GL_CURRENT_PROGRAM, GL_ARRAY_BUFFER_BINDING,
          GL_ELEMENT_ARRAY_BUFFER_BINDING, GL_TRANSFORM_FEEDBACK_BINDING, GL_TRANSFORM_FEEDBACK_BUFFER_BINDING,
          GL_SHADER_STORAGE_BUFFER_BINDING, GL_RASTERIZER_DISCARD, GL_COPY_READ_BUFFER_BINDING}) {
      glGetInteger64v(name, &result.emplace_back());
    }
    return result;
  };
  const std::vector<GLint64> before = values();
  GLuint triangles = 0;
  for (int i = 0; i < 2; ++i) {
    picture_of(draw_strip, triangles);
    EXPECT_EQ(triangles, 12U);
    EXPECT_EQ(before, values());
  }
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

}  // namespace
}  // namespace glark::core::test
