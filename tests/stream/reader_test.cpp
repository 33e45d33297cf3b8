// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What every reader promises: at most as many points as were asked for, and no point is passed over after an error.
#include <array>
#include <cstring>
#include <limits>

#include "tests/stream/temporary_folder.h"

namespace glark::stream {
namespace {

class Reading : public TemporaryFolder {
 protected:
  // Points (0, 0, 0), (1, 0, 0) and so on; point 3 has NaN.
  std::filesystem::path with_nan(const char* name) const {
    const auto writer = create_points(path(name), {}, std::nullopt, {.text = std::string_view(name) == "text.ply"});
    for (int i = 0; i < 10; ++i) {
      const std::array<double, 3> p{double(i), 0, i == 3 ? std::numeric_limits<double>::quiet_NaN() : 0};
      writer->write({0, p, {}, {}});
    }
    writer->finish();
    return path(name);
  }
};

TEST_F(Reading, AnErrorStays) {
  for (const char* name : {"a.ply", "text.ply", "a.raw"}) {
    const auto reader = open_points(with_nan(name));
    EXPECT_EQ(reader->read(2).size(), 2U);
    const std::string problem = problem_of([&] { reader->read(2); });
    EXPECT_NE(problem.find("3 has a coordinate"), std::string::npos) << problem;
    EXPECT_EQ(problem_of([&] { reader->read(2); }), problem);
    EXPECT_EQ(problem_of([&] { reader->read(100); }), problem);
  }
}

TEST_F(Reading, AWordThatIsNoNumberStaysAnError) {
  const auto reader = open_points(made("a.xyz", std::string(30000, '\n') + "1 2 3\n4 5 6\n7 8 9\n"));
  EXPECT_EQ(reader->read(2).size(), 2U);
  std::string lines;
  for (int i = 0; i < 5000; ++i) lines += "1 2 3\n";
  const auto bad = open_points(made("b.xyz", lines + "1 2 x\n" + lines));
  EXPECT_EQ(bad->read(5000).size(), 5000U);
  const std::string problem = problem_of([&] { bad->read(1); });
  EXPECT_NE(problem.find("line 5001"), std::string::npos) << problem;
  EXPECT_EQ(problem_of([&] { bad->read(1); }), problem);
}

TEST_F(Reading, SeekingLeavesTheErrorBehind) {
  const auto reader = open_points(with_nan("a.ply"));
  EXPECT_NE(problem_of([&] { reader->read(5); }), "");
  reader->seek(4);
  const Points points = reader->read(5);
  ASSERT_EQ(points.size(), 5U);
  EXPECT_EQ(points.first, 4U);
  EXPECT_EQ(points.positions[0], 4);
}

TEST_F(Reading, TheCornersOfATriangleMayBeReadOneByOne) {
  const auto writer = create_points(path("a.stl"), {});
  AllPoints all;
  for (int i = 0; i < 12; ++i) all.positions.insert(all.positions.end(), {double(i), double(i * i), 1});
  writer->write(all.points());
  writer->finish();
  const AllPoints whole = read_all(*open_points(path("a.stl")));
  EXPECT_EQ(whole.positions, all.positions);
  for (const std::size_t most : {1, 2, 4, 5}) {
    const auto reader = open_points(path("a.stl"));
    const Points first = reader->read(most);
    EXPECT_EQ(first.size(), most);
    reader->seek(0);
    const AllPoints parts = read_all(*reader, most);
    EXPECT_EQ(parts.positions, whole.positions);
    EXPECT_EQ(parts.normals, whole.normals);
    EXPECT_EQ(parts.blocks, (12 + most - 1) / most);
  }
}

TEST_F(Reading, NothingCannotBeAskedFor) {
  const auto reader = open_points(made("a.xyz", "1 2 3\n"));
  EXPECT_NE(problem_of([&] { reader->read(0); }).find("most is 0"), std::string::npos);
  EXPECT_EQ(reader->read(1).size(), 1U);
}

// A name with and without the dot, as in the options of other functions.
TEST_F(Reading, AFormatMayBeNamedWithoutItsDot) {
  const auto file = made("points", "1 2 3\n");
  EXPECT_EQ(open_points(file, {.format = "xyz"})->read(1).size(), 1U);
  EXPECT_EQ(open_points(file, {.format = ".XYZ"})->read(1).size(), 1U);
  EXPECT_NE(problem_of([&] { open_points(made("points.zst", "1 2 3\n")); }).find("has no ending that tells its format"),
            std::string::npos);
}

}  // namespace
}  // namespace glark::stream
