// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A temporary folder for the files of each test, and what tests do with files of points.
#pragma once

#include <glark/stream.h>

#include <vector>

#include "tests/common/temporary_folder.h"

namespace glark::stream {

class TemporaryFolder : public test::TemporaryFolder {
 protected:
  static std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
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
