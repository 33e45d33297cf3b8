// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/c/stream.h>
#include <glark/stream.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>

#include "tests/c_api/shapes.h"

namespace glark::test {
namespace {

// A scan of a sphere in a folder of its own.
class StreamInC : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("glark-stream-c" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
    const std::vector<float> points = sphere(3000);
    const std::vector<double> positions(points.begin(), points.end());
    const auto writer = stream::create_points(file("large.ply"), {stream::Number::float32, true, {}});
    writer->write({0, positions, points, {}});
    writer->finish();
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string file(const char* name) const { return (folder_ / name).string(); }
  std::string bytes(const char* name) const {
    glark_stream_reader* reader = nullptr;
    EXPECT_EQ(GLARK_SUCCESS, glark_stream_open_points(file(name).c_str(), nullptr, &reader, nullptr));
    std::string all;
    glark_stream_points points{};
    do {
      EXPECT_EQ(GLARK_SUCCESS, glark_stream_reader_read(reader, 100, &points, nullptr));
      all.append(reinterpret_cast<const char*>(points.positions.data), points.positions.count * sizeof(double));
    } while (points.positions.count > 0);
    glark_stream_reader_free(reader);
    return all;
  }

 private:
  std::filesystem::path folder_;
};

TEST_F(StreamInC, SamplesAndTransfersAreThoseOfCpp) {
  glark_stream_sample_options options = glark_stream_default_sample_options();
  options.target = 300;
  glark_stream_sample_report report;
  glark_error error;
  ASSERT_EQ(GLARK_SUCCESS,
            glark_stream_sample_file(file("large.ply").c_str(), file("small.ply").c_str(), &options, &report, &error))
      << error.message;
  stream::SampleOptions same;
  same.target = 300;
  EXPECT_EQ(report.samples, stream::sample_file(file("large.ply"), file("same.ply"), same).samples);
  EXPECT_EQ(report.points, 3000U);
  EXPECT_EQ(bytes("small.ply"), bytes("same.ply"));
  EXPECT_TRUE(std::filesystem::exists(file("small.ply.cells")));
  std::uint64_t points = 0;
  ASSERT_EQ(GLARK_SUCCESS,
            glark_stream_transfer(file("large.ply").c_str(), file("small.ply").c_str(), file("same.ply").c_str(),
                                  file("out.ply").c_str(), nullptr, &points, &error))
      << error.message;
  EXPECT_EQ(points, 3000U);
  EXPECT_EQ(bytes("large.ply"), bytes("out.ply"));
}

TEST_F(StreamInC, AReaderTellsWhatAFileHas) {
  glark_stream_reader* reader = nullptr;
  ASSERT_EQ(GLARK_SUCCESS, glark_stream_open_points(file("large.ply").c_str(), ".ply", &reader, nullptr));
  std::uint64_t count = 0;
  EXPECT_TRUE(glark_stream_reader_count(reader, &count));
  EXPECT_EQ(count, 3000U);
  EXPECT_TRUE(glark_stream_reader_has_normals(reader));
  EXPECT_EQ(glark_stream_reader_channel_count(reader), 0U);
  EXPECT_EQ(glark_stream_reader_channel_name(reader, 0), nullptr);
  ASSERT_EQ(GLARK_SUCCESS, glark_stream_reader_seek(reader, 2999, nullptr));
  glark_stream_points points;
  ASSERT_EQ(GLARK_SUCCESS, glark_stream_reader_read(reader, 5, &points, nullptr));
  EXPECT_EQ(points.first, 2999U);
  EXPECT_EQ(points.positions.count, 3U);
  EXPECT_EQ(points.normals.count, 3U);
  glark_stream_reader_free(reader);
}

TEST_F(StreamInC, FailuresAreExplained) {
  glark_error error;
  glark_stream_reader* reader = nullptr;
  EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_stream_open_points(file("none.ply").c_str(), nullptr, &reader, &error));
  EXPECT_EQ(error.element, GLARK_STREAM_FILE);
  EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_stream_open_points(nullptr, nullptr, &reader, &error));
  EXPECT_NE(std::strstr(error.message, "file is NULL"), nullptr);
  EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_stream_reader_read(nullptr, 1, nullptr, &error));
  glark_stream_transfer_options options = glark_stream_default_transfer_options();
  options.neighbours = 1;
  EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_stream_transfer("a.ply", "b.ply", "c.ply", "d.ply", &options, nullptr, &error));
  EXPECT_EQ(error.element, GLARK_STREAM_OPTION);
  glark_stream_reader_free(nullptr);
  EXPECT_FALSE(glark_stream_reader_count(nullptr, nullptr));
}

TEST_F(StreamInC, AReaderKeepsToItsArguments) {
  glark_stream_reader* reader = nullptr;
  ASSERT_EQ(GLARK_SUCCESS, glark_stream_open_points(file("large.ply").c_str(), "ply", &reader, nullptr));
  glark_stream_points points{};
  glark_error error;
  EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_stream_reader_read(reader, 0, &points, &error));
  EXPECT_NE(std::strstr(error.message, "most is 0"), nullptr) << error.message;
  EXPECT_EQ(GLARK_SUCCESS, glark_stream_reader_read(reader, 1, &points, &error));
  EXPECT_EQ(points.positions.count, 3U);
  glark_stream_reader_free(reader);
}

TEST_F(StreamInC, BadNamesAreBadArguments) {
  glark_error error;
  const std::string long_name = file(std::string(300, 'a').c_str()) + ".ply";
  for (const std::string& name : {std::string(), long_name}) {
    glark_stream_reader* reader = nullptr;
    EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_stream_open_points(name.c_str(), nullptr, &reader, &error));
    EXPECT_EQ(GLARK_BAD_ARGUMENT,
              glark_stream_sample_file(file("large.ply").c_str(), name.c_str(), nullptr, nullptr, &error));
    EXPECT_NE(std::strstr(error.message, name.empty() ? "is empty" : "File name too long"), nullptr) << error.message;
  }
}

// A message has 511 bytes at most. A character that does not fit whole is left out.
TEST_F(StreamInC, AMessageEndsWithAWholeCharacter) {
  for (std::size_t shift = 0; shift < 4; ++shift) {
    std::string name = "/" + std::string(shift, 'a');
    for (int i = 0; i < 200; ++i) name += "\xE2\x82\xAC";  // the euro sign
    glark_stream_reader* reader = nullptr;
    glark_error error;
    EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_stream_open_points(name.c_str(), nullptr, &reader, &error));
    const std::string message = error.message;
    EXPECT_GE(message.size(), std::size_t{GLARK_MESSAGE_SIZE} - 4);
    EXPECT_TRUE(message.ends_with("\xE2\x82\xAC")) << message;
  }
}

}  // namespace
}  // namespace glark::test
