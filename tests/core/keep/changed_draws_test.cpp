// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Unchanged draws may reuse captures. Every change of their vertices must be seen. Each test draws twice, so that a
// capture is kept, and changes the source in one way. Then it compares with the unrefined picture, or counts captures.
#include <thread>

#include "tests/core/support/kept_scene.h"

namespace glark::core::test {
namespace {

class ChangedDraws : public KeptScene {};

INSTANTIATE_TEST_SUITE_P(All, ChangedDraws, testing::Values(Profile::compatibility, Profile::core), profile_name);

TEST_P(ChangedDraws, BufferSubData) {
  expect_seen(draw_arrays, [] { glBufferSubData(GL_ARRAY_BUFFER, 0, bytes, two().data()); });
}

TEST_P(ChangedDraws, BufferData) {
  expect_seen(draw_elements, [] { glBufferData(GL_ARRAY_BUFFER, bytes, two().data(), GL_STATIC_DRAW); });
}

TEST_P(ChangedDraws, Map) {
  expect_seen(draw_arrays, [] {
    void* memory = glMapBuffer(GL_ARRAY_BUFFER, GL_WRITE_ONLY);
    std::copy_n(two().data(), 6, static_cast<ColoredVertex*>(memory));
    glUnmapBuffer(GL_ARRAY_BUFFER);
  });
}

TEST_P(ChangedDraws, MapRangeWithFlush) {
  expect_seen(draw_arrays, [] {
    void* memory = glMapBufferRange(GL_ARRAY_BUFFER, 0, bytes, GL_MAP_WRITE_BIT | GL_MAP_FLUSH_EXPLICIT_BIT);
    std::copy_n(two().data(), 6, static_cast<ColoredVertex*>(memory));
    glFlushMappedBufferRange(GL_ARRAY_BUFFER, 0, bytes);
    glUnmapBuffer(GL_ARRAY_BUFFER);
  });
}

// The buffer is written while it stays mapped, which glark cannot see.
TEST_P(ChangedDraws, PersistentMap) {
  const GLuint buffer = make_buffer(GL_ARRAY_BUFFER, std::vector<GLubyte>());
  glDeleteBuffers(1, &buffer);
  GLuint storage = 0;
  glGenBuffers(1, &storage);
  glBindBuffer(GL_ARRAY_BUFFER, storage);
  const GLbitfield flags = GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
  glBufferStorage(GL_ARRAY_BUFFER, bytes, one().data(), flags);
  auto* memory = static_cast<ColoredVertex*>(glMapBufferRange(GL_ARRAY_BUFFER, 0, bytes, flags));
  point_generic_arrays(nullptr);
  expect_seen(draw_arrays, [memory] { std::copy_n(two().data(), 6, memory); });
}

TEST_P(ChangedDraws, CopyBuffer) {
  make_buffer(GL_COPY_READ_BUFFER, two());
  expect_seen(draw_arrays, [] { glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_ARRAY_BUFFER, 0, 0, bytes); });
}

TEST_P(ChangedDraws, ClearBuffer) {
  const auto clear = proc<PFNGLCLEARBUFFERSUBDATAPROC>("glClearBufferSubData");
  expect_seen(draw_arrays, [clear] {
    const GLfloat zero[2] = {0, 0};
    clear(GL_ARRAY_BUFFER, GL_RG32F, 40, 8, GL_RG, GL_FLOAT, zero);
  });
}

TEST_P(ChangedDraws, NamedBufferSubData) {
  const auto write = proc<PFNGLNAMEDBUFFERSUBDATAPROC>("glNamedBufferSubData");
  ASSERT_NE(write, nullptr);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  expect_seen(draw_arrays, [this, write] { write(vertices_, 0, bytes, two().data()); });
}

TEST_P(ChangedDraws, NamedBuffersOfEveryKind) {
  const auto data = proc<PFNGLNAMEDBUFFERDATAPROC>("glNamedBufferData");
  const auto map = proc<PFNGLMAPNAMEDBUFFERRANGEPROC>("glMapNamedBufferRange");
  const auto unmap = proc<PFNGLUNMAPNAMEDBUFFERPROC>("glUnmapNamedBuffer");
  const auto copy = proc<PFNGLCOPYNAMEDBUFFERSUBDATAPROC>("glCopyNamedBufferSubData");
  const auto clear = proc<PFNGLCLEARNAMEDBUFFERSUBDATAPROC>("glClearNamedBufferSubData");
  const GLuint source = make_buffer(GL_ARRAY_BUFFER, two());
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  expect_captured_again(draw_arrays, [&] { data(vertices_, bytes, two().data(), GL_STATIC_DRAW); });
  expect_captured_again(draw_arrays, [&] {
    map(vertices_, 0, bytes, GL_MAP_WRITE_BIT);
    unmap(vertices_);
  });
  expect_captured_again(draw_arrays, [&] { copy(source, vertices_, 0, 0, bytes); });
  expect_captured_again(draw_arrays, [&] { clear(vertices_, GL_R32F, 0, 4, GL_RED, GL_FLOAT, nullptr); });
  expect_captured_again(draw_arrays, [&] { glInvalidateBufferSubData(vertices_, 0, 4); });
  expect_captured_again(draw_arrays, [&] { glInvalidateBufferData(vertices_); });
}

// These functions are from EXT_direct_state_access.
TEST_P(ChangedDraws, NamedBuffersOfTheExtension) {
  if (GetParam() == Profile::core) GTEST_SKIP() << "compatibility contexts only";
  const auto data = proc<PFNGLNAMEDBUFFERDATAEXTPROC>("glNamedBufferDataEXT");
  const auto sub_data = proc<PFNGLNAMEDBUFFERSUBDATAEXTPROC>("glNamedBufferSubDataEXT");
  const auto map = proc<PFNGLMAPNAMEDBUFFEREXTPROC>("glMapNamedBufferEXT");
  const auto unmap = proc<PFNGLUNMAPNAMEDBUFFEREXTPROC>("glUnmapNamedBufferEXT");
  const auto copy = proc<PFNGLNAMEDCOPYBUFFERSUBDATAEXTPROC>("glNamedCopyBufferSubDataEXT");
  const GLuint source = make_buffer(GL_ARRAY_BUFFER, two());
  expect_captured_again(draw_arrays, [&] { data(vertices_, bytes, two().data(), GL_STATIC_DRAW); });
  expect_captured_again(draw_arrays, [&] { sub_data(vertices_, 0, 4, two().data()); });
  expect_captured_again(draw_arrays, [&] {
    map(vertices_, GL_WRITE_ONLY);
    unmap(vertices_);
  });
  expect_captured_again(draw_arrays, [&] { copy(source, vertices_, 0, 0, bytes); });
}

TEST_P(ChangedDraws, PixelsReadIntoTheBuffer) {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  const std::vector<ColoredVertex> vertices = two();
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, 30, 1, 0, GL_RED, GL_FLOAT, vertices.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  expect_captured_again(draw_arrays, [this] {
    glBindBuffer(GL_PIXEL_PACK_BUFFER, vertices_);
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  });
  glBufferSubData(GL_ARRAY_BUFFER, 0, bytes, one().data());
  expect_seen(draw_arrays, [this] {
    glBindBuffer(GL_PIXEL_PACK_BUFFER, vertices_);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RED, GL_FLOAT, nullptr);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  });
}

