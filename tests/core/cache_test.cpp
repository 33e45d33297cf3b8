// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Unchanged draws may reuse what was captured; whatever changes their vertices must be seen. Each test draws twice, so that
// a capture is kept, changes the source in one way, and compares with the unrefined picture.
#include <functional>

#include "tests/core/modes.h"
#include "tests/core/programs.h"
#include "tests/core/scene.h"

namespace glark::core::test {
namespace {

const char* const vertex_shader =
    "#version 430\nlayout(location = 0) in vec2 position; layout(location = 1) in vec3 color; out vec3 c;\n"
    "void main() { gl_Position = vec4(position, 0.0, 1.0); c = color; }\n";
const char* const fragment_shader =
    "#version 430\nin vec3 c; out vec4 result;\nvoid main() { result = vec4(c, 1.0); }\n";

class Cache : public testing::TestWithParam<Profile> {
 protected:
  Cache() {
    GLuint array = 0;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    vertices_ = make_buffer(GL_ARRAY_BUFFER, one());
    point_generic_arrays(nullptr);
    indices_ = make_buffer(GL_ELEMENT_ARRAY_BUFFER, std::vector<GLushort>{0, 1, 2, 2, 1, 3, 3, 4, 5});
    glUseProgram(link_program({.vertex = vertex_shader, .fragment = fragment_shader}));
    refine_uniformly(2);
  }
  static std::vector<ColoredVertex> one() { return mode_shapes()[1].vertices; }
  static std::vector<ColoredVertex> two() {
    std::vector<ColoredVertex> vertices = one();
    for (ColoredVertex& v : vertices)
      v = {{v.position[0] * 0.6F, v.position[1] * -0.7F}, {v.color[2], v.color[0], v.color[1]}};
    return vertices;
  }
  static constexpr GLsizeiptr bytes = 6 * sizeof(ColoredVertex);

  void expect_seen(const std::function<void()>& draw, const std::function<void()>& change) {
    const Picture before = picture_of(draw);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(differing_pixels(before, picture_of(draw)), 0);
    change();
    const Picture after = picture_of(draw);
    EXPECT_EQ(generated_primitives % 16, 0U);
    EXPECT_GT(generated_primitives, 0U);
    EXPECT_EQ(differing_pixels(after, picture_of(draw)), 0);
    glDisable(GL_ARK);
    const Picture plain = picture_of(draw);
    EXPECT_LE(differing_pixels(plain, after), tolerated_pixels);
    EXPECT_GT(differing_pixels(plain, before), visible_pixels) << "the change does not show";
    EXPECT_EQ(pending_errors(), "");
  }
  static void draw_arrays() { glDrawArrays(GL_TRIANGLE_STRIP, 0, 6); }
  static void draw_elements() { glDrawElements(GL_TRIANGLES, 9, GL_UNSIGNED_SHORT, nullptr); }

