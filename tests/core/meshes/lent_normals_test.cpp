// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/meshes/lent_normals.h"

#include <gtest/gtest.h>

namespace glark::core {
namespace {

constexpr AttributeSource positions{.enabled = true, .size = 3, .buffer = 1, .offset = 120, .stride = 12};
constexpr AttributeSource normals{.enabled = true, .size = 3, .buffer = 2, .offset = 1000, .stride = 16};

AttributeSource at(AttributeSource source, GLintptr offset) {
  source.offset = offset;
  return source;
}

class LentNormals : public testing::Test {
 protected:
  LentNormals() { note(positions, normals); }
  void note(const AttributeSource& of, const AttributeSource& are, bool lender_lives = true) {
    beside_.note(of, are, lender_lives);
  }
  NormalsBeside beside_;
};

TEST_F(LentNormals, AreThoseOfTheSameVertices) {
  EXPECT_EQ(beside_.find(positions)->offset, 1000);
  EXPECT_EQ(beside_.find(at(positions, 120 + 5 * 12))->offset, 1000 + 5 * 16);
  EXPECT_EQ(beside_.find(at(positions, 0))->offset, 1000 - 10 * 16);
  EXPECT_EQ(beside_.find(positions)->buffer, 2U);
}

TEST_F(LentNormals, MustLieInTheirBuffer) {
  beside_ = {};
  note(positions, at(normals, 64));
  EXPECT_FALSE(beside_.find(at(positions, 0)).has_value());
}

TEST_F(LentNormals, BelongToWholeVertices) {
  EXPECT_FALSE(beside_.find(at(positions, 124)).has_value());
  AttributeSource wider = positions;
  wider.stride = 24;
  EXPECT_FALSE(beside_.find(wider).has_value());
}

TEST_F(LentNormals, AreNotLentIfPassesDisagree) {
  note(at(positions, 132), at(normals, 1016));
  EXPECT_TRUE(beside_.find(positions).has_value()) << "the next vertex of both";
  note(at(positions, 132), at(normals, 1000));
  EXPECT_FALSE(beside_.find(positions).has_value());
}

// Each half of the positions has its normals in a buffer of its own.
TEST_F(LentNormals, AreNotLentFromTwoBuffers) {
  AttributeSource second = normals;
  second.buffer = 3;
  note(at(positions, 240), second);
  EXPECT_FALSE(beside_.find(positions).has_value());
}

TEST_F(LentNormals, ANewBufferReplacesTheOldOne) {
  AttributeSource renewed = at(normals, 0);
  renewed.generation = 1;
  note(positions, renewed, false);
  EXPECT_EQ(beside_.find(positions)->generation, 1U);
}

TEST_F(LentNormals, OnlyBuffersLend) {
  AttributeSource client = normals;
  client.buffer = 0;
  note(positions, client);
  EXPECT_FALSE(beside_.find(positions).has_value());
}

TEST_F(LentNormals, OnlyVectorsAreLent) {
  AttributeSource bytes = normals;
  bytes.type = GL_BYTE;
  note(positions, bytes);
  EXPECT_FALSE(beside_.find(positions).has_value()) << "the pass itself scales them";
  bytes.normalized = true;
  note(positions, bytes, false);
  EXPECT_TRUE(beside_.find(positions).has_value());
  bytes.divisor = 1;
  note(positions, bytes);
  EXPECT_FALSE(beside_.find(positions).has_value()) << "one normal for each instance";
}

TEST(InitialSources, AreThoseThatNoCallHasSet) {
  EXPECT_TRUE(is_initial({.binding = 3}, 3));
  EXPECT_FALSE(is_initial({.binding = 4}, 3));
  EXPECT_FALSE(is_initial({.enabled = true, .binding = 3}, 3));
  EXPECT_FALSE(is_initial({.binding = 3, .buffer = 1}, 3));
  EXPECT_FALSE(is_initial({.size = 3, .binding = 3}, 3));
}

}  // namespace
}  // namespace glark::core
