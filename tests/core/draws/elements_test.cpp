// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Indexed and instanced draws, in both profiles, each by one call of the application.
#include <cstdint>

#include "tests/core/support/modes.h"
#include "tests/core/support/programs.h"
#include "tests/core/support/scene.h"

namespace glark::core::test {
namespace {

// A 5 by 5 grid; indices of its 32 triangles are shifted by `base`.
struct Grid {
  std::vector<ColoredVertex> vertices;
  std::vector<GLuint> indices;
};

constexpr GLuint grid_triangles = 32;
constexpr GLsizei grid_indices = 96;

Grid make_grid(GLuint base) {
  Grid grid;
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 5; ++x) {
      const auto fx = static_cast<GLfloat>(x);
      const auto fy = static_cast<GLfloat>(y);
      grid.vertices.push_back(
          {{fx * 0.4F - 0.85F, fy * 0.4F - 0.75F}, {fx / 4, fy / 4, (x + y) % 2 == 0 ? 1.0F : 0.0F}});
    }
  }
  for (GLuint y = 0; y < 4; ++y) {
    for (GLuint x = 0; x < 4; ++x) {
      const GLuint corner = base + y * 5 + x;
      grid.indices.insert(grid.indices.end(), {corner, corner + 1, corner + 5, corner + 5, corner + 1, corner + 6});
    }
  }
  return grid;
}

template <typename Index>
std::vector<Index> indices_of(const Grid& grid) {
  return {grid.indices.begin(), grid.indices.end()};
}

// gl_InstanceID moves the shape; the attribute `shift` (divisor 1) moves and colours it.
const char* const vertex_shader = R"(#version 430 core
layout(location = 0) in vec2 position;
layout(location = 1) in vec3 color;
layout(location = 2) in vec2 shift;
out vec3 passed;
void main() {
  gl_Position = vec4(position * 0.5 + shift + vec2(0.0, 0.45 * float(gl_InstanceID) - 0.4), 0.0, 1.0);
  passed = color * (0.5 + shift.x);
}
)";
const char* const fragment_shader = R"(#version 430 core
in vec3 passed;
out vec4 result;
void main() { result = vec4(passed, 1.0); }
)";

class DrawsElements : public testing::TestWithParam<Profile> {
 protected:
  DrawsElements() {
    glGenVertexArrays(1, &vertex_array_);
    glBindVertexArray(vertex_array_);
    glUseProgram(link_program({.vertex = vertex_shader, .fragment = fragment_shader}));
  }
  // `base` vertices stand before the grid; indices do not count them.
  template <typename Index>
  void upload(GLuint base = 0) {
    Grid grid = make_grid(0);
    grid.vertices.insert(grid.vertices.begin(), base, ColoredVertex{{5, 5}, {1, 1, 1}});
    make_buffer(GL_ARRAY_BUFFER, grid.vertices);
    point_generic_arrays(nullptr);
    make_buffer(GL_ARRAY_BUFFER, std::vector<GLfloat>{0.4F, -0.3F, -0.4F, 0.1F, 0.3F, 0.3F, 0.0F, -0.2F});
    float_attribute(2, 2);
    glVertexAttribDivisor(2, 1);
    make_buffer(GL_ELEMENT_ARRAY_BUFFER, indices_of<Index>(grid));
  }
  OsmesaContext context_{GetParam()};
  GLuint vertex_array_ = 0;
};

INSTANTIATE_TEST_SUITE_P(All, DrawsElements, testing::Values(Profile::compatibility, Profile::core), profile_name);

TEST_P(DrawsElements, UnsignedByte) {
  upload<GLubyte>();
  expect_same_scene({grid_triangles}, [] { glDrawElements(GL_TRIANGLES, grid_indices, GL_UNSIGNED_BYTE, nullptr); });
}

TEST_P(DrawsElements, UnsignedShortFromAnOffset) {
  upload<GLushort>();
  expect_same_scene({grid_triangles - 2},
                    [] { glDrawElements(GL_TRIANGLES, grid_indices - 6, GL_UNSIGNED_SHORT, byte_offset(12)); });
}

TEST_P(DrawsElements, UnsignedInt) {
  upload<GLuint>();
  expect_same_scene({grid_triangles}, [] { glDrawElements(GL_TRIANGLES, grid_indices, GL_UNSIGNED_INT, nullptr); });
}

TEST_P(DrawsElements, Range) {
  upload<GLushort>();
  expect_same_scene({grid_triangles},
                    [] { glDrawRangeElements(GL_TRIANGLES, 0, 24, grid_indices, GL_UNSIGNED_SHORT, nullptr); });
}

