// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Each bad file gives an Error that names the file, the element and the remedy.
#include <cstring>
#include <limits>

#include "tests/stream/temporary_folder.h"

namespace glark::stream {
namespace {

using BadFiles = TemporaryFolder;

const std::string xyz = "property float x\nproperty float y\nproperty float z\nend_header\n";
const std::string binary = "ply\nformat binary_little_endian 1.0\n";

TEST_F(BadFiles, AreExplained) {
  struct Case {
    const char* file;
    std::string contents;
    const char* said;
  };
  std::string las(227, '\0');
  std::memcpy(las.data(), "LASF", 4);
  las[24] = 1;
  las[25] = 2;
  las[94] = las[96] = static_cast<char>(227);
  std::string laz = las;
  laz[104] = static_cast<char>(0x80);
  std::string short_las = las;
  short_las[105] = 20;
  short_las[107] = 9;
  short_las[131 + 7] = short_las[139 + 7] = short_las[147 + 7] = 0x40;  // scales of 2
  std::string no_scale = short_las;
  no_scale[107] = 0;
  no_scale[131 + 7] = 0;
  const Case cases[] = {
      {"a.ply", "", "is empty"},
      {"a.ply", "solid", "does not begin with \"ply\""},
      {"a.ply", binary + "element vertex 9\n" + xyz + "abc", "too short"},
      {"a.ply", binary + "element face 0\n" + xyz, "no element vertex"},
      {"a.ply", binary + "element vertex 0\nproperty float x\nend_header\n", "no property y"},
      {"a.ply", "ply\nformat ascii 1.0\nelement vertex 2\n" + xyz + "1 2 3\n4 5 six\n", "\"six\" is not a number"},
      {"a.xyz", "# nothing\n", "has no points"},
      {"a.xyz", "1 2 3\n4 5\n", "line 2: 2 columns"},
      {"a.xyz", "1 2 3\n4 5 x\n", "not a row of numbers"},
      {"a.pts", "3\n1 2 3\n", "announces 3 points, 1 follow"},
      {"a.raw", "1234567", "no triples of floats"},
      {"a.stl", "solid cube", "at least 84"},
      {"a.stl", "solid cube" + std::string(200, ' '), "STL as text"},
      {"a.las", "LASF", "ends within it"},
      {"a.las", "PK\3\4", "does not begin with \"LASF\""},
      {"a.las", laz, "compressed (LAZ)"},
      {"a.las", short_las, "announces 9 points"},
      {"a.las", no_scale, "is no size"},
      {"a.laz", "LASF", "laszip"},
      {"a.e57", "ASTM-E57", "CloudCompare"},
      {"a.dwg", "AC10", "no format that can be streamed"},
  };
  for (const Case& bad : cases) {
    const std::string problem = problem_of([&] { read_all(*open_points(made(bad.file, bad.contents))); });
    EXPECT_NE(problem.find(bad.said), std::string::npos) << bad.file << " " << bad.said << ": " << problem;
    EXPECT_NE(problem.find(path(bad.file).string()), std::string::npos) << problem;
  }
}

TEST_F(BadFiles, ACoordinateThatIsNotFiniteNamesThePoint) {
  std::string bytes = binary + "element vertex 3\n" + xyz + std::string(36, '\0');
  const float bad = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(&bytes[bytes.size() - 8], &bad, sizeof(bad));
  const auto file = made("a.ply", bytes);
  EXPECT_NE(problem_of([&] { read_all(*open_points(file)); }).find("vertex 2"), std::string::npos);
  EXPECT_EQ(read_all(*open_points(file, {.keep_invalid = true})).positions.size(), 9U);
}

TEST_F(BadFiles, AFileThatShrinksWhileItIsReadIsExplained) {
  const auto file = made("a.ply", binary + "element vertex 1000\n" + xyz + std::string(12000, '\0'));
  const auto reader = open_points(file);
  std::filesystem::resize_file(file, 2000);
  EXPECT_NE(problem_of([&] { read_all(*reader, 100); }).find("ends at byte 2000"), std::string::npos);
}

TEST_F(BadFiles, WhatCannotBeSampledIsSaidBeforeTheWork) {
  const auto good = made("a.ply", binary + "element vertex 2\n" + xyz + std::string(24, '\1'));
  const auto empty = made("empty.ply", binary + "element vertex 0\n" + xyz);
  made("out.ply", "old");
  ASSERT_EQ(mkfifo(path("pipe.ply").c_str(), 0600), 0);
  struct Case {
    std::filesystem::path large, small;
    const char* said;
  };
  for (const Case& bad :
       {Case{empty, path("out.ply"), "it has no points"}, Case{path("pipe.ply"), path("out.ply"), "is no regular file"},
        Case{"-", path("out.ply"), "is no regular file"},
        Case{good, path("out.obj"), "names no format that glark streams to"},
        Case{good, path("none/out.ply"), "there is no folder"}}) {
    for (const bool in_core : {true, false}) {
      SampleOptions options{.target = 1, .work = path("work")};
      options.allow_in_core = in_core;
      const std::string problem = problem_of([&] { sample_file(bad.large, bad.small, options); });
      EXPECT_NE(problem.find(bad.said), std::string::npos) << problem;
      EXPECT_FALSE(std::filesystem::exists(path("work"))) << bad.said;
    }
  }
  EXPECT_EQ(bytes_of(path("out.ply")), "old");
  EXPECT_FALSE(std::filesystem::exists(path("none")));
}

TEST_F(BadFiles, NumbersThatDoNotFitAreExplained) {
  const Schema schema{Number::float32, false, {{"red", Number::uint8}}};
  const std::vector<double> position{1, 2, 3}, red{256};
  const auto writer = create_points(path("a.ply"), schema);
  EXPECT_NE(problem_of([&] { writer->write({0, position, {}, red}); }).find("is 256"), std::string::npos);
  const std::vector<double> far{1e300, 0, 0}, byte{1};
  EXPECT_NE(problem_of([&] { writer->write({0, far, {}, byte}); }).find("1e+300"), std::string::npos);
}

TEST_F(BadFiles, AWrongCountKeepsTheOldFile) {
  made("a.ply", "old");
  const std::vector<double> position{1, 2, 3};
  const auto writer = create_points(path("a.ply"), {}, 2);
  writer->write({0, position, {}, {}});
  EXPECT_NE(problem_of([&] { writer->finish(); }).find("2 points were announced"), std::string::npos);
  EXPECT_EQ(bytes_of(path("a.ply")), "old");
}

}  // namespace
}  // namespace glark::stream
