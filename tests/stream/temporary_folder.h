// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A temporary folder for the files of each test, and what tests do with files of points.
#pragma once

#include <glark/stream.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace glark::stream {

class TemporaryFolder : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() /
              ("glark-stream-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) +
               std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path path(const std::string& name) const { return folder_ / name; }

  std::filesystem::path made(const std::string& name, std::string_view contents) const {
    std::ofstream(path(name), std::ios::binary) << contents;
    return path(name);
  }
  static std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  std::size_t file_count() const {
    return static_cast<std::size_t>(
        std::distance(std::filesystem::directory_iterator(folder_), std::filesystem::directory_iterator()));
  }

 private:
  std::filesystem::path folder_;
};

// All points of a stream.
struct AllPoints {
  std::vector<double> positions, channels;
  std::vector<float> normals;
  std::size_t blocks = 0;

  Points points() const { return {0, positions, normals, channels}; }
};

inline AllPoints read_all(PointReader& reader, std::size_t most = 4096) {
  AllPoints all;
  for (Points points = reader.read(most); points.size() > 0; points = reader.read(most)) {
    EXPECT_EQ(points.first, all.positions.size() / 3);
    all.positions.insert(all.positions.end(), points.positions.begin(), points.positions.end());
    all.normals.insert(all.normals.end(), points.normals.begin(), points.normals.end());
    all.channels.insert(all.channels.end(), points.channels.begin(), points.channels.end());
    ++all.blocks;
  }
  return all;
}

// Returns the message of the Error that `step` throws, or an empty text.
template <class Step>
std::string problem_of(const Step& step) {
  try {
    step();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

}  // namespace glark::stream
