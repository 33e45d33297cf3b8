// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Edits of a sampling on the whole scan, against the same edits of the scan itself.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <numeric>
#include <random>

#include "tests/stream/edited_sheets.h"

namespace glark::stream {
namespace {

const double diagonal = std::hypot(10, 4);

TEST_F(Edited, NothingMovesWithoutAnEdit) {
  EXPECT_LT(error_of([](const Point& p) { return p; }), 1e-6);
  EXPECT_TRUE(bytes_of(path("large.ply")) == bytes_of(path("out.ply")));
}

TEST_F(Edited, RigidMotionsAreExact) {
  EXPECT_LT(error_of([](const Point& p) { return Point{-p[1] + 3, p[0], p[2] - 7}; }), 1e-5 * diagonal);
}

TEST_F(Edited, ScalesAreExact) {
  EXPECT_LT(error_of([](const Point& p) { return Point{2 * p[0], 2 * p[1], 2 * p[2]}; }), 1e-4 * diagonal);
}

// From millimetres to metres, for example: heights and details are scaled, too.
TEST_F(Edited, ChangesOfUnitsAreExact) {
  for (const double scale : {1e-3, 1 / 25.4, 10.0, 1e3})
    EXPECT_LT(error_of([&](const Point& p) {
                return Point{scale * p[0], scale * p[1], scale * p[2]};
              }),
              1e-4 * diagonal * scale)
        << scale;
}

// Where no triangle of samples is around a point, at a border for example, the point moves as all samples near it do.
TEST_F(Edited, PointsOutsideOfAllTrianglesTurnAndScale) {
  AllPoints large, small, edited;
  for (int i = 0; i < 60; ++i) {
    const double x = 0.1 * i, y = 0.1 * (i % 3);  // a strip: all samples are on one side of the points
    for (AllPoints* all : {&large, &small}) all->normals.insert(all->normals.end(), {0, 0, 1});
    large.positions.insert(large.positions.end(), {x, 1.5 + y, 0});
    small.positions.insert(small.positions.end(), {x, y, 0});
  }
  const auto turn = [](const Point& p) { return Point{-2 * p[1] + 3, 2 * p[0], 2 * p[2] - 7}; };
  write("large.ply", large, plain);
  write("small.ply", small, plain);
  write("edited.ply", moved(small, turn), plain);
  transfer(path("large.ply"), path("small.ply"), path("edited.ply"), path("out.ply"));
  const AllPoints out = read_all(*open_points(path("out.ply"))), wanted = moved(large, turn);
  for (std::size_t i = 0; i < wanted.positions.size(); ++i)
    EXPECT_NEAR(out.positions[i], wanted.positions[i], 2e-2) << i;
}

// The sheet becomes part of a cylinder, by a quarter turn.
TEST_F(Edited, ABendIsNear) {
  const auto bend = [](const Point& p) {
    const double angle = p[0] / 10 * 1.5707963, r = 10 / 1.5707963 - p[2];
    return Point{r * std::sin(angle), p[1], 10 / 1.5707963 - r * std::cos(angle)};
  };
  EXPECT_LT(error_of(bend), 5e-4 * diagonal);
  const AllPoints out = read_all(*open_points(path("out.ply"))), large = sheet(100);
  double sum = 0;
  for (std::size_t i = 0; i < out.positions.size() / 3; ++i) {
    const double turn = large.positions[3 * i] / 10 * 1.5707963;
    const double nx = large.normals[3 * i], nz = large.normals[3 * i + 2];
    const double cosine = out.normals[3 * i] * (nx * std::cos(turn) - nz * std::sin(turn)) +
                          out.normals[3 * i + 2] * (nx * std::sin(turn) + nz * std::cos(turn));
    sum += std::pow(std::acos(std::min(1.0, cosine)), 2);
  }
  EXPECT_LT(std::sqrt(sum / (static_cast<double>(out.positions.size()) / 3)), 3 * 3.14159 / 180);
}

// Points in any order, and samples at equal distances: the same bits, however many points are edited at a time.
TEST_F(Edited, TheOrderOfThePointsMakesNoDifference) {
  const AllPoints large = sheet(300), small = sheet(100);
  std::vector<std::size_t> order(large.positions.size() / 3);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::shuffle(order.begin(), order.end(), std::mt19937(7));  // NOLINT(cert-msc51-cpp): each run is the same
  const auto shuffled = [&](const AllPoints& all) {
    AllPoints result;
    for (const std::size_t i : order) {
      const auto begin = static_cast<std::ptrdiff_t>(3 * i);
      const auto positions = all.positions.begin() + begin;
      const auto normals = all.normals.begin() + begin;
      result.positions.insert(result.positions.end(), positions, positions + 3);
      result.normals.insert(result.normals.end(), normals, normals + 3);
    }
    return result;
  };
  const Edit bend = [](const Point& p) { return Point{p[0], p[1], p[2] + 0.05 * p[0] * p[0] + 0.1 * p[0] * p[1]}; };
  write("large.ply", large, plain);
  write("shuffled.ply", shuffled(large), plain);
  write("small.ply", small, plain);
  write("edited.ply", moved(small, bend), plain);
  transfer(path("large.ply"), path("small.ply"), path("edited.ply"), path("out.ply"));
  transfer(path("shuffled.ply"), path("small.ply"), path("edited.ply"), path("shuffled.out.ply"));
  write("expected.ply", shuffled(read_all(*open_points(path("out.ply")))), plain);
  EXPECT_TRUE(bytes_of(path("expected.ply")) == bytes_of(path("shuffled.out.ply")));
}

TEST_F(Edited, ColoursAreAddedAndTrianglesStay) {
  AllPoints small = sheet(18);
  write("small.ply", small, plain);
  for (std::size_t i = 0; i < small.positions.size(); i += 3)
    small.channels.insert(small.channels.end(), {20 * small.positions[i], 7, 255});
  write("edited.ply", small, painted);
  write("large.ply", sheet(100), plain);
  std::string bytes = bytes_of(path("large.ply"));
  bytes.insert(bytes.find("end_header"), "element face 1\nproperty list uchar int vertex_indices\n");
  const std::string face("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13);
  transfer(made("faces.ply", bytes + face), path("small.ply"), path("edited.ply"), path("out.ply"));
  const auto reader = open_points(path("out.ply"));
  EXPECT_EQ(reader->schema(), painted);
  const AllPoints out = read_all(*reader), large = sheet(100);
  for (std::size_t i = 0; i < out.positions.size() / 3; ++i) {
    EXPECT_NEAR(out.channels[3 * i], 20 * large.positions[3 * i], 8);
    EXPECT_EQ(out.channels[3 * i + 1], 7);
    EXPECT_EQ(out.channels[3 * i + 2], 255);
  }
  EXPECT_TRUE(bytes_of(path("out.ply")).ends_with(face));
}

// Paint on a part: far from it every byte stays, within it the paint covers, and between them no value is beyond both.
TEST_F(Edited, ColoursAwayFromThePaintStay) {
  AllPoints small = sheet(40), large = sheet(100);
  const auto colour = [](AllPoints& all) {
    for (std::size_t i = 0; i < all.positions.size(); i += 3) {
      const double stripe = static_cast<double>(i / 3 % 7 * 30);  // finer than the samples
      all.channels.insert(all.channels.end(), {stripe, stripe, 40});
    }
  };
  colour(small);
  colour(large);
  write("small.ply", small, painted);
  for (std::size_t i = 0; i < small.positions.size(); i += 3)
    if (small.positions[i] > 6) std::fill_n(small.channels.begin() + static_cast<std::ptrdiff_t>(i), 2, 200);
  write("edited.ply", small, painted);
  write("large.ply", large, painted);
  transfer(path("large.ply"), path("small.ply"), path("edited.ply"), path("out.ply"));
  const AllPoints out = read_all(*open_points(path("out.ply")));
  for (std::size_t i = 0; i < out.channels.size(); i += 3) {
    const double own = large.channels[i], x = large.positions[i];
    if (x < 5.4) {
      EXPECT_EQ(out.channels[i], own);
    }
    if (x > 6.6) {
      EXPECT_NEAR(out.channels[i], 200, 1);
    }
    EXPECT_GE(out.channels[i], std::min(own, 200.0) - 1);
    EXPECT_EQ(out.channels[i + 2], 40);
  }
}

TEST_F(Edited, PointsAwayFromTheDeformationStay) {
  write("large.ply", sheet(100), plain);
  write("small.ply", sheet(18), plain);
  const Edit lift = [](const Point& p) { return Point{p[0], p[1], p[2] + (p[0] > 6 ? 0.3 * (p[0] - 6) : 0)}; };
  write("edited.ply", moved(sheet(18), lift), plain);
  transfer(path("large.ply"), path("small.ply"), path("edited.ply"), path("out.ply"));
  const AllPoints out = read_all(*open_points(path("out.ply"))), large = read_all(*open_points(path("large.ply")));
  for (std::size_t i = 0; i < out.positions.size(); i += 3) {
    if (large.positions[i] > 4) continue;
    for (std::size_t k = i; k < i + 3; ++k) {
      EXPECT_EQ(out.positions[k], large.positions[k]);
      EXPECT_EQ(out.normals[k], large.normals[k]);
    }
  }
}

TEST_F(Edited, SamplesMayBeReordered) {
  const AllPoints small = sheet(18);
  const Edit lift = [](const Point& p) { return Point{p[0], p[1], p[2] + p[0]}; };
  AllPoints reversed;
  for (std::size_t i = small.positions.size() / 3; i-- > 0;) {
    const Point to = lift({small.positions[3 * i], small.positions[3 * i + 1], small.positions[3 * i + 2]});
    reversed.positions.insert(reversed.positions.end(), to.begin(), to.end());
    reversed.channels.push_back(static_cast<double>(i));
  }
  write("small.ply", small, plain);
  write("ordered.ply", moved(small, lift), plain);
  write("edited.ply", reversed, {Number::float32, false, {{"index", Number::int32}}});
  write("large.ply", sheet(40), plain);
  transfer(path("large.ply"), path("small.ply"), path("ordered.ply"), path("a.ply"));
  transfer(path("large.ply"), path("small.ply"), path("edited.ply"), path("b.ply"), {.threads = 1});
  EXPECT_TRUE(bytes_of(path("a.ply")) == bytes_of(path("b.ply")));
}

TEST_F(Edited, SamplesInAnotherOrderAreRefused) {
  const AllPoints small = sheet(30);
  AllPoints reordered = small;
  const std::size_t count = small.positions.size() / 3;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < 3; ++k) reordered.positions[3 * (i * 1013 % count) + k] = small.positions[3 * i + k];
  write("large.ply", sheet(100), plain);
  write("small.ply", small, plain);
  write("reordered.ply", reordered, plain);
  const std::string problem =
      problem_of([&] { transfer(path("large.ply"), path("small.ply"), path("reordered.ply"), path("out.ply")); });
  EXPECT_NE(problem.find("another order"), std::string::npos) << problem;
  EXPECT_FALSE(std::filesystem::exists(path("out.ply")));
}

// A sampling of one scan, and another scan beside it.
TEST_F(Edited, PointsAwayFromAllSamplesAreCounted) {
  const AllPoints small = sheet(30);
  write("large.ply", sheet(100), plain);
  write("other.ply", moved(sheet(100), [](const Point& p) { return Point{p[0] + 30, p[1], p[2]}; }), plain);
  write("small.ply", small, plain);
  EXPECT_LT(transfer(path("large.ply"), path("small.ply"), path("small.ply"), path("out.ply")).points_away, 250);
  const TransferReport report = transfer(path("other.ply"), path("small.ply"), path("small.ply"), path("out.ply"));
  EXPECT_EQ(report.points_away, report.points);
}

TEST_F(Edited, LasKeepsItsOtherNumbers) {
  const Schema las{Number::float64, false, {{"intensity", Number::uint16}, {"classification", Number::uint8}}};
  AllPoints large = sheet(40);
  large.normals.clear();
  for (std::size_t i = 0; i < large.positions.size() / 3; ++i)
    large.channels.insert(large.channels.end(), {static_cast<double>(i), static_cast<double>(i % 30)});
  write("large.las", large, las);
  const AllPoints small = sheet(18);
  write("small.ply", small, plain);
  write("edited.ply", moved(small, [](const Point& p) { return Point{p[0] + 100, p[1], p[2]}; }), plain);
  transfer(path("large.las"), path("small.ply"), path("edited.ply"), path("out.las"));
  const AllPoints before = read_all(*open_points(path("large.las"))), after = read_all(*open_points(path("out.las")));
  EXPECT_EQ(before.channels, after.channels);
  for (std::size_t i = 0; i < before.positions.size(); i += 3)
    EXPECT_NEAR(after.positions[i], before.positions[i] + 100, 1e-3);
}

// Version 1.4 has records of variable length after the points: coordinate systems and waveforms, for example. The header
// has the bytes where they begin.
TEST_F(Edited, LasKeepsWhatFollowsThePoints) {
  AllPoints large = sheet(40);
  large.normals.clear();
  large.channels.assign(large.positions.size() / 3, 7);
  write("large.las", large, {Number::float64, false, {{"gps_time", Number::float64}}});
  std::string bytes = bytes_of(path("large.las"));
  ASSERT_EQ(bytes[25], 4);
  const std::uint64_t end = bytes.size();
  for (const std::size_t at : {227, 235}) std::memcpy(&bytes[at], &end, sizeof end);
  bytes[243] = 1;  // record
  const std::string record = std::string(60, 'v') + "what only other programs know";
  made("large.las", bytes + record);
  write("small.ply", sheet(18), plain);
  write("edited.ply", moved(sheet(18), [](const Point& p) { return Point{p[0] + 100, p[1], p[2]}; }), plain);
  transfer(path("large.las"), path("small.ply"), path("edited.ply"), path("out.las"));
  const std::string out = bytes_of(path("out.las"));
  ASSERT_EQ(out.size(), end + record.size());
  EXPECT_EQ(out.substr(end), record);
  EXPECT_EQ(out.substr(227, 20), bytes.substr(227, 20));
  const AllPoints after = read_all(*open_points(path("out.las")));
  EXPECT_NEAR(after.positions[0], large.positions[0] + 100, 1e-3);
}

TEST_F(Edited, ACoordinateThatLasCannotHoldIsExplained) {
  const Schema las{Number::float64, false, {}};
  AllPoints large = sheet(40);
  large.normals.clear();
  write("large.las", large, las);
  const AllPoints small = sheet(18);
  write("small.ply", small, plain);
  write("edited.ply", moved(small, [](const Point& p) { return Point{p[0] + 1e7, p[1], p[2]}; }), plain);
  const std::string problem =
      problem_of([&] { transfer(path("large.las"), path("small.ply"), path("edited.ply"), path("out.las")); });
  EXPECT_NE(problem.find("out.las: point"), std::string::npos) << problem;
  EXPECT_NE(problem.find("cannot hold"), std::string::npos) << problem;
  EXPECT_FALSE(std::filesystem::exists(path("out.las")));
}

// Many programs write colours of 8 bits into the 16 that LAS has.
TEST_F(Edited, ByteColoursOfLasStayBytes) {
  const Schema las{
      Number::float64, false, {{"red", Number::uint16}, {"green", Number::uint16}, {"blue", Number::uint16}}};
  AllPoints large = sheet(40);
  large.normals.clear();
  for (std::size_t i = 0; i < large.positions.size() / 3; ++i)
    large.channels.insert(large.channels.end(), {60, 100 + static_cast<double>(i % 50), 199});
  write("large.las", large, las);
  sample_file(path("large.las"), path("small.ply"), {.target = 500});
  AllPoints small = read_all(*open_points(path("small.ply")));
  const Schema schema = open_points(path("small.ply"))->schema();
  ASSERT_EQ(schema.channels.size(), 3U);
  EXPECT_EQ(schema.channels[0].type, Number::uint8);
  for (std::size_t i = 0; i < small.channels.size(); i += 3) {
    EXPECT_EQ(small.channels[i], 60);
    EXPECT_EQ(small.channels[i + 2], 199);
    small.channels[i] = 255;
  }
  write("edited.ply", small, schema);
  transfer(path("large.las"), path("small.ply"), path("edited.ply"), path("out.las"));
  const AllPoints after = read_all(*open_points(path("out.las")));
  const Schema out = open_points(path("out.las"))->schema();
  for (std::size_t i = 0; i < after.positions.size() / 3; ++i) {
    const double* colour = &after.channels[i * out.channels.size() + channel_index(out, "red")];
    EXPECT_EQ(colour[0], 255) << i;
    EXPECT_EQ(colour[1], large.channels[3 * i + 1]) << i;
    EXPECT_EQ(colour[2], 199) << i;
  }
}

// Squares of such numbers are infinite as floats, and the points around the sample became NaN.
TEST_F(Edited, ASampleBeyondTheRangeOfFloatsIsRefused) {
  const AllPoints small = sheet(18);
  write("small.ply", small, plain);
  write("large.ply", sheet(40), plain);
  made("out.ply", "old");
  for (const double far : {1e20, -2e18}) {
    AllPoints edited = small;
    edited.positions[3 * 7 + 1] = far;
    write("edited.ply", edited, plain);
    const std::string problem =
        problem_of([&] { transfer(path("large.ply"), path("small.ply"), path("edited.ply"), path("out.ply")); });
    EXPECT_NE(problem.find("edited.ply: point 7"), std::string::npos) << problem;
    EXPECT_NE(problem.find("up to 1e18"), std::string::npos) << problem;
  }
  EXPECT_EQ(bytes_of(path("out.ply")), "old");
}

TEST_F(Edited, TheOutputHasTheEndingOfTheScan) {
  write("small.ply", sheet(18), plain);
  write("large.ply", sheet(40), plain);
  for (const char* name : {"out.las", "out", "out.ply.zst"}) {
    const std::string problem =
        problem_of([&] { transfer(path("large.ply"), path("small.ply"), path("small.ply"), path(name)); });
    EXPECT_NE(problem.find("with the ending .ply"), std::string::npos) << name << ": " << problem;
    EXPECT_FALSE(std::filesystem::exists(path(name)));
  }
  transfer(path("large.ply"), path("small.ply"), path("small.ply"), path("out.PLY"));
  EXPECT_TRUE(bytes_of(path("large.ply")) == bytes_of(path("out.PLY")));
}

TEST_F(Edited, BadInputIsExplained) {
  const AllPoints small = sheet(18);
  write("small.ply", small, plain);
  write("other.ply", sheet(10), plain);
  write("large.ply", sheet(40), plain);
  made("out.ply", "old");
  const auto problem = [&](const char* large, const char* to, const TransferOptions& options = {}) {
    return problem_of([&] { transfer(path(large), path("small.ply"), path(to), path("out.ply"), options); });
  };
  EXPECT_NE(problem("large.ply", "other.ply").find("edit without adding or removing points"), std::string::npos);
  EXPECT_NE(problem("large.ply", "small.ply", {.neighbours = 2}).find("3 to 64"), std::string::npos);
  made("text.xyz", "0 0 0\n");
  EXPECT_NE(problem("text.xyz", "small.ply").find("convert it to binary PLY"), std::string::npos);
  AllPoints repeated = small;
  repeated.normals.clear();
  repeated.channels.assign(small.positions.size() / 3, 5);
  write("repeated.ply", repeated, {Number::float32, false, {{"index", Number::int32}}});
  EXPECT_NE(problem("large.ply", "repeated.ply").find("repeated"), std::string::npos);
  EXPECT_EQ(bytes_of(path("out.ply")), "old");
}

TEST_F(Edited, AnOutputIsNoneOfTheOtherFiles) {
  write("large.ply", sheet(20), plain);
  write("small.ply", sheet(10), plain);
  write("edited.ply", sheet(10), plain);
  std::filesystem::create_symlink(path("large.ply"), path("link.ply"));
  std::filesystem::create_hard_link(path("small.ply"), path("hard.ply"));
  for (const char* output : {"large.ply", "small.ply", "edited.ply", "link.ply", "hard.ply"}) {
    const std::string before = bytes_of(path(output));
    const std::string problem =
        problem_of([&] { transfer(path("large.ply"), path("small.ply"), path("edited.ply"), path(output)); });
    EXPECT_NE(problem.find("is the same file as"), std::string::npos) << output << ": " << problem;
    EXPECT_EQ(before, bytes_of(path(output)));
  }
}

TEST_F(Edited, ResumeWithoutAFolderIsAnError) {
  TransferOptions options;
  options.resume = true;
  write("large.ply", sheet(20), plain);
  EXPECT_NE(
      problem_of([&] { transfer(path("large.ply"), path("large.ply"), path("large.ply"), path("out.ply"), options); }),
      "");
}

}  // namespace
}  // namespace glark::stream
