// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Files of points that are written and read again, in blocks, and bytes laid out by hand.
#include <cmath>
#include <cstring>
#include <limits>

#include "tests/stream/temporary_folder.h"

namespace glark::stream {
namespace {

using Formats = TemporaryFolder;

const Schema coloured{
    Number::float32, true, {{"red", Number::uint8}, {"green", Number::uint8}, {"blue", Number::uint8}}};

// Points whose numbers are exact in every format.
AllPoints some_points(std::size_t count, const Schema& schema) {
  AllPoints all;
  for (std::size_t i = 0; i < count; ++i) {
    const auto number = static_cast<double>(i);
    all.positions.insert(all.positions.end(), {number / 4, number - 7, 100 - number / 8});
    if (schema.normals) all.normals.insert(all.normals.end(), {0, i % 2 == 0 ? 1.0F : -1.0F, 0});
    for (std::size_t k = 0; k < schema.channels.size(); ++k)
      all.channels.push_back(static_cast<double>((50 * k + i) % 256));
  }
  return all;
}

void write_all(const std::filesystem::path& file, const Schema& schema, const AllPoints& all,
               const WriteOptions& options = {}) {
  const auto writer = create_points(file, schema, all.positions.size() / 3, options);
  writer->write(all.points());
  writer->finish();
}

TEST_F(Formats, PlyKeepsEveryNumber) {
  const AllPoints all = some_points(100, coloured);
  for (const bool text : {false, true}) {
    write_all(path("a.ply"), coloured, all, {.text = text});
    const auto reader = open_points(path("a.ply"));
    EXPECT_EQ(reader->schema(), coloured);
    EXPECT_EQ(reader->count(), 100U);
    EXPECT_EQ(reader->can_seek(), !text);
    const AllPoints read = read_all(*reader, 7);
    EXPECT_EQ(read.blocks, 15U);
    EXPECT_EQ(read.positions, all.positions);
    EXPECT_EQ(read.normals, all.normals);
    EXPECT_EQ(read.channels, all.channels);
  }
}

TEST_F(Formats, SeekingGivesTheSamePoints) {
  const AllPoints all = some_points(60, coloured);
  write_all(path("a.ply"), coloured, all);
  write_all(path("a.stl"), {}, all);
  for (const char* name : {"a.ply", "a.stl"}) {
    const auto reader = open_points(path(name));
    for (const std::size_t point : {59, 0, 31, 4}) {
      reader->seek(point);
      const Points points = reader->read(8);
      EXPECT_EQ(points.first, point);
      for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(points.positions[k], all.positions[3 * point + k]) << name;
    }
    EXPECT_THROW(reader->seek(61), Error);
  }
}

TEST_F(Formats, TheCountMayBeUnknown) {
  const AllPoints all = some_points(30, coloured);
  for (const char* name : {"a.ply", "a.las", "a.pts", "a.xyz"}) {
    const auto writer = create_points(path(name), coloured);
    writer->write(all.points());
    writer->write(all.points());
    writer->finish();
    EXPECT_EQ(read_all(*open_points(path(name))).positions.size(), 180U) << name;
  }
}

TEST_F(Formats, TextKeepsColoursAndNormals) {
  const AllPoints all = some_points(40, coloured);
  for (const char* name : {"a.xyz", "a.pts"}) {
    write_all(path(name), coloured, all);
    const auto reader = open_points(path(name));
    ASSERT_TRUE(reader->schema().normals) << name;
    const AllPoints read = read_all(*reader, 9);
    EXPECT_EQ(read.positions, all.positions) << name;
    EXPECT_EQ(read.normals, all.normals) << name;
  }
  const auto reader = open_points(path("a.pts"));
  ASSERT_EQ(reader->schema().channels.size(), 4U);  // the intensity comes first
  const Points points = reader->read();
  EXPECT_EQ(std::vector<double>(points.channels.begin(), points.channels.begin() + 4),
            (std::vector<double>{0, 0, 50, 100}));
}

TEST_F(Formats, LasKeepsSixteenBitsAndTheDigitsOfCoordinates) {
  Schema schema{Number::float64, false, {}};
  for (const char* name : {"intensity", "classification", "gps_time", "red", "green", "blue"})
    schema.channels.push_back({name, std::string(name) == "gps_time" ? Number::float64 : Number::uint16});
  AllPoints all;
  for (int i = 0; i < 20; ++i) {
    all.positions.insert(all.positions.end(), {5e6 + i + 0.001 * i, 4e5 - i, 12.25 + i});
    all.channels.insert(all.channels.end(), {60000.0 + i, 6, 1e9 + 0.125 * i, 65535, 1, 257.0 * i});
  }
  write_all(path("a.las"), schema, all, {.step = 1e-3});
  const auto reader = open_points(path("a.las"));
  const AllPoints read = read_all(*reader);
  for (std::size_t i = 0; i < all.positions.size(); ++i) EXPECT_NEAR(read.positions[i], all.positions[i], 1e-6);
  const std::size_t width = reader->schema().channels.size();
  for (std::size_t k = 0; k < schema.channels.size(); ++k) {
    const std::size_t at = channel_index(reader->schema(), schema.channels[k].name);
    ASSERT_NE(at, none) << schema.channels[k].name;
    for (std::size_t i = 0; i < 20; ++i) EXPECT_EQ(read.channels[width * i + at], all.channels[6 * i + k]);
  }
}

TEST_F(Formats, BytesBecomeColoursOfLas) {
  write_all(path("a.las"), coloured, some_points(9, coloured));
  const AllPoints read = read_all(*open_points(path("a.las")));
  const std::size_t red = channel_index(open_points(path("a.las"))->schema(), "red");
  EXPECT_EQ(read.channels[red + 2], 257 * 100);  // the blue of the first point
}

// A LAS file of one point, laid out by the tables of the specification.
std::string las_by_hand(unsigned minor, unsigned format, std::uint16_t record_size) {
  const std::uint16_t header_size = minor == 4 ? 375 : minor == 3 ? 235 : 227;
  std::string bytes(header_size + 2U + record_size, '\0');
  const auto put = [&](std::size_t at, auto value) { std::memcpy(&bytes[at], &value, sizeof(value)); };
  std::memcpy(bytes.data(), "LASF", 4);
  put(24, std::uint8_t{1});
  put(25, static_cast<std::uint8_t>(minor));
  put(94, header_size);
  put(96, static_cast<std::uint32_t>(header_size + 2));  // the points begin two bytes later, as in version 1.0
  put(104, static_cast<std::uint8_t>(format));
  put(105, record_size);
  put(107, format < 6 ? 1U : 0U);
  if (minor == 4) put(247, std::uint64_t{1});
  for (std::size_t axis = 0; axis < 3; ++axis) {
    put(131 + 8 * axis, 0.01);
    put(155 + 8 * axis, 1000.0);
  }
  const std::size_t point = header_size + 2U;
  put(point, std::int32_t{-250});
  put(point + 4, std::int32_t{7});
  put(point + 8, std::int32_t{0});
  put(point + 12, std::uint16_t{513});
  put(point + (format < 6 ? 15 : 16), std::uint8_t{0xE5});
  return bytes;
}

// LAS 1.4 has two counts of points. The one with 32 bits is for programs that read earlier versions.
TEST_F(Formats, TheCountOf64BitsOfLasIsTheTrueOne) {
  std::string bytes = las_by_hand(4, 1, 28);
  bytes += bytes.substr(bytes.size() - 28);
  const std::uint64_t two = 2;
  std::memcpy(&bytes[247], &two, sizeof(two));
  EXPECT_EQ(open_points(made("a.las", bytes))->count(), 2U);
  std::memset(&bytes[247], 0, sizeof(two));
  EXPECT_EQ(open_points(made("a.las", bytes))->count(), 1U);
}

TEST_F(Formats, LasOfEveryVersionAndFormat) {
  constexpr std::uint16_t sizes[] = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
  for (unsigned format = 0; format <= 10; ++format) {
    const unsigned first = format < 2 ? 0 : format < 4 ? 2 : format < 6 ? 3 : 4;
    for (unsigned minor = first; minor <= 4; ++minor) {
      const auto reader =
          open_points(made("a.las", las_by_hand(minor, format, static_cast<std::uint16_t>(sizes[format] + 3))));
      const Points points = reader->read();
      ASSERT_EQ(points.size(), 1U) << minor << " " << format;
      EXPECT_DOUBLE_EQ(points.positions[0], 997.5);
      EXPECT_DOUBLE_EQ(points.positions[1], 1000.07);
      EXPECT_EQ(points.channels[channel_index(reader->schema(), "intensity")], 513);
      EXPECT_EQ(points.channels[channel_index(reader->schema(), "classification")], format < 6 ? 5 : 0xE5);
      EXPECT_EQ(channel_index(reader->schema(), "near_infrared") != none, format == 8 || format == 10);
    }
  }
}

TEST_F(Formats, BigEndianPly) {
  std::string bytes =
      "ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty float x\nproperty double y\nproperty short z\n"
      "end_header\n";
  bytes += std::string("\x3F\x80\0\0", 4) + std::string("\x40\0\0\0\0\0\0\0", 8) + std::string("\xFF\xFE", 2);
  const AllPoints read = read_all(*open_points(made("a.ply", bytes)));
  EXPECT_EQ(read.positions, (std::vector<double>{1, 2, -2}));
}

TEST_F(Formats, NothingIsLeftWithoutFinish) {
  { create_points(path("a.ply"), coloured)->write(some_points(9, coloured).points()); }
  EXPECT_EQ(file_count(), 0U);
}

TEST_F(Formats, ChannelsThatDoNotFitAreLeftOut) {
  const Schema schema{Number::float32, false, {{"roughness", Number::float32}}};
  EXPECT_TRUE(create_points(path("a.xyz"), schema)->schema().channels.empty());
  EXPECT_TRUE(create_points(path("a.las"), schema)->schema().channels.empty());
  EXPECT_EQ(create_points(path("a.ply"), schema)->schema(), schema);
}

}  // namespace
}  // namespace glark::stream