TEST_P(DrawsElements, BaseVertex) {
  upload<GLushort>(7);
  expect_same_scene({grid_triangles},
                    [] { glDrawElementsBaseVertex(GL_TRIANGLES, grid_indices, GL_UNSIGNED_SHORT, nullptr, 7); });
}

TEST_P(DrawsElements, RangeBaseVertex) {
  upload<GLuint>(7);
  expect_same_scene({grid_triangles}, [] {
    glDrawRangeElementsBaseVertex(GL_TRIANGLES, 0, 24, grid_indices, GL_UNSIGNED_INT, nullptr, 7);
  });
}

TEST_P(DrawsElements, ArraysInstanced) {
  upload<GLuint>();
  expect_same_scene({6 * 3}, [] { glDrawArraysInstanced(GL_TRIANGLE_STRIP, 3, 8, 3); });
}

TEST_P(DrawsElements, ArraysInstancedBaseInstance) {
  upload<GLuint>();
  expect_same_scene({6 * 2}, [] { glDrawArraysInstancedBaseInstance(GL_TRIANGLE_STRIP, 3, 8, 2, 2); });
}

TEST_P(DrawsElements, Instanced) {
  upload<GLuint>();
  expect_same_scene({grid_triangles * 3},
                    [] { glDrawElementsInstanced(GL_TRIANGLES, grid_indices, GL_UNSIGNED_INT, nullptr, 3); });
}

TEST_P(DrawsElements, InstancedBaseVertex) {
  upload<GLubyte>(7);
  expect_same_scene({grid_triangles * 3}, [] {
    glDrawElementsInstancedBaseVertex(GL_TRIANGLES, grid_indices, GL_UNSIGNED_BYTE, nullptr, 3, 7);
  });
}

TEST_P(DrawsElements, InstancedBaseInstance) {
  upload<GLubyte>();
  expect_same_scene({grid_triangles * 2}, [] {
    glDrawElementsInstancedBaseInstance(GL_TRIANGLES, grid_indices, GL_UNSIGNED_BYTE, nullptr, 2, 1);
  });
}

TEST_P(DrawsElements, InstancedBaseVertexBaseInstance) {
  upload<GLushort>(7);
  expect_same_scene({grid_triangles * 2}, [] {
    glDrawElementsInstancedBaseVertexBaseInstance(GL_TRIANGLES, grid_indices, GL_UNSIGNED_SHORT, nullptr, 2, 7, 1);
  });
}

TEST_P(DrawsElements, MultiArrays) {
  upload<GLuint>();
  const GLint first[] = {0, 5, 10};
  const GLsizei count[] = {8, 7, 3};
  expect_same_scene({6 + 5 + 1}, [&] { glMultiDrawArrays(GL_TRIANGLE_STRIP, first, count, 3); });
}

TEST_P(DrawsElements, MultiElements) {
  upload<GLushort>();
  const GLsizei count[] = {24, 48};
  const void* const offsets[] = {byte_offset(0), byte_offset(96)};
  expect_same_scene({24}, [&] { glMultiDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_SHORT, offsets, 2); });
}

TEST_P(DrawsElements, MultiElementsBaseVertex) {
  upload<GLushort>(5);
  const GLsizei count[] = {24, 48};
  const void* const offsets[] = {byte_offset(0), byte_offset(48)};
  const GLint base[] = {5, 10};
  expect_same_scene({24},
                    [&] { glMultiDrawElementsBaseVertex(GL_TRIANGLES, count, GL_UNSIGNED_SHORT, offsets, 2, base); });
}

TEST_P(DrawsElements, ArraysIndirect) {
  upload<GLuint>();
  make_buffer(GL_DRAW_INDIRECT_BUFFER, std::vector<GLuint>{99, 99, 7, 2, 5, 1});
  expect_same_scene({2 * 5}, [] { glDrawArraysIndirect(GL_TRIANGLE_STRIP, byte_offset(8)); });
}

TEST_P(DrawsElements, ElementsIndirect) {
  upload<GLuint>(7);
  make_buffer(GL_DRAW_INDIRECT_BUFFER, std::vector<GLuint>{90, 3, 6, 7, 1});
  expect_same_scene({3 * 30}, [] { glDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, nullptr); });
}

TEST_P(DrawsElements, MultiArraysIndirect) {
  upload<GLuint>();
  make_buffer(GL_DRAW_INDIRECT_BUFFER, std::vector<GLuint>{7, 1, 5, 0, 0, 7, 1, 10, 1, 0});
  expect_same_scene({10}, [] { glMultiDrawArraysIndirect(GL_TRIANGLE_STRIP, nullptr, 2, 20); });
}