TEST_P(ChangedDraws, QueryResultInTheBuffer) {
  GLuint query = 0;
  glGenQueries(1, &query);
  glBeginQuery(GL_SAMPLES_PASSED, query);
  glEndQuery(GL_SAMPLES_PASSED);
  expect_captured_again(draw_arrays, [&] {
    glBindBuffer(GL_QUERY_BUFFER, vertices_);
    glGetQueryObjectuiv(query, GL_QUERY_RESULT, nullptr);
    glBindBuffer(GL_QUERY_BUFFER, 0);
  });
  const auto to_buffer = proc<PFNGLGETQUERYBUFFEROBJECTUIVPROC>("glGetQueryBufferObjectuiv");
  expect_captured_again(draw_arrays, [&] { to_buffer(query, vertices_, GL_QUERY_RESULT, 0); });
}

TEST_P(ChangedDraws, ComputeShader) {
  const GLuint writer = glCreateProgram();
  attach_shader(
      writer, GL_COMPUTE_SHADER,
      "#version 430\nlayout(local_size_x = 6) in; layout(std430, binding = 0) buffer Data { float data[]; };\n"
      "void main() { data[5u * gl_LocalInvocationID.x] *= 0.5; data[5u * gl_LocalInvocationID.x + 2u] = 0.5; }\n");
  glLinkProgram(writer);
  GLint drawer = 0;
  glGetIntegerv(GL_CURRENT_PROGRAM, &drawer);
  expect_seen(draw_arrays, [&] {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, vertices_);
    glUseProgram(writer);
    glDispatchCompute(1, 1, 1);
    glMemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT);
    glUseProgram(static_cast<GLuint>(drawer));
  });
}

