// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Transfers whose sampling does not fit into the memory.
#include <random>

#include "tests/stream/edited_sheets.h"

namespace glark::stream {
namespace {

class EditedInCells : public Edited {};

// A sampling in memory, and one in cells on the disk, in the order of the sampling or in another one with indices.
TEST_F(EditedInCells, TheMemoryMakesNoDifference) {
  const AllPoints large = sheet(150);
  AllPoints small = sheet(300), other;
  write("large.ply", large, plain);
  write("small.ply", small, plain);
  small = moved(small, [](const Point& p) { return Point{p[0], p[1] + 0.2 * p[2], p[2] + 0.05 * p[0] * p[0]}; });
  const std::size_t count = small.positions.size() / 3;
  for (std::size_t i = 0; i < count; ++i)
    small.channels.insert(small.channels.end(), {20 * small.positions[3 * i], 7, 9});
  write("edited.ply", small, painted);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = k * 7919 % count;
    for (std::size_t c = 0; c < 3; ++c) {
      other.positions.push_back(small.positions[3 * i + c]);
      other.normals.push_back(small.normals[3 * i + c]);
      other.channels.push_back(small.channels[3 * i + c]);
    }
    other.channels.push_back(static_cast<double>(i));
  }
  Schema indexed = painted;
  indexed.channels.push_back({"index", Number::uint32});
  write("indexed.ply", other, indexed);
  const auto done = [&](const char* to, const char* out, std::size_t memory) {
    TransferOptions options;
    options.memory = memory;
    return transfer(path("large.ply"), path("small.ply"), path(to), path(out), options);
  };
  EXPECT_EQ(done("edited.ply", "out.ply", std::size_t{1} << 30).cells_on_disk, 0U);
  const TransferReport report = done("edited.ply", "cells.ply", std::size_t{48} << 20);
  EXPECT_GT(report.cells_on_disk, 40U);
  EXPECT_EQ(report.channels.size(), 3U);
  EXPECT_TRUE(bytes_of(path("out.ply")) == bytes_of(path("cells.ply")));
  EXPECT_GT(done("indexed.ply", "indexed.out.ply", std::size_t{48} << 20).cells_on_disk, 40U);
  EXPECT_TRUE(bytes_of(path("out.ply")) == bytes_of(path("indexed.out.ply")));
}

TEST_F(EditedInCells, SamplingsInCellsAreChecked) {
  AllPoints small = sheet(300);
  write("large.ply", sheet(50), plain);
  write("small.ply", small, plain);
  TransferOptions options;
  options.memory = std::size_t{48} << 20;
  const auto problem = [&](const char* from, const char* to) {
    return problem_of([&] { transfer(path("large.ply"), path(from), path(to), path("out.ply"), options); });
  };
  AllPoints mixed = small;
  std::mt19937 random(7);  // NOLINT(cert-msc51-cpp): each run is the same
  for (std::size_t i = 0; i < small.positions.size(); i += 3) {
    const std::size_t from = 3 * (random() % (small.positions.size() / 3));
    for (std::size_t k = 0; k < 3; ++k) mixed.positions[i + k] = small.positions[from + k];
  }
  write("mixed.ply", mixed, plain);
  EXPECT_NE(problem("small.ply", "mixed.ply").find("another order"), std::string::npos);
  AllPoints few = small;
  few.positions.resize(few.positions.size() - 3);
  few.normals.resize(few.positions.size());
  write("few.ply", few, plain);
  EXPECT_NE(problem("small.ply", "few.ply").find("without adding or removing"), std::string::npos);
  small.channels.assign(small.positions.size() / 3, 3);
  write("indexed.ply", small, {Number::float32, true, {{"index", Number::uint32}}});
  EXPECT_NE(problem("small.ply", "indexed.ply").find("vertex 1 has the index 3"), std::string::npos);
  small.normals.clear();
  write("bare.raw", small, {Number::float32, false, {}});
  EXPECT_NE(problem("bare.raw", "bare.raw").find("raise the memory"), std::string::npos);
  options.memory = std::size_t{10} << 20;
  EXPECT_NE(problem("small.ply", "small.ply").find("is the least"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(path("out.ply")));
}

}  // namespace
}  // namespace glark::stream
