// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Which of the application's queries are active.
#include "glark/core/state/active_queries.h"

#include <gtest/gtest.h>

namespace glark::core {
namespace {

TEST(ActiveQueries, CountPrimitivesOrNot) {
  ActiveQueries queries;
  EXPECT_TRUE(queries.none());
  queries.begin(GL_FRAGMENT_SHADER_INVOCATIONS, 0, 1);
  EXPECT_FALSE(queries.none());
  EXPECT_FALSE(queries.primitives());
  queries.begin(GL_VERTICES_SUBMITTED, 0, 2);
  EXPECT_TRUE(queries.primitives());
  queries.end(GL_VERTICES_SUBMITTED, 0);
  EXPECT_FALSE(queries.primitives());
}

TEST(ActiveQueries, OnesThatAreNotActiveAreNotEnded) {
  ActiveQueries queries;
  queries.begin(GL_VERTICES_SUBMITTED, 0, 1);
  queries.end(GL_PRIMITIVES_SUBMITTED, 0);
  queries.end(GL_VERTICES_SUBMITTED, 1);
  EXPECT_TRUE(queries.primitives());
}

TEST(ActiveQueries, StreamsAreApart) {
  ActiveQueries queries;
  queries.begin(GL_PRIMITIVES_GENERATED, 2, 1);
  EXPECT_EQ(queries.generated(), 0U);
  queries.begin(GL_PRIMITIVES_GENERATED, 0, 2);
  queries.begin(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, 0, 3);
  EXPECT_EQ(queries.generated(), 2U);
  EXPECT_EQ(queries.written(), 3U);
  queries.end(GL_PRIMITIVES_GENERATED, 2);
  EXPECT_EQ(queries.generated(), 2U);
  queries.end(GL_PRIMITIVES_GENERATED, 0);
  EXPECT_EQ(queries.generated(), 0U);
}

TEST(ActiveQueries, DeletionEndsThem) {
  ActiveQueries queries;
  queries.begin(GL_COMPUTE_SHADER_INVOCATIONS, 0, 1);
  queries.begin(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, 0, 2);
  queries.deleted(3);
  EXPECT_EQ(queries.written(), 2U);
  queries.deleted(2);
  EXPECT_EQ(queries.written(), 0U);
  queries.deleted(1);
  EXPECT_TRUE(queries.none());
}

TEST(ActiveQueries, OneStopsForAWhile) {
  ActiveQueries queries;
  queries.begin(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, 0, 4);
  EXPECT_EQ(queries.stop_written(), 4U);
  EXPECT_EQ(queries.written(), 0U);
  EXPECT_TRUE(queries.primitives());
  queries.resume_written(4);
  EXPECT_EQ(queries.written(), 4U);
}

}  // namespace
}  // namespace glark::core