TEST_P(ChangedDraws, ImageOfABufferTexture) {
  const GLuint writer = glCreateProgram();
  attach_shader(writer, GL_COMPUTE_SHADER,
                "#version 430\nlayout(local_size_x = 6) in; layout(r32f, binding = 0) uniform imageBuffer data;\n"
                "void main() { int at = 5 * int(gl_LocalInvocationID.x);\n"
                "imageStore(data, at, 0.5 * imageLoad(data, at)); imageStore(data, at + 2, vec4(0.5)); }\n");
  glLinkProgram(writer);
  GLuint texture = 0;
  glGenTextures(1, &texture);
  expect_seen(draw_arrays, [&] {
    glBindTexture(GL_TEXTURE_BUFFER, texture);
    glTexBuffer(GL_TEXTURE_BUFFER, GL_R32F, vertices_);
    glBindImageTexture(0, texture, 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32F);
    glUseProgram(writer);
    glDispatchCompute(1, 1, 1);
    glMemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT);
    glUseProgram(program_);
  });
}

// A draw that is not refined stores to the buffer. The test omits the barrier that OpenGL asks for, because this driver
// does without.
TEST_P(ChangedDraws, FragmentShaderOfAnotherDraw) {
  const GLuint writer = link_program(
      {.vertex = "#version 430\nvoid main() { gl_Position = vec4(0.0, 0.0, 0.0, 1.0); gl_PointSize = 1.0; }\n",
       .fragment = "#version 430\nlayout(std430, binding = 0) buffer Data { float data[]; }; out vec4 result;\n"
                   "void main() { for (int i = 0; i < 6; ++i) { data[5 * i] *= 0.5; data[5 * i + 2] = 0.5; }\n"
                   "result = vec4(0.0); }\n"});
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, vertices_);
  expect_seen(draw_arrays, [&] {
    glUseProgram(writer);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDrawArrays(GL_POINTS, 0, 1);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glFinish();
    glUseProgram(program_);
  });
}

TEST_P(ChangedDraws, TransformFeedback) {
  GLint drawer = 0;
  glGetIntegerv(GL_CURRENT_PROGRAM, &drawer);
  const GLuint writer = link_program(
      {.vertex = "#version 430\nlayout(location = 0) in vec2 position; layout(location = 1) in vec3 color; out vec2 p; "
                 "out vec3 q;\n"
                 "void main() { p = position * vec2(0.5, -0.7); q = color.brg; gl_Position = vec4(0.0); }\n",
       .fragment = "#version 430\nvoid main() {}\n",
       .varyings = {"p", "q"}});
  const GLuint source = make_buffer(GL_ARRAY_BUFFER, one());
  GLuint arrays[2] = {};
  GLint drawn = 0;
  glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &drawn);
  glGenVertexArrays(1, arrays);
  expect_seen(draw_arrays, [&] {
    glBindVertexArray(arrays[0]);
    glBindBuffer(GL_ARRAY_BUFFER, source);
    point_generic_arrays(nullptr);
    glUseProgram(writer);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, vertices_);
    glEnable(GL_RASTERIZER_DISCARD);
    glBeginTransformFeedback(GL_POINTS);
    glDrawArrays(GL_POINTS, 0, 6);
    glEndTransformFeedback();
    glDisable(GL_RASTERIZER_DISCARD);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
    glUseProgram(static_cast<GLuint>(drawer));
    glBindVertexArray(static_cast<GLuint>(drawn));
  });
}

