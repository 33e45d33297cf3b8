// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Sampling: the number of samples, their distance from a known surface, and the same result for any order of threads.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "glark/clients/stream/sample/grid/cube_table.h"
#include "glark/clients/stream/sample/pass/plan.h"
#include "tests/stream/temporary_folder.h"

namespace glark::stream {
namespace {

using Sampling = TemporaryFolder;

struct Scan {
  std::size_t points = 60000;
  bool normals = true, shuffled = false;
};

// A sphere of radius 3 about (10, 20, 30) in rings from below, its colour red in the upper half.
std::filesystem::path write_sphere(const std::filesystem::path& file, const Scan& scan) {
  const Schema schema{
      Number::float32, scan.normals, {{"red", Number::uint8}, {"green", Number::uint8}, {"blue", Number::uint8}}};
  std::vector<std::size_t> order(scan.points);
  std::iota(order.begin(), order.end(), 0);
  if (scan.shuffled) std::shuffle(order.begin(), order.end(), std::mt19937(1));
  const auto writer = create_points(file, schema, scan.points);
  for (const std::size_t i : order) {
    const double z = 2 * (static_cast<double>(i) + 0.5) / static_cast<double>(scan.points) - 1;
    const double angle = 2.399963229728653 * static_cast<double>(i), r = std::sqrt(1 - z * z);
    const std::vector<double> n{r * std::cos(angle), r * std::sin(angle), z};
    const std::vector<float> normal{static_cast<float>(n[0]), static_cast<float>(n[1]), static_cast<float>(n[2])};
    const std::vector<double> position{10 + 3 * n[0], 20 + 3 * n[1], 30 + 3 * n[2]};
    const std::vector<double> colour{z > 0 ? 200.0 : 0.0, 100, 50};
    writer->write({0, position, scan.normals ? std::span<const float>(normal) : std::span<const float>{}, colour});
  }
  writer->finish();
  return file;
}

SampleReport sample_file(const std::filesystem::path& from, const std::filesystem::path& to, SampleOptions options) {
  options.memory = std::size_t{40} << 20;
  options.allow_in_core = false;
  return sample(file_source(from), options, to.parent_path(),
                [&](const Schema& schema) { return create_points(to, schema); });
}

double mean_square_distance(const AllPoints& all) {
  double sum = 0;
  for (std::size_t i = 0; i < all.positions.size(); i += 3) {
    const double r = std::hypot(all.positions[i] - 10, all.positions[i + 1] - 20, all.positions[i + 2] - 30);
    sum += (r - 3) * (r - 3);
  }
  return std::sqrt(sum / (static_cast<double>(all.positions.size()) / 3));
}

TEST_F(Sampling, MeetsTheTargetAndLiesOnTheSurface) {
  const auto file = write_sphere(path("a.ply"), {});
  for (const std::size_t target : {50, 1000, 8000}) {
    const SampleReport report = sample_file(file, path("b.ply"), {.target = target});
    EXPECT_LE(report.samples, target);
    EXPECT_GE(report.samples, target - target / 100);
    const AllPoints all = read_all(*open_points(path("b.ply")));
    EXPECT_EQ(all.positions.size() / 3, report.samples);
    if (target >= 1000) {
      EXPECT_LT(mean_square_distance(all), 0.01);
    }
  }
}

// A cluster has up to eight parts; so some are merged where all of them would be too many.
TEST_F(Sampling, SmallTargetsAreMetExactly) {
  const auto file = write_sphere(path("a.ply"), {});
  for (const bool in_core : {false, true})
    for (const std::size_t target : {1, 2, 3, 5, 7, 10, 17, 30, 64, 99}) {
      const SampleReport report = in_core ? stream::sample_file(file, path("b.ply"), {.target = target})
                                          : sample_file(file, path("b.ply"), {.target = target});
      EXPECT_EQ(report.in_core, in_core);
      EXPECT_EQ(report.samples, target);
      const AllPoints all = read_all(*open_points(path("b.ply")));
      ASSERT_EQ(all.positions.size() / 3, target);
      EXPECT_EQ(report.cells.back().first_sample + report.cells.back().samples, target);
      for (std::size_t i = 0; i < all.positions.size(); i += 3)
        EXPECT_LE(std::hypot(all.positions[i] - 10, all.positions[i + 1] - 20, all.positions[i + 2] - 30), 5);
    }
}

// Points at one position cannot be told apart.
TEST_F(Sampling, FewPositionsGiveFewSamples) {
  const auto writer = create_points(path("a.ply"), {});
  for (int i = 0; i < 100; ++i) writer->write({0, std::vector<double>{double(i % 4), 0, 0}, {}, {}});
  writer->finish();
  EXPECT_EQ(stream::sample_file(path("a.ply"), path("b.ply"), {.target = 50}).samples, 4U);
}

TEST_F(Sampling, KeepsNormalsAndColours) {
  sample_file(write_sphere(path("a.ply"), {}), path("b.ply"), {.target = 2000});
  const AllPoints all = read_all(*open_points(path("b.ply")));
  for (std::size_t i = 0; i < all.positions.size() / 3; ++i) {
    const double z = (all.positions[3 * i + 2] - 30) / 3;
    EXPECT_NEAR(all.normals[3 * i + 2], z, 0.05);
    if (std::abs(z) > 0.1) {
      EXPECT_EQ(all.channels[3 * i], z > 0 ? 200 : 0);
    }
    EXPECT_EQ(all.channels[3 * i + 2], 50);
  }
}

TEST_F(Sampling, TheThreadsDoNotMatter) {
  const auto file = write_sphere(path("a.ply"), {});
  sample_file(file, path("b.ply"), {.target = 3000, .threads = 1});
  sample_file(file, path("c.ply"), {.target = 3000, .threads = 2});
  EXPECT_TRUE(bytes_of(path("b.ply")) == bytes_of(path("c.ply")));
}

// They occupy more cubes than the memory has room for, so that cubes are merged.
TEST_F(Sampling, TheThreadsDoNotMatterForPointsThatFillAVolume) {
  const auto writer = create_points(path("a.ply"), {Number::float32, false, {}});
  std::mt19937 random(1);
  std::vector<double> positions(3 * 200000);
  for (double& position : positions) position = std::uniform_real_distribution<double>()(random);
  writer->write({0, positions, {}, {}});
  writer->finish();
  for (const unsigned threads : {1U, 2U, 5U}) {
    const SampleReport report = sample_file(path("a.ply"), path("b.ply"), {.target = 3000, .threads = threads});
    EXPECT_EQ(report.samples, 3000U);
    if (threads == 1)
      std::filesystem::rename(path("b.ply"), path("c.ply"));
    else
      EXPECT_TRUE(bytes_of(path("b.ply")) == bytes_of(path("c.ply")));
  }
}

TEST(BoundedCubes, TheOrderDoesNotMatter) {
  std::vector<Cube> cubes;
  for (std::uint64_t i = 0; i < 600; ++i) cubes.push_back({.key = i * i, .count = i + 1, .first = i, .last = 2 * i});
  std::vector<Cube> before;
  for (unsigned seed = 0; seed < 4; ++seed) {
    std::shuffle(cubes.begin(), cubes.end(), std::mt19937(seed));
    BoundedCubes bounded(64);
    for (const Cube& cube : cubes) bounded.add(cube);
    const std::vector<Cube> sorted = bounded.sorted();
    EXPECT_LE(sorted.size(), 64U);
    EXPECT_GT(sorted.size(), 8U);
    std::uint64_t count = 0;
    for (const Cube& cube : sorted) {
      EXPECT_EQ(cube.key, key_at_level(cube.key, bounded.level()));
      count += cube.count;
    }
    EXPECT_EQ(count, 600U * 601 / 2);
    if (seed == 0) before = sorted;
    EXPECT_TRUE(
        std::equal(sorted.begin(), sorted.end(), before.begin(), before.end(), [](const Cube& a, const Cube& b) {
          return a.key == b.key && a.count == b.count && a.first == b.first && a.last == b.last;
        }));
  }
}

// Each cube has so many points that it would be several cells; 40 MiB are too little for so many cells.
TEST(Plan, TooManyCellsAreAnError) {
  Census census;
  for (std::uint64_t i = 0; i < 65536; ++i)
    census.cubes.push_back({.key = i, .count = 1000000, .first = 1000000 * i, .last = 1000000 * (i + 1) - 1});
  census.points = 65536 * std::uint64_t{1000000};
  EXPECT_NE(
      problem_of([&] { make_plan(census, {.target = 100000000, .memory = std::size_t{40} << 20}); }).find("cells"),
      std::string::npos);
  EXPECT_FALSE(make_plan(census, {.target = 10000, .memory = std::size_t{40} << 20}).cells.empty());
}

TEST_F(Sampling, ShuffledPointsGiveAsGoodSamples) {
  const SampleReport report =
      sample_file(write_sphere(path("a.ply"), {.shuffled = true}), path("b.ply"), {.target = 2000});
  EXPECT_GE(report.samples, 1980U);
  EXPECT_LT(mean_square_distance(read_all(*open_points(path("b.ply")))), 0.01);
}

TEST_F(Sampling, NormalsAreFoundWhereThereAreNone) {
  sample_file(write_sphere(path("a.ply"), {.normals = false}), path("b.ply"), {.target = 2000});
  const AllPoints all = read_all(*open_points(path("b.ply")));
  EXPECT_LT(mean_square_distance(all), 0.01);
  std::size_t outwards = 0;
  for (std::size_t i = 0; i < all.positions.size() / 3; ++i)
    outwards += all.normals[3 * i] * (all.positions[3 * i] - 10) +
                            all.normals[3 * i + 1] * (all.positions[3 * i + 1] - 20) +
                            all.normals[3 * i + 2] * (all.positions[3 * i + 2] - 30) >
                        2.7
                    ? 1
                    : 0;
  EXPECT_GT(outwards, all.positions.size() / 3 * 98 / 100);
}

TEST_F(Sampling, AnErrorIsKept) {
  const auto file = write_sphere(path("a.ply"), {});
  const SampleReport coarse = sample_file(file, path("b.ply"), {.error = 1e-2});
  const SampleReport fine = sample_file(file, path("c.ply"), {.error = 1e-3});
  EXPECT_GT(fine.samples, 4 * coarse.samples);
  for (const SampledCell& cell : fine.cells) EXPECT_LE(cell.error, 1.001e-3 * 6 * std::sqrt(3.0));
}

TEST_F(Sampling, EveryPointIsInACell) {
  const SampleReport report = sample_file(write_sphere(path("a.ply"), {}), path("b.ply"), {.target = 500});
  std::uint64_t points = 0;
  for (const SampledCell& cell : report.cells) {
    points += cell.points;
    EXPECT_LE(cell.first, cell.last);
  }
  EXPECT_EQ(points, 60000U);
  EXPECT_EQ(report.cells.back().first_sample + report.cells.back().samples, report.samples);
}

TEST_F(Sampling, InCoreGivesTheSameCount) {
  const auto file = write_sphere(path("a.ply"), {});
  const SampleReport report = sample(file_source(file), {.target = 1000}, path(""),
                                     [&](const Schema& schema) { return create_points(path("b.ply"), schema); });
  EXPECT_TRUE(report.in_core);
  EXPECT_GE(report.samples, 980U);
  EXPECT_LT(mean_square_distance(read_all(*open_points(path("b.ply")))), 0.01);
}

TEST_F(Sampling, BadOptionsAreExplained) {
  const auto file = write_sphere(path("a.ply"), {.points = 10});
  const auto problem = [&](const SampleOptions& options) {
    return problem_of([&] {
      sample(file_source(file), options, path(""),
             [&](const Schema& schema) { return create_points(path("b.ply"), schema); });
    });
  };
  EXPECT_NE(problem({.error = 2}).find("error is 2"), std::string::npos);
  EXPECT_NE(problem({.target = 5, .memory = 1000}).find("40 MiB"), std::string::npos);
  made("a.ply",
       "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
       "end_header\n0 nan 0\n");
  EXPECT_NE(problem({.target = 5}).find("leave the point out by the option skip_invalid"), std::string::npos);
}

// In core and out of core.
TEST_F(Sampling, ACoordinateBeyondTheRangeOfFloatsNamesThePoint) {
  const auto writer = create_points(path("a.ply"), {Number::float64, false, {}});
  for (int i = 0; i < 100; ++i) writer->write({0, std::vector<double>{double(i), i == 70 ? -2e18 : 0, 0}, {}, {}});
  writer->finish();
  for (const std::string& problem :
       {problem_of([&] { sample_file(path("a.ply"), path("b.ply"), {.target = 9}); }),
        problem_of([&] { stream::sample_file(path("a.ply"), path("b.ply"), {.target = 9}); })})
    EXPECT_NE(problem.find("a.ply: point 70 has the coordinate -2e+18"), std::string::npos) << problem;
}

TEST_F(Sampling, AFileThatChangesBetweenThePassesIsExplained) {
  const auto file = write_sphere(path("a.ply"), {});
  const Source source = file_source(file);
  write_sphere(file, {.points = 50000});
  EXPECT_NE(problem_of([&] {
              sample(source, {.target = 5}, path(""),
                     [&](const Schema& schema) { return create_points(path("b.ply"), schema); });
            }).find("changed while it was read"),
            std::string::npos);
}

TEST_F(Sampling, TheScanIsNotOverwritten) {
  const std::filesystem::path file = write_sphere(path("a.ply"), {});
  const std::string before = bytes_of(file);
  std::filesystem::create_symlink(file, path("link.ply"));
  for (const std::filesystem::path& output : {file, path("link.ply"), path("./a.ply")})
    EXPECT_NE(problem_of([&] { stream::sample_file(file, output, {.target = 100}); }).find("is the same file as"),
              std::string::npos);
  SampleOptions options{.target = 100};
  options.work = file;
  options.allow_in_core = false;
  EXPECT_NE(problem_of([&] { stream::sample_file(file, path("b.ply"), options); }).find("is not a folder"),
            std::string::npos);
  options.work.clear();
  options.resume = true;
  EXPECT_NE(problem_of([&] { stream::sample_file(file, path("b.ply"), options); }), "");
  EXPECT_EQ(before, bytes_of(file));
}

}  // namespace
}  // namespace glark::stream
