// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Rows of numbers as programs write them, and the meaning of their columns.
#include "tests/geometry/temporary_file.h"

namespace glark::geometry {
namespace {

using RowsOfNumbers = TemporaryFolder;

TEST_F(RowsOfNumbers, SeparatorsAndLineEndsAreAnyOfThoseInUse) {
  const std::vector<float> expected{1.5F, 2, 3, 4, 5, 6};
  for (const char* text : {"1.5 2 3\n4 5 6\n", "1.5,2,3\r\n4,5,6\r\n", "1.5;2;3\n4;5;6", "1.5, 2, 3\n4, 5, 6\n",
                           " 1.5\t2\t3 \n\n4 5 6\n", "x,y,z\n1.5,2,3\n4,5,6\n",
                           "\xEF\xBB\xBF"
                           "1.5 2 3\n4 5 6\n",
                           "\xEF\xBB\xBF"
                           "# scan\n1.5 ,2 ,3\n4 ,5 ,6\n"}) {
    EXPECT_EQ(expected, read_file(made("a.xyz", text), {}).geometry.positions) << text;
  }
  EXPECT_EQ(expected, read_file(made("a.pts",
                                     "\xEF\xBB\xBF"
                                     "2\n1.5 2 3\n4 5 6\n"),
                                {})
                          .geometry.positions);
}

TEST_F(RowsOfNumbers, SixColumnsAreNormalsOrColours) {
  struct Case {
    const char* text;
    bool normals;
  };
  for (const Case& rows : {Case{"0 0 0 0 0 1\n0 0 0 0.6 0.8 0\n", true}, Case{"0 0 0 9 80 255\n0 0 0 0 0 1\n", false},
                           Case{"0 0 0 0 0 1\n0 0 0 -2 0 0\n", true}}) {
    const Geometry geometry = read_file(made("a.xyz", rows.text), {}).geometry;
    EXPECT_EQ(rows.normals, !geometry.normals.empty()) << rows.text;
    EXPECT_EQ(rows.normals, geometry.colours.empty()) << rows.text;
  }
}

TEST_F(RowsOfNumbers, ColoursGoToOneOrTo255) {
  const auto colours = [&](const char* name, const char* text) {
    return read_file(made(name, text), {}).geometry.colours;
  };
  const std::vector<std::uint8_t> fractions{255, 128, 0, 255, 51, 0, 255, 255};
  EXPECT_EQ(fractions, colours("a.xyz", "0 0 0 1 0.5 0\n0 0 1 0.2 0 1\n"));
  EXPECT_EQ(fractions, colours("a.pts", "0 0 0 1 0.5 0\n0 0 1 0.2 0 1\n"));
  const std::vector<std::uint8_t> bytes{1, 1, 0, 255, 51, 0, 255, 255};
  EXPECT_EQ(bytes, colours("b.xyz", "0 0 0 1 1 0\n0 0 1 51 0 255\n"));
  EXPECT_EQ(bytes, colours("b.pts", "0 0 0 1 1 0\n0 0 1 51 0 255\n"));
}

}  // namespace
}  // namespace glark::geometry