TEST_P(ChangedDraws, Pointer) {
  std::vector<ColoredVertex> both = one();
  for (const ColoredVertex& vertex : two()) both.push_back(vertex);
  glBufferData(GL_ARRAY_BUFFER, 2 * bytes, both.data(), GL_STATIC_DRAW);
  expect_seen(draw_arrays, [] { point_generic_arrays(byte_offset(bytes)); });
}

TEST_P(ChangedDraws, BindVertexBuffer) {
  const GLuint other = make_buffer(GL_ARRAY_BUFFER, two());
  glVertexAttribFormat(0, 2, GL_FLOAT, GL_FALSE, 0);
  glVertexAttribFormat(1, 3, GL_FLOAT, GL_FALSE, 8);
  glVertexAttribBinding(0, 3);
  glVertexAttribBinding(1, 3);
  glBindVertexBuffer(3, vertices_, 0, sizeof(ColoredVertex));
  expect_seen(draw_arrays, [other] { glBindVertexBuffer(3, other, 0, sizeof(ColoredVertex)); });
}

TEST_P(ChangedDraws, ConstantInsteadOfAnArray) {
  expect_seen(draw_arrays, [] {
    glDisableVertexAttribArray(1);
    glVertexAttrib3f(1, 1, 0.5F, 0.25F);
  });
}

TEST_P(ChangedDraws, ElementsOverwritten) {
  expect_seen(draw_elements, [] {
    const GLushort reversed[9] = {0, 2, 4, 0, 0, 0, 1, 3, 5};
    glBufferSubData(GL_ELEMENT_ARRAY_BUFFER, 0, sizeof(reversed), reversed);
  });
}

TEST_P(ChangedDraws, AnotherElementBuffer) {
  const GLuint other = make_buffer(GL_ELEMENT_ARRAY_BUFFER, std::vector<GLushort>{0, 2, 4, 0, 0, 0, 1, 3, 5});
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
  expect_seen(draw_elements, [other] { glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, other); });
}

TEST_P(ChangedDraws, AnotherVertexArray) {
  GLuint array = 0;
  glGenVertexArrays(1, &array);
  make_buffer(GL_ARRAY_BUFFER, two());
  expect_seen(draw_arrays, [array] {
    glBindVertexArray(array);
    point_generic_arrays(nullptr);
  });
}

TEST_P(ChangedDraws, BufferDeletedAndMadeAgain) {
  expect_seen(draw_arrays, [this] {
    glDeleteBuffers(1, &vertices_);
    if (GetParam() == Profile::compatibility) {
      glBindBuffer(GL_ARRAY_BUFFER, vertices_);  // the same name
      glBufferData(GL_ARRAY_BUFFER, bytes, two().data(), GL_STATIC_DRAW);
    } else {
      make_buffer(GL_ARRAY_BUFFER, two());
    }
    point_generic_arrays(nullptr);
  });
}

// Another object gets the name, while a vertex array that is not bound keeps the old object.
TEST_P(ChangedDraws, NameOfADeletedBufferThatIsStillAttached) {
  if (GetParam() == Profile::core) GTEST_SKIP() << "names cannot be chosen there";
  GLuint other = 0;
  glGenVertexArrays(1, &other);
  const Picture before = picture_of(draw_arrays);
  for (int i = 0; i < 2; ++i) picture_of(draw_arrays);
  glBindVertexArray(other);
  glDeleteBuffers(1, &vertices_);
  glBindBuffer(GL_ARRAY_BUFFER, vertices_);
  glBufferData(GL_ARRAY_BUFFER, bytes, two().data(), GL_STATIC_DRAW);
  point_generic_arrays(nullptr);
  const Picture second = picture_of(draw_arrays);
  EXPECT_GT(differing_pixels(before, second), visible_pixels);
  for (int i = 0; i < 4; ++i) {
    glBindVertexArray(array_);
    EXPECT_EQ(differing_pixels(before, picture_of(draw_arrays)), 0) << i;
    glBindVertexArray(other);
    EXPECT_EQ(differing_pixels(second, picture_of(draw_arrays)), 0) << i;
  }
}