  OsmesaContext context_{GetParam()};
  GLuint vertices_ = 0;
  GLuint indices_ = 0;
};

INSTANTIATE_TEST_SUITE_P(All, Cache, testing::Values(Profile::compatibility, Profile::core), profile_name);

TEST_P(Cache, BufferSubData) {
  expect_seen(draw_arrays, [] { glBufferSubData(GL_ARRAY_BUFFER, 0, bytes, two().data()); });
}

TEST_P(Cache, BufferData) {
  expect_seen(draw_elements, [] { glBufferData(GL_ARRAY_BUFFER, bytes, two().data(), GL_STATIC_DRAW); });
}

TEST_P(Cache, Map) {
  expect_seen(draw_arrays, [] {
    void* memory = glMapBuffer(GL_ARRAY_BUFFER, GL_WRITE_ONLY);
    std::copy_n(two().data(), 6, static_cast<ColoredVertex*>(memory));
    glUnmapBuffer(GL_ARRAY_BUFFER);
  });
}

TEST_P(Cache, MapRangeWithFlush) {
  expect_seen(draw_arrays, [] {
    void* memory = glMapBufferRange(GL_ARRAY_BUFFER, 0, bytes, GL_MAP_WRITE_BIT | GL_MAP_FLUSH_EXPLICIT_BIT);
    std::copy_n(two().data(), 6, static_cast<ColoredVertex*>(memory));
    glFlushMappedBufferRange(GL_ARRAY_BUFFER, 0, bytes);
    glUnmapBuffer(GL_ARRAY_BUFFER);
  });
}

// Written while it stays mapped: nothing tells us.
TEST_P(Cache, PersistentMap) {
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

TEST_P(Cache, CopyBuffer) {
  make_buffer(GL_COPY_READ_BUFFER, two());
  expect_seen(draw_arrays, [] { glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_ARRAY_BUFFER, 0, 0, bytes); });
}

TEST_P(Cache, ClearBuffer) {
  const auto clear = proc<PFNGLCLEARBUFFERSUBDATAPROC>("glClearBufferSubData");
  expect_seen(draw_arrays, [clear] {
    const GLfloat zero[2] = {0, 0};
    clear(GL_ARRAY_BUFFER, GL_RG32F, 40, 8, GL_RG, GL_FLOAT, zero);
  });
}

TEST_P(Cache, NamedBufferSubData) {
  const auto write = proc<PFNGLNAMEDBUFFERSUBDATAPROC>("glNamedBufferSubData");
  ASSERT_NE(write, nullptr);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  expect_seen(draw_arrays, [this, write] { write(vertices_, 0, bytes, two().data()); });
}

TEST_P(Cache, ComputeShader) {
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

TEST_P(Cache, TransformFeedback) {
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

TEST_P(Cache, Pointer) {
  std::vector<ColoredVertex> both = one();
  for (const ColoredVertex& vertex : two()) both.push_back(vertex);
  glBufferData(GL_ARRAY_BUFFER, 2 * bytes, both.data(), GL_STATIC_DRAW);
  expect_seen(draw_arrays, [] { point_generic_arrays(byte_offset(bytes)); });
}

TEST_P(Cache, BindVertexBuffer) {
  const GLuint other = make_buffer(GL_ARRAY_BUFFER, two());
  glVertexAttribFormat(0, 2, GL_FLOAT, GL_FALSE, 0);
  glVertexAttribFormat(1, 3, GL_FLOAT, GL_FALSE, 8);
  glVertexAttribBinding(0, 3);
  glVertexAttribBinding(1, 3);
  glBindVertexBuffer(3, vertices_, 0, sizeof(ColoredVertex));
  expect_seen(draw_arrays, [other] { glBindVertexBuffer(3, other, 0, sizeof(ColoredVertex)); });
}

TEST_P(Cache, ConstantInsteadOfAnArray) {
  expect_seen(draw_arrays, [] {
    glDisableVertexAttribArray(1);
    glVertexAttrib3f(1, 1, 0.5F, 0.25F);
  });
}

TEST_P(Cache, ElementsOverwritten) {
  expect_seen(draw_elements, [] {
    const GLushort reversed[9] = {0, 2, 4, 0, 0, 0, 1, 3, 5};
    glBufferSubData(GL_ELEMENT_ARRAY_BUFFER, 0, sizeof(reversed), reversed);
  });
}

TEST_P(Cache, AnotherElementBuffer) {
  const GLuint other = make_buffer(GL_ELEMENT_ARRAY_BUFFER, std::vector<GLushort>{0, 2, 4, 0, 0, 0, 1, 3, 5});
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
  expect_seen(draw_elements, [other] { glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, other); });
}

TEST_P(Cache, AnotherVertexArray) {
  GLuint array = 0;
  glGenVertexArrays(1, &array);
  make_buffer(GL_ARRAY_BUFFER, two());
  expect_seen(draw_arrays, [array] {
    glBindVertexArray(array);
    point_generic_arrays(nullptr);
  });
}

TEST_P(Cache, BufferDeletedAndMadeAgain) {
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

TEST_P(Cache, ProvokingVertex) {
  glUseProgram(link_program(
      {.vertex =
           "#version 430\nlayout(location = 0) in vec2 position; layout(location = 1) in vec3 color; flat out vec3 c;\n"
           "void main() { gl_Position = vec4(position, 0.0, 1.0); c = color; }\n",
       .fragment = "#version 430\nflat in vec3 c; out vec4 result;\nvoid main() { result = vec4(c, 1.0); }\n"}));
  expect_seen(draw_arrays, [] { glProvokingVertex(GL_FIRST_VERTEX_CONVENTION); });
}

}  // namespace
}  // namespace glark::core::test