TEST_P(DrawsElements, MultiElementsIndirect) {
  upload<GLushort>();
  make_buffer(GL_DRAW_INDIRECT_BUFFER, std::vector<GLuint>{48, 1, 0, 0, 0, 48, 2, 48, 0, 1});
  expect_same_scene({16 + 32}, [] { glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_SHORT, nullptr, 2, 0); });
}

// The number of commands is in a buffer, too.
TEST_P(DrawsElements, IndirectWithACountOfTheGpu) {
  upload<GLushort>();
  const auto arrays = proc<PFNGLMULTIDRAWARRAYSINDIRECTCOUNTARBPROC>("glMultiDrawArraysIndirectCountARB");
  const auto elements = proc<PFNGLMULTIDRAWELEMENTSINDIRECTCOUNTARBPROC>("glMultiDrawElementsIndirectCountARB");
  make_buffer(GL_PARAMETER_BUFFER_ARB, std::vector<GLuint>{0, 2});
  make_buffer(GL_DRAW_INDIRECT_BUFFER,
              std::vector<GLuint>{7, 1, 5, 0, 0, 7, 1, 10, 1, 0, 7, 1, 0, 1, 0, 48, 1, 0, 0, 0, 48, 2, 48, 0, 1});
  expect_same_scene({10}, [&] { arrays(GL_TRIANGLE_STRIP, nullptr, 4, 3, 20); });
  expect_same_scene({16 + 32}, [&] { elements(GL_TRIANGLES, GL_UNSIGNED_SHORT, byte_offset(60), 4, 2, 0); });
}

std::vector<GLushort> indices_with_restarts() {
  return {0, 1, 5, 6, 0xFFFF, 10, 11, 15, 16, 20, 21, 0xFFFF, 0xFFFF, 2, 3, 0xFFFF, 3, 4, 8};
}

TEST_P(DrawsElements, RestartAtTheFixedIndex) {
  upload<GLushort>();
  make_buffer(GL_ELEMENT_ARRAY_BUFFER, indices_with_restarts());
  glEnable(GL_PRIMITIVE_RESTART_FIXED_INDEX);
  expect_same_scene({2 + 4 + 1}, [] { glDrawElementsInstanced(GL_TRIANGLE_STRIP, 19, GL_UNSIGNED_SHORT, nullptr, 1); });
}

TEST_P(DrawsElements, RestartAtAnIndexOfOurs) {
  upload<GLushort>();
  std::vector<GLushort> indices = indices_with_restarts();
  for (GLushort& index : indices) index = index == 0xFFFF ? GLushort{23} : index;
  make_buffer(GL_ELEMENT_ARRAY_BUFFER, indices);
  glEnable(GL_PRIMITIVE_RESTART);
  glPrimitiveRestartIndex(23);
  expect_same_scene({2 * (2 + 4 + 1)},
                    [] { glDrawElementsInstanced(GL_TRIANGLE_STRIP, 19, GL_UNSIGNED_SHORT, nullptr, 2); });
}

TEST_P(DrawsElements, RestartInAMultiDraw) {
  upload<GLushort>();
  make_buffer(GL_ELEMENT_ARRAY_BUFFER, indices_with_restarts());
  glEnable(GL_PRIMITIVE_RESTART);
  glPrimitiveRestartIndex(0xFFFF);
  const GLsizei count[] = {11, 7};
  const void* const offsets[] = {byte_offset(0), byte_offset(24)};
  expect_same_scene({7}, [&] { glMultiDrawElements(GL_TRIANGLE_STRIP, count, GL_UNSIGNED_SHORT, offsets, 2); });
}

// A restart index within the index range of the pool must not cut patterns.
TEST_P(DrawsElements, RestartEnabledWithoutRestarts) {
  upload<GLushort>();
  glEnable(GL_PRIMITIVE_RESTART);
  glPrimitiveRestartIndex(30);
  expect_same_scene({grid_triangles}, [] { glDrawElements(GL_TRIANGLES, grid_indices, GL_UNSIGNED_SHORT, nullptr); });
}

TEST_P(DrawsElements, IndicesInClientMemory) {
  if (GetParam() == Profile::core) GTEST_SKIP() << "the core profile has none";
  upload<GLushort>();
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
  const Grid grid = make_grid(0);
  const std::vector<GLubyte> bytes = indices_of<GLubyte>(grid);
  expect_same_scene({grid_triangles},
                    [&] { glDrawElements(GL_TRIANGLES, grid_indices, GL_UNSIGNED_BYTE, bytes.data()); });
}

}  // namespace
}  // namespace glark::core::test