// GL refuses the binding, and the write goes to the buffer bound before.
TEST_P(ChangedDraws, RefusedBinding) {
  if (GetParam() == Profile::compatibility) GTEST_SKIP() << "any name will do there";
  expect_seen(draw_arrays, [] {
    glBindBuffer(GL_ARRAY_BUFFER, 4711);
    EXPECT_EQ(pending_errors(), "0x0502 ");
    glBufferSubData(GL_ARRAY_BUFFER, 0, bytes, two().data());
  });
}

TEST_P(ChangedDraws, RefusedVertexArray) {
  expect_kept(draw_arrays, [] {
    glBindVertexArray(4711);
    EXPECT_EQ(pending_errors(), "0x0502 ");
  });
}

TEST_P(ChangedDraws, BindingRestoredByPopClientAttrib) {
  if (GetParam() == Profile::core) GTEST_SKIP() << "compatibility contexts only";
  const GLuint other = make_buffer(GL_ARRAY_BUFFER, two());
  glBindBuffer(GL_ARRAY_BUFFER, vertices_);
  expect_seen(draw_arrays, [other] {
    glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
    glBindBuffer(GL_ARRAY_BUFFER, other);
    glPopClientAttrib();
    glBufferSubData(GL_ARRAY_BUFFER, 0, bytes, two().data());
  });
}

TEST_P(ChangedDraws, ElementsOfAnArrayBoundAgain) {
  GLuint other = 0;
  glGenVertexArrays(1, &other);
  expect_seen(draw_elements, [this, other] {
    glBindVertexArray(other);
    make_buffer(GL_ELEMENT_ARRAY_BUFFER, std::vector<GLushort>{5, 4, 3});
    glBindVertexArray(array_);
    const GLushort reversed[9] = {0, 2, 4, 0, 0, 0, 1, 3, 5};
    glBufferSubData(GL_ELEMENT_ARRAY_BUFFER, 0, sizeof(reversed), reversed);
  });
}

// If a condition fails, the capture is empty and must not be kept.
TEST_P(ChangedDraws, ConditionalRendering) {
  GLuint query = 0;
  glGenQueries(1, &query);
  glBeginQuery(GL_SAMPLES_PASSED, query);
  glEndQuery(GL_SAMPLES_PASSED);
  for (int i = 0; i < 3; ++i) {
    glBeginConditionalRender(query, GL_QUERY_WAIT);
    draw_arrays();
    glEndConditionalRender();
  }
  const Picture refined = picture_of(draw_arrays);
  glDisable(GL_ARK);
  EXPECT_LE(differing_pixels(picture_of(draw_arrays), refined), tolerated_pixels);
}

TEST_P(ChangedDraws, WrittenInASharedContext) {
  OsmesaContext second(GetParam(), &context_);
  context_.make_current();
  expect_seen(draw_arrays, [this, &second] {
    second.make_current();
    glBindBuffer(GL_COPY_WRITE_BUFFER, vertices_);
    glBufferSubData(GL_COPY_WRITE_BUFFER, 0, bytes, two().data());
    glFinish();
    context_.make_current();
  });
}

TEST_P(ChangedDraws, WrittenInAnotherThread) {
  expect_seen(draw_arrays, [this] {
    std::thread writer([this] {
      OsmesaContext second(GetParam(), &context_);
      glBindBuffer(GL_COPY_WRITE_BUFFER, vertices_);
      void* memory = glMapBufferRange(GL_COPY_WRITE_BUFFER, 0, bytes, GL_MAP_WRITE_BIT);
      std::copy_n(two().data(), 6, static_cast<ColoredVertex*>(memory));
      glUnmapBuffer(GL_COPY_WRITE_BUFFER);
      glFinish();
    });
    writer.join();
  });
}

TEST_P(ChangedDraws, ProvokingVertex) {
  glUseProgram(link_program(
      {.vertex =
           "#version 430\nlayout(location = 0) in vec2 position; layout(location = 1) in vec3 color; flat out vec3 c;\n"
           "void main() { gl_Position = vec4(position, 0.0, 1.0); c = color; }\n",
       .fragment = "#version 430\nflat in vec3 c; out vec4 result;\nvoid main() { result = vec4(c, 1.0); }\n"}));
  expect_seen(draw_arrays, [] { glProvokingVertex(GL_FIRST_VERTEX_CONVENTION); });
}

}  // namespace
}  // namespace glark::core::test
