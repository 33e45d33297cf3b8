// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/evaluate/vertex_format.h"

#include <gtest/gtest.h>

#include "glark/core/capture/layout.h"
#include "glark/core/evaluate/grid_indices.h"

namespace glark::evaluate {
namespace {

VertexFormat format_of(std::vector<capture::Field> fields) {
  return vertex_format(capture::make_layout(std::move(fields), false).fields);
}

TEST(VertexFormat, HasAnAttributeForEachLocation) {
  const VertexFormat format =
      format_of({{.name = "p", .type = GL_FLOAT_VEC3, .location = 0},
                 {.name = "m", .type = GL_FLOAT_MAT3x2, .location = 4},
                 {.name = "a", .type = GL_FLOAT, .array_size = 2, .is_array = true, .location = 9}});
  EXPECT_EQ(format.attributes,
            (std::vector<VertexAttribute>{{0, 3, 0}, {4, 2, 3}, {5, 2, 5}, {6, 2, 7}, {9, 1, 9}, {10, 1, 10}}));
  EXPECT_EQ(format.words, 11);
}

TEST(VertexFormat, HasConventionalAttributes) {
  const VertexFormat format = format_of({{.name = "gl_Vertex", .type = GL_FLOAT_VEC4},
                                         {.name = "gl_SecondaryColor", .type = GL_FLOAT_VEC4},
                                         {.name = "gl_MultiTexCoord3", .type = GL_FLOAT_VEC4}});
  EXPECT_EQ(format.attributes, (std::vector<VertexAttribute>{{core::vertex_slot, 4, 0},
                                                             {core::secondary_color_slot, 3, 4},
                                                             {core::texture_coordinate_slot + 3, 4, 8}}));
}

TEST(VertexFormat, IsEmptyWithInputsThatAreNoFloatsOrNoAttributes) {
  const capture::Field position{.name = "p", .type = GL_FLOAT_VEC3, .location = 0};
  EXPECT_TRUE(format_of({position, {.name = "i", .type = GL_INT, .location = 1}}).attributes.empty());
  EXPECT_TRUE(format_of({position, {.name = "d", .type = GL_DOUBLE_VEC2, .location = 1}}).attributes.empty());
  EXPECT_TRUE(format_of({position, {.name = "gl_VertexID", .type = GL_INT}}).attributes.empty());
}

TEST(VertexFormat, LeavesOutWhatTheVertexStageDoesNotRead) {
  const VertexFormat format = format_of({{.name = "p", .type = GL_FLOAT_VEC3, .location = 0},
                                         {.name = "tags", .type = GL_FLOAT_VEC4, .location = 14, .unread = true},
                                         {.name = "c", .type = GL_FLOAT_VEC2, .location = 1}});
  EXPECT_EQ(format.attributes, (std::vector<VertexAttribute>{{0, 3, 0}, {1, 2, 3}}));
  EXPECT_EQ(format.words, 5);
}

TEST(LatticePoints, AreThoseOfATriangularGrid) {
  EXPECT_EQ(lattice_points(0), 3U);
  EXPECT_EQ(lattice_points(1), 6U);
  EXPECT_EQ(lattice_points(2), 15U);
  EXPECT_EQ(lattice_points(8), 33153U);
}

}  // namespace
}  // namespace glark::evaluate
