// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The index of a sampling, and more samples of a region.
#include <array>
#include <cmath>

#include "tests/stream/temporary_folder.h"

namespace glark::stream {
namespace {

// A sphere of radius 1 about the origin, in rings from below.
class Refining : public TemporaryFolder {
 protected:
  static constexpr std::size_t scan_points = 40000;

  void SetUp() override {
    TemporaryFolder::SetUp();
    const auto writer = create_points(path("large.ply"), {Number::float32, true, {}}, scan_points);
    for (std::size_t i = 0; i < scan_points; ++i) {
      const double z = 2 * (static_cast<double>(i) + 0.5) / scan_points - 1;
      const double angle = 2.399963229728653 * static_cast<double>(i), r = std::sqrt(1 - z * z);
      const std::array<double, 3> p{r * std::cos(angle), r * std::sin(angle), z};
      const std::array<float, 3> n{static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
      writer->write({0, p, n, {}});
    }
    writer->finish();
    SampleOptions options;
    options.target = 500;
    options.memory = std::size_t{40} << 20;
    options.allow_in_core = false;
    const SampleReport report = sample(file_source(path("large.ply")), options, path(""),
                                       [&](const Schema& schema) { return create_points(path("small.ply"), schema); });
    write_cells(path("small.ply.cells"), {std::filesystem::file_size(path("large.ply")), report.points, report.cells});
  }

  // Lifts the sampling by 10 and paints it: the property "paint" is the height before.
  void write_edited() const {
    AllPoints all = read_all(*open_points(path("small.ply")));
    for (std::size_t i = 2; i < all.positions.size(); i += 3) {
      all.channels.push_back(all.positions[i]);
      all.positions[i] += 10;
    }
    const auto writer = create_points(path("edited.ply"), {Number::float32, true, {{"paint", Number::float32}}});
    writer->write(all.points());
    writer->finish();
  }

  RefineFiles files() const {
    return {path("large.ply"),  path("small.ply.cells"), path("small.ply"),
            path("edited.ply"), path("finer.ply"),       path("finer.edited.ply")};
  }
  static Region cap() {  // of the lifted sphere
    Region region;
    region.kind = Region::Kind::sphere;
    region.centre = {0, 0, 11};
    region.radius = 0.6;
    return region;
  }
};

TEST_F(Refining, NewSamplesFollowTheEditOfTheOthers) {
  write_edited();
  const RefineReport report = refine(files(), cap(), {.target = 800});
  EXPECT_LE(report.samples, 800U);
  EXPECT_GE(report.samples, 780U);
  EXPECT_LT(report.points_read, scan_points / 2);
  EXPECT_LT(report.points, report.points_read);
  const AllPoints before = read_all(*open_points(path("finer.ply")));
  const AllPoints after = read_all(*open_points(path("finer.edited.ply")));
  ASSERT_EQ(before.positions.size(), after.positions.size());
  const std::size_t old = read_all(*open_points(path("small.ply"))).positions.size() / 3;
  ASSERT_EQ(before.positions.size() / 3, old + report.samples);
  for (std::size_t i = 0; i < before.positions.size() / 3; ++i) {
    const double* p = &before.positions[3 * i];
    EXPECT_NEAR(after.positions[3 * i + 2], p[2] + 10, 1e-4);
    EXPECT_NEAR(after.channels[i], p[2], 0.1);
    if (i < old) continue;
    EXPECT_NEAR(std::hypot(p[0], p[1], p[2]), 1, 0.01);
    EXPECT_LT(std::hypot(p[0], p[1], p[2] - 1), 0.75);  // the region, and half the distance of two samples
  }
}

TEST_F(Refining, AChannelSelectsSamples) {
  write_edited();
  Region region;
  region.kind = Region::Kind::channel;
  region.channel = "paint";
  EXPECT_EQ(refine(files(), region, {.target = 1000}).points, scan_points);
  region.channel = "paint_it";
  EXPECT_NE(problem_of([&] { refine(files(), region, {.target = 1000}); }).find("no new property"), std::string::npos);
}

TEST_F(Refining, WhatDoesNotFitIsExplained) {
  write_edited();
  Region region = cap();
  region.centre = {50, 0, 0};
  EXPECT_NE(problem_of([&] { refine(files(), region, {.target = 10}); }).find("no sample lies in the region"),
            std::string::npos);
  EXPECT_NE(problem_of([&] { refine(files(), cap(), {.target = 10, .memory = 1000}); }).find("the option memory"),
            std::string::npos);
  EXPECT_NE(problem_of([&] { refine(files(), cap(), {.target = 10, .neighbours = 1}); }).find("3 to 64"),
            std::string::npos);
  std::filesystem::copy(path("small.ply"), path("large.ply"), std::filesystem::copy_options::overwrite_existing);
  EXPECT_NE(problem_of([&] { refine(files(), cap(), {.target = 10}); }).find("its index was made for"),
            std::string::npos);
}

// A run that was killed after it had written the sampling leaves the index of an earlier one.
TEST_F(Refining, AnIndexOfAnotherSamplingIsRefused) {
  write_edited();
  sample_file(path("large.ply"), path("other.ply"), {.target = 50});
  refine(files(), cap(), {.target = 10});
  std::filesystem::copy(path("other.ply.cells"), files().cells, std::filesystem::copy_options::overwrite_existing);
  EXPECT_NE(problem_of([&] { refine(files(), cap(), {.target = 10}); }).find("is the index of a sampling with"),
            std::string::npos);
}

// What fails after the sampling was written keeps the state of the work: the next run continues.
TEST_F(Refining, AnIndexThatCannotBeWrittenLeavesTheWork) {
  std::filesystem::create_directories(path("mine.ply.cells/full"));
  SampleOptions options{.target = 200, .memory = 40 << 20, .work = path("work")};
  options.allow_in_core = false;
  EXPECT_NE(problem_of([&] { sample_file(path("large.ply"), path("mine.ply"), options); }), "");
  EXPECT_TRUE(std::filesystem::exists(path("work/glark-identity")));
  std::filesystem::remove_all(path("mine.ply.cells"));
  options.resume = true;
  sample_file(path("large.ply"), path("mine.ply"), options);
  EXPECT_FALSE(std::filesystem::exists(path("work")));
  EXPECT_EQ(read_cells(path("mine.ply.cells")).points, scan_points);
}

TEST_F(Refining, TheIndexKeepsItsNumbers) {
  CellIndex index{100, 50, {}, 9};
  SampledCell cell;
  cell.corner = {0.1, -2, 1e300};
  cell.side = 0.3;
  cell.points = 7;
  cell.first = 3;
  cell.last = 49;
  cell.error = 1e-9;
  index.cells.push_back(cell);
  write_cells(path("a.cells"), index);
  const CellIndex read = read_cells(path("a.cells"));
  EXPECT_EQ(read.bytes, 100U);
  EXPECT_EQ(read.points, 50U);
  EXPECT_EQ(read.samples, 9U);
  ASSERT_EQ(read.cells.size(), 1U);
  EXPECT_EQ(read.cells[0].corner, cell.corner);
  EXPECT_EQ(read.cells[0].side, cell.side);
  EXPECT_EQ(read.cells[0].points, 7U);
  EXPECT_EQ(read.cells[0].first, 3U);
  EXPECT_EQ(read.cells[0].last, 49U);
  EXPECT_EQ(read.cells[0].error, 1e-9);
}

TEST_F(Refining, DamagedIndicesAreExplained) {
  const std::array<std::array<const char*, 2>, 18> cases{{
      {"", "is empty"},
      {"ply\n", "does not begin with"},
      {"glark cells 1\n", "the file ends here"},
      {"glark cells 1\n10 20 x\n", "is not the number of cells"},
      {"glark cells 1\n10 20 1\n0 0 0 1 5 0 19\n", "is not the error"},
      {"glark cells 1\n10 20 1\n0 0 0 1 5 0 20 0\n", "the scan has 20"},
      {"glark cells 1\n10 20 1\n0 0 nan 1 5 0 19 0\n", "not finite"},
      {"glark cells 1\n10 20 1\n0 inf 0 1 5 0 19 0\n", "line 3: the corner of a cell is inf"},
      {"glark cells 1\n10 20 1\n0 0 0 inf 5 0 19 0\n", "line 3: the side of a cell is inf"},
      {"glark cells 1\n10 20 1\n0 0 0 -1 5 0 19 0\n", "line 3: the side of a cell is -1"},
      {"glark cells 1\n10 20 1\n0 0 0 1 5 0 19 -1\n", "line 3: the error of a cell is -1"},
      {"glark cells 1\n10 20 1\n0 0 0 1 -5 0 19 0\n", "is not the number of points"},
      {"glark cells 1\n10 20 1\n0 0 0 1 0 0 19 0\n", "line 3: a cell has 0 points"},
      {"glark cells 1\n10 20 1\n0 0 0 1 5 19 0 0\n", "line 3: a cell has 5 points from 19 to 0"},
      {"glark cells 1\n10 20 2\n0 0 0 1 9 0 19 0\n1 0 0 1 12 0 19 0\n", "line 4: the cells up to here"},
      {"glark cells 1\n10 20 2\n0 0 0 1 9 0 19 0\n1 0 0 1.5 1 0 19 0\n", "line 4: the side of the cell is 1.5"},
      {"glark cells 1\n10 20 0\n1\n", "lines follow"},
      {"glark cells 1\n10 20 99999999999\n", "too many"},
  }};
  for (const auto& [text, said] : cases) {
    const auto file = made("a.cells", text);
    const std::string problem = problem_of([&] { read_cells(file); });
    EXPECT_NE(problem.find(said), std::string::npos) << problem;
    EXPECT_NE(problem.find("a.cells"), std::string::npos) << problem;
  }
}

// Each byte counts, also one whose number would be possible.
TEST_F(Refining, AnyChangeOfAnIndexIsFound) {
  SampledCell cell;
  cell.side = 0.5;
  cell.points = 60;
  cell.last = 70;
  write_cells(path("a.cells"), {1200, 100, {cell}, 7});
  const std::string text = bytes_of(path("a.cells"));
  EXPECT_EQ(read_cells(path("a.cells")).samples, 7U);
  for (std::size_t i = 0; i + 1 < text.size(); ++i) {
    std::string damaged = text;
    damaged[i] = damaged[i] == '1' ? '2' : '1';
    const auto file = made("b.cells", damaged);
    const std::string problem = problem_of([&] { read_cells(file); });
    EXPECT_NE(problem.find("b.cells"), std::string::npos) << damaged;
  }
  made("b.cells", text.substr(0, text.find("checksum")));
  EXPECT_NE(problem_of([&] { read_cells(path("b.cells")); }).find("the file ends here"), std::string::npos);
}

// An index without a checksum, of an earlier version.
TEST_F(Refining, TheFirstVersionOfAnIndexIsRead) {
  made("a.cells", "glark cells 1\n1200 100 1 7\n0 0 0 0.5 60 0 70 0.001\n");
  EXPECT_EQ(read_cells(path("a.cells")).cells.size(), 1U);
  EXPECT_EQ(read_cells(path("a.cells")).samples, 7U);
}

TEST_F(Refining, AnOutputIsNoneOfTheOtherFiles) {
  write_edited();
  const auto problem_with = [&](const char* output, const char* edited_output) {
    RefineFiles with = files();
    with.output = path(output);
    with.edited_output = path(edited_output);
    return problem_of([&] { refine(with, cap(), {.target = 100}); });
  };
  const std::string scan = bytes_of(path("large.ply"));
  for (const char* input : {"large.ply", "small.ply", "small.ply.cells", "edited.ply"}) {
    EXPECT_NE(problem_with(input, "b.ply").find("is the same file as"), std::string::npos) << input;
    EXPECT_NE(problem_with("b.ply", input).find("is the same file as"), std::string::npos) << input;
  }
  EXPECT_NE(problem_with("b.ply", "b.ply").find("is the same file as"), std::string::npos);
  EXPECT_EQ(scan, bytes_of(path("large.ply")));
}

// A file of the user may have the name by chance.
TEST_F(Refining, AFileThatIsNoIndexIsNotReplaced) {
  write_edited();
  RefineFiles given = files();
  given.edited_output.clear();
  for (const char* text : {"my notes", ""}) {
    made("mine.ply.cells", text);
    given.output = path("mine.ply");
    for (const std::string& problem :
         {problem_of([&] { sample_file(path("large.ply"), path("mine.ply"), {.target = 9}); }),
          problem_of([&] { refine(given, cap(), {.target = 9}); }),
          problem_of([&] { write_cells(path("mine.ply.cells"), {}); })}) {
      EXPECT_NE(problem.find("mine.ply.cells: the index"), std::string::npos) << problem;
    }
    EXPECT_EQ(bytes_of(path("mine.ply.cells")), text);
    EXPECT_FALSE(std::filesystem::exists(path("mine.ply")));
  }
  made("mine.ply.cells", "glark cells 1\nof an older sampling\n");
  sample_file(path("large.ply"), path("mine.ply"), {.target = 9});
  EXPECT_EQ(read_cells(path("mine.ply.cells")).points, scan_points);
}

}  // namespace
}  // namespace glark::stream
