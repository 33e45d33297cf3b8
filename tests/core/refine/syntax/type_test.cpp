// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/syntax/type.h"

#include <gtest/gtest.h>

namespace glark::refine {
namespace {

TEST(SyntaxType, VectorsMatricesAndNumbers) {
  const Type vector = read_type(" smooth out highp 4-component vector of float");
  EXPECT_EQ(vector.basic, BasicType::floating);
  EXPECT_EQ(vector.storage, StorageClass::output);
  EXPECT_EQ(vector.vector_size, 4U);
  EXPECT_TRUE(vector.has_components());
  EXPECT_TRUE(read_type(" uniform 4X4 matrix of float").matrix);
  EXPECT_EQ(read_type(" in int").basic, BasicType::integer);
  EXPECT_EQ(read_type(" temp bool").basic, BasicType::integer);
  EXPECT_EQ(read_type(" global void").basic, BasicType::none);
  EXPECT_EQ(read_type(" const (read only) double").basic, BasicType::floating);
}

TEST(SyntaxType, ArraysHaveNoComponents) {
  EXPECT_FALSE(read_type(" temp 2-element array of 3-component vector of float").has_components());
  EXPECT_TRUE(read_type(" smooth out unsized 1-element array of 4-component vector of float TexCoord").array);
  EXPECT_TRUE(read_type("layout( offset=0) buffer runtime-sized array of float").array);
}

TEST(SyntaxType, BuiltInVariablesHaveStorage) {
  EXPECT_EQ(read_type(" gl_Position 4-component vector of float Position").storage, StorageClass::output);
  EXPECT_EQ(read_type(" gl_VertexId int VertexId").storage, StorageClass::input);
}

TEST(SyntaxType, MembersAreNamed) {
  const Type block = read_type(
      "layout( binding=1 column_major std430) buffer block{layout( offset=0) buffer int n, layout( offset=16) buffer "
      "structure{ global 3-component vector of float a,  global 4-element array of float b} s,  gl_Position "
      "4-component vector of float Position gl_Position}");
  EXPECT_EQ(block.storage, StorageClass::buffer);
  ASSERT_EQ(block.members.size(), 3U);
  EXPECT_EQ(block.members[0].name, "n");
  EXPECT_EQ(block.members[1].type.members[1].name, "b");
  EXPECT_EQ(block.member("gl_Position"), 2U);
  EXPECT_EQ(block.member("Position"), std::nullopt);
}

TEST(SyntaxType, SamplersAreOpaque) {
  EXPECT_EQ(read_type(" uniform usampler2D").basic, BasicType::opaque);
  EXPECT_EQ(read_type("layout( binding=0 offset=0) uniform atomic_uint").basic, BasicType::opaque);
}

}  // namespace
}  // namespace glark::refine
