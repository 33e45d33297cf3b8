// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// OFF files: variants of the header, and damaged files, which must not change in silence.
#include <fmt/format.h>

#include <array>
#include <string>

#include "tests/geometry/temporary_file.h"

namespace glark::geometry {
namespace {

using OffFiles = TemporaryFolder;

constexpr char points[] = "0 0 0\n1 0 0\n0 1 0\n";

TEST_F(OffFiles, HeadersMayDiffer) {
  for (const char* head : {"OFF\n3 1 0\n", "OFF 3 1 0\n", "OFF3 1 0\n", "OFF\n3 1\n", "3 1 0\n",
                           "OFF # a\n# b\n\n 3 1 0 # c\r\n\r\n", "OFF\n3\n1\n0\n", "OFF\n3\n1\n",
                           "\xEF\xBB\xBFOFF\n3 1 0\n", "off\n3 1 0\n", "nOFF\n3\n3 1 0\n", "nOFF 3 3 1 0\n"}) {
    const Reading reading = read_file(made("a.off", head + std::string(points) + "3 0 1 2\n"), {});
    EXPECT_EQ((std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}), reading.geometry.positions) << head;
    EXPECT_EQ((std::vector<std::uint32_t>{0, 1, 2}), reading.geometry.triangles) << head;
    EXPECT_TRUE(reading.warnings.empty()) << head;
  }
}

TEST_F(OffFiles, VerticesMayHaveMore) {
  const Geometry all =
      read_file(made("a.off", "STCNOFF\n2 0 0\n1 2 3  0 0 1  1 .5 0 1  .25 .75\n4 5 6  0 1 0  0 0 0 .5  0 1\n"), {})
          .geometry;
  EXPECT_EQ((std::vector<float>{1, 2, 3, 4, 5, 6}), all.positions);
  EXPECT_EQ((std::vector<float>{0, 0, 1, 0, 1, 0}), all.normals);
  EXPECT_EQ((std::vector<std::uint8_t>{255, 128, 0, 255, 0, 0, 0, 128}), all.colours);
  EXPECT_EQ((std::vector<float>{.25F, .75F, 0, 1}), all.texture_coordinates);
  const Geometry bytes = read_file(made("b.off", "COFF\n1 0 0\n1 2 3 200 100 0\n"), {}).geometry;
  EXPECT_EQ((std::vector<std::uint8_t>{200, 100, 0, 255}), bytes.colours);
  const Geometry divided = read_file(made("c.off", "4OFF\n1 0 0\n1 2 3 2\n"), {}).geometry;
  EXPECT_EQ((std::vector<float>{.5F, 1, 1.5F}), divided.positions);
  const Geometry flat = read_file(made("d.off", "nOFF\n2\n1 0 0\n1 2\n"), {}).geometry;
  EXPECT_EQ((std::vector<float>{1, 2, 0}), flat.positions);
}

TEST_F(OffFiles, WhatIsNotKeptIsAWarning) {
  struct Case {
    std::string contents;
    const char* said;
  };
  const Case cases[] = {
      {"OFF\n3 1 0\n" + std::string(points) + "3 0 1 2 .5 .5 0\n", "colours of the faces"},
      {"OFF\n3 1 0\n0 0 0 9\n1 0 0\n0 1 0\n3 0 1 2\n", "more numbers than the header announces"},
      {"OFF\n3 1 0\n" + std::string(points) + "3 0 1 2\n3 0 2 1\n", "follows the last face"},
      {"OFF\n3 2 0\n" + std::string(points) + "3 0 1 2\n2 0 1\n", "fewer than three corners"},
  };
  for (const Case& lossy : cases) {
    const Reading reading = read_file(made("a.off", lossy.contents), {});
    EXPECT_EQ(1U, reading.geometry.triangle_count());
    ASSERT_EQ(1U, reading.warnings.size()) << lossy.contents;
    EXPECT_NE(std::string::npos, reading.warnings[0].find(lossy.said)) << reading.warnings[0];
  }
}

TEST_F(OffFiles, DamagedOnesAreExplained) {
  const std::string head = "OFF\n3 2 0\n" + std::string(points) + "3 0 1 2\n";
  struct Case {
    std::string contents;
    const char* said;
  };
  const Case cases[] = {
      {head + "3 0 1 7\n", "face 1: it has the corner 7, but there are only 3 points"},
      {head + "3 0 1 3\n", "face 1: it has the corner 3"},
      {head + "3 0 1 4294967296\n", "face 1: it has the corner 4294967296"},
      {head + "3 0 1 18446744073709551616\n", "face 1: \"18446744073709551616\" is no index"},
      {head + "3 0 1 -1\n", "face 1: \"-1\" is no index"},
      {head + "3 0 1 1.5\n", "face 1: \"1.5\" is no index"},
      {head, "face 1: the file ends here, its header announces 2 faces"},
      {head + "3 0 1", "face 1: it announces 3 corners, its line has 2"},
      {head + "99999999 0 1 2\n", "face 1: it announces 99999999 corners, its line has 3"},
      {head + "-3 0 1 2\n", "face 1: \"-3\" is no number of corners"},
      {"OFF\n3 0 0\n0.00 0 0\n1 0\n0 1 0\n", "vertex 1: its line has 2 numbers, 3 are due"},
      {"COFF\n2 0 0\n0 0 0 1 1 1\n1 0 0\n", "vertex 1: its line has 3 numbers, 6 are due"},
      {"OFF\n3 0 0\n0 0 0\n1 x 0\n0 1 0\n", "vertex 1: \"x\" is not a number"},
      {"OFF\n3 0 0\n0.00 0 0\n1 0.25 0.5\n", "vertex 2: the file ends here, its header announces 3 points"},
      {"OFF\n3 0 0\n0 0 0\n1 nan 0\n0 1 0\n", "vertex 1 has a coordinate that is NaN"},
      {"4OFF\n1 0 0\n1 2 3 0\n", "vertex 0 has a coordinate that is NaN or infinite"},
      {"OFF\n0 0 0\n", "it has no points"},
      {"OFF\n3 -1 0\n", "header: \"-1\" is not a count"},
      {"OFF\n3", "header: the file ends here"},
      {"OFF\n9223372036854775808 0 0\n0 0 0\n", "for which the file is too short"},
      {"nOFF\n5\n1 0 0\n0 0 0 0 0\n", "have 5 coordinates"},
      {"OFF BINARY\n\1\2\3", "is a binary OFF file"},
      {"solid a", "begins with \"solid\"; check the format"},
  };
  for (const Case& bad : cases) {
    const std::string problem = problem_with(made("a.off", bad.contents));
    EXPECT_NE(std::string::npos, problem.find(bad.said)) << bad.contents << ": " << problem;
    EXPECT_NE(std::string::npos, problem.find("a.off")) << problem;
  }
}

TEST_F(OffFiles, FarFromZeroTheDigitsAreKept) {
  const Geometry geometry =
      read_file(made("a.off", "OFF\n2 0 0\n4500000.25 5400000 0\n4500001.5 5400000 0\n"), {}).geometry;
  EXPECT_EQ(4500000.0, geometry.origin[0]);
  EXPECT_EQ(1.5F, geometry.positions[3]);
}

TEST_F(OffFiles, ASmallModelAtSomeDistanceKeepsItsDigits) {
  for (const int distance : {0, 5, 100, 3000, -8000}) {
    std::string text = "OFF\n100 0 0\n";
    const auto coordinate = [&](int i, int axis) { return distance * (axis + 1) + 0.00123 * i * (axis - 1.5); };
    for (int i = 0; i < 100; ++i)
      text += fmt::format("{} {} {}\n", coordinate(i, 0), coordinate(i, 1), coordinate(i, 2));
    const Geometry geometry = read_file(made("a.off", text), {}).geometry;
    for (int i = 0; i < 300; ++i)
      EXPECT_NEAR(coordinate(i / 3, i % 3), geometry.origin[i % 3] + static_cast<double>(geometry.positions[i]), 1e-7)
          << distance << ": " << i;
    if (distance == 0) {
      EXPECT_EQ((std::array<double, 3>{}), geometry.origin);  // floats suffice
    }
  }
}

// A first point that is invalid tells nothing about the origin.
TEST_F(OffFiles, AnInvalidPointBeforeOneThatIsFarOrAtZero) {
  const Geometry far = read_file(made("a.off", "OFF\n3 0 0\nnan 0 0\n4500000.25 5400000 0\n4500001.5 5400000 0\n"),
                                 {.skip_invalid = true})
                           .geometry;
  ASSERT_EQ(far.positions.size(), 6U);
  EXPECT_EQ(4500001.5, far.origin[0] + static_cast<double>(far.positions[3]));
  const Geometry zero =
      read_file(made("a.off", "OFF\n4 0 0\n0 0 0\nnan 0 0\n0 0 0\n0 0 0\n"), {.skip_invalid = true}).geometry;
  EXPECT_EQ(zero.positions, std::vector<float>(9));
}

TEST_F(OffFiles, InvalidPointsDoNotDisturbTheOrigin) {
  const Geometry geometry =
      read_file(made("a.off", "OFF\n5 1 0\nnan 0 0\n3000.1 1 1\n3000.2 inf 1\n3000.3 1 1\n3000.3 1.1 1\n3 1 3 4\n"),
                {.skip_invalid = true})
          .geometry;
  ASSERT_EQ(3U, geometry.point_count());
  EXPECT_NEAR(3000.1, geometry.origin[0] + static_cast<double>(geometry.positions[0]), 1e-8);
  EXPECT_NEAR(3000.3, geometry.origin[0] + static_cast<double>(geometry.positions[3]), 1e-8);
  EXPECT_NEAR(1.1, geometry.origin[1] + static_cast<double>(geometry.positions[7]), 1e-8);
  EXPECT_EQ(1U, geometry.triangle_count());
}

TEST_F(OffFiles, EqualPointsAreJoinedUnlessAllAreWanted) {
  const auto file = made("a.off", "OFF\n6 2 0\n0 0 0\n1 0 0\n0 1 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n3 3 5 4\n");
  EXPECT_EQ(read_file(file, {}).geometry.point_count(), 4U);
  EXPECT_EQ(read_file(file, {.all_points = true}).geometry.point_count(), 6U);
}

}  // namespace
}  // namespace glark::geometry
