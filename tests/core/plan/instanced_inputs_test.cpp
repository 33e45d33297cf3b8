// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/plan/inputs/instanced_inputs.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace glark::core {
namespace {

const std::vector<capture::Field> fields = {{.name = "p", .type = GL_FLOAT_VEC4, .location = 0},
                                            {.name = "matrix", .type = GL_FLOAT_MAT4, .location = 1},
                                            {.name = "number", .type = GL_INT, .location = 7},
                                            {.name = "gl_InstanceID", .type = GL_INT, .location = -1}};

std::uint32_t with_divisors(const std::set<int>& locations) {
  return instanced_inputs(fields, [&](int location) { return locations.contains(location); });
}

TEST(InstancedInputs, AreNamedByTheirLocations) {
  EXPECT_EQ(with_divisors({}), 0U);
  EXPECT_EQ(with_divisors({7}), 1U << 7U);
  EXPECT_EQ(with_divisors({0, 7}), 1U | 1U << 7U);
}

TEST(InstancedInputs, AMatrixNeedsTheDivisorInAllColumns) {
  EXPECT_EQ(with_divisors({1, 2, 3}), 0U);
  EXPECT_EQ(with_divisors({1, 2, 3, 4}), 1U << 1U);
}

}  // namespace
}  // namespace glark::core
