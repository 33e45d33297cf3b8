// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Which bytes of client memory a draw reads. No GL.
#include "glark/core/keep/client_arrays.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace glark::core::test {
namespace {

TEST(ClientArrays, HashesTellContentApart) {
  std::vector<std::byte> content(1000);
  const std::vector<std::byte> copy = content;
  EXPECT_EQ(hash_of(content), hash_of(copy));
  content[999] = std::byte{1};
  EXPECT_FALSE(hash_of(content) == hash_of(copy));
  EXPECT_FALSE(hash_of(std::span(copy).first(999)) == hash_of(copy));
}

TEST(ClientArrays, VerticesOfADrawWithoutIndices) {
  const auto range = vertices_read({.first = 5, .count = 7}, {});
  ASSERT_TRUE(range);
  EXPECT_EQ(range->first, 5);
  EXPECT_EQ(range->count, 7);
  EXPECT_FALSE(vertices_read({.first = 5, .count = 0}, {}));
}

template <typename Index>
void expect_range(GLenum type, std::int64_t first, std::int64_t count, const std::vector<Index>& indices) {
  const ArrayDraw draw{
      .count = static_cast<GLsizei>(indices.size()), .index_type = type, .indices = indices.data(), .base_vertex = 10};
  const auto range = vertices_read(draw, client_indices(draw));
  ASSERT_TRUE(range);
  EXPECT_EQ(range->first, first);
  EXPECT_EQ(range->count, count);
}

TEST(ClientArrays, VerticesOfIndices) {
  expect_range<GLubyte>(GL_UNSIGNED_BYTE, 13, 6, {3, 8, 4});
  expect_range<GLushort>(GL_UNSIGNED_SHORT, 10, 1, {0, 0, 0});
  expect_range<GLuint>(GL_UNSIGNED_INT, 1000010, 3, {1000000, 1000001, 1000002});
}

TEST(ClientArrays, SparseIndicesAreNotFollowed) {
  const std::array<GLuint, 3> indices{0, 1, 1000000};
  const ArrayDraw draw{.count = 3, .index_type = GL_UNSIGNED_INT, .indices = indices.data()};
  EXPECT_FALSE(vertices_read(draw, client_indices(draw)));
}

TEST(ClientArrays, NoIndices) {
  EXPECT_TRUE(client_indices({.count = 3, .index_type = GL_UNSIGNED_INT, .indices = nullptr}).empty());
  const std::array<GLuint, 3> indices{0, 1, 2};
  const char* odd = reinterpret_cast<const char*>(indices.data()) + 1;
  EXPECT_TRUE(client_indices({.count = 2, .index_type = GL_UNSIGNED_INT, .indices = odd}).empty());
  EXPECT_TRUE(client_indices({.count = -1, .index_type = GL_UNSIGNED_INT, .indices = indices.data()}).empty());
  EXPECT_TRUE(client_indices({.count = 3, .index_type = GL_FLOAT, .indices = indices.data()}).empty());
}

AttributeSource array_at(const void* base, GLint size, GLenum type, GLsizei stride) {
  return {.size = size, .type = type, .offset = reinterpret_cast<GLintptr>(base), .stride = stride};
}

TEST(ClientArrays, BytesOfAnArray) {
  const std::array<GLfloat, 64> data{};
  const auto* base = reinterpret_cast<const std::byte*>(data.data());
  const std::span<const std::byte> packed = bytes_read(vertex_slot, array_at(base, 3, GL_FLOAT, 0), {2, 4});
  EXPECT_EQ(packed.data(), base + 24);
  EXPECT_EQ(packed.size(), 48U);
  const std::span<const std::byte> spread = bytes_read(0, array_at(base, 2, GL_FLOAT, 20), {1, 3});
  EXPECT_EQ(spread.data(), base + 20);
  EXPECT_EQ(spread.size(), 48U);
  EXPECT_EQ(bytes_read(normal_slot, array_at(base, 0, GL_SHORT, 0), {0, 2}).size(), 12U);
  EXPECT_EQ(bytes_read(fog_coordinate_slot, array_at(base, 0, GL_FLOAT, 0), {0, 2}).size(), 8U);
  EXPECT_EQ(bytes_read(color_slot, array_at(base, GL_BGRA, GL_UNSIGNED_BYTE, 0), {0, 2}).size(), 8U);
}

TEST(ClientArrays, ArraysThatAreNotFollowed) {
  const std::array<GLfloat, 64> data{};
  AttributeSource each_instance = array_at(data.data(), 3, GL_FLOAT, 0);
  each_instance.divisor = 1;
  EXPECT_TRUE(bytes_read(1, each_instance, {0, 2}).empty());
  EXPECT_TRUE(bytes_read(1, array_at(data.data(), 4, GL_INT_2_10_10_10_REV, 0), {0, 2}).empty());
  EXPECT_TRUE(bytes_read(1, array_at(nullptr, 3, GL_FLOAT, 0), {0, 2}).empty());
  EXPECT_TRUE(bytes_read(1, array_at(data.data(), 0, GL_FLOAT, 0), {0, 2}).empty());
}

}  // namespace
}  // namespace glark::core::test
