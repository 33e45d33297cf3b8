// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Geometry that is written is read again, in every format, with every set of attributes of that format.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/geometry/temporary_file.h"

namespace glark::geometry {
namespace {

using RoundTrip = TemporaryFolder;

void expect_same(const Geometry& expected, const Geometry& found) {
  EXPECT_EQ(expected.origin, found.origin);
  EXPECT_EQ(expected.positions, found.positions);
  EXPECT_EQ(expected.normals, found.normals);
  EXPECT_EQ(expected.colours, found.colours);
  EXPECT_EQ(expected.texture_coordinates, found.texture_coordinates);
  EXPECT_EQ(expected.triangles, found.triangles);
}

TEST_F(RoundTrip, PlyKeepsEveryBit) {
  for (unsigned bits = 0; bits < 16; ++bits)
    for (const bool text : {false, true}) {
      SCOPED_TRACE(testing::Message() << "attributes " << bits << (text ? ", text" : ", binary"));
      const Geometry geometry =
          random_geometry(bits, {(bits & 1U) != 0, (bits & 2U) != 0, (bits & 4U) != 0, (bits & 8U) != 0});
      write_file(path("a.ply"), geometry, {.text = text});
      const Reading reading = read_file(path("a.ply"), {});
      expect_same(geometry, reading.geometry);
      EXPECT_TRUE(reading.warnings.empty());
    }
}

TEST_F(RoundTrip, PlyKeepsTheDigitsOfGeoreferencedPoints) {
  Geometry geometry = random_geometry(1, {});
  geometry.origin = {635619, 848899, 406};
  for (float& coordinate : geometry.positions) coordinate = std::round(coordinate * 1024) / 1024;
  for (const bool text : {false, true}) {
    write_file(path("a.ply"), geometry, {.text = text});
    const Geometry found = read_file(path("a.ply"), {}).geometry;
    ASSERT_EQ(geometry.positions.size(), found.positions.size());
    for (std::size_t i = 0; i < found.positions.size(); ++i)
      EXPECT_EQ(geometry.origin[i % 3] + static_cast<double>(geometry.positions[i]),
                found.origin[i % 3] + static_cast<double>(found.positions[i]));
  }
}

TEST_F(RoundTrip, XyzAndPtsKeepPointsColoursAndNormals) {
  for (const char* name : {"a.xyz", "a.pts"})
    for (unsigned bits = 0; bits < 4; ++bits) {
      if (std::string(name) == "a.pts" && bits == 1) continue;  // six columns are colours in PTS
      SCOPED_TRACE(testing::Message() << name << ", attributes " << bits);
      const Geometry geometry = random_geometry(bits, {(bits & 1U) != 0, (bits & 2U) != 0, false, false});
      write_file(path(name), geometry);
      expect_same(geometry, read_file(path(name), {}).geometry);
    }
}

// Assimp loses vertices without triangles and chooses the order. So the test compares corners.
std::vector<std::array<float, 3>> corners_of(const Geometry& geometry, const std::vector<float>& attribute) {
  std::vector<std::array<float, 3>> corners;
  for (const std::size_t corner : geometry.triangles)
    corners.push_back({attribute[3 * corner], attribute[3 * corner + 1], attribute[3 * corner + 2]});
  return corners;
}

TEST_F(RoundTrip, ObjAndStlKeepTriangles) {
  const Geometry geometry = random_geometry(3, {true, true, true, true});
  for (const char* name : {"a.obj", "a.stl"}) {
    SCOPED_TRACE(name);
    write_file(path(name), geometry);
    const Geometry found = read_file(path(name), {}).geometry;
    EXPECT_EQ(geometry.point_count(), found.point_count());  // triangles share vertices
    ASSERT_EQ(geometry.triangle_count(), found.triangle_count());
    const auto expected = corners_of(geometry, geometry.positions);
    const auto corners = corners_of(found, found.positions);
    for (std::size_t i = 0; i < corners.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(expected[i][k], corners[i][k], 1e-6);
  }
  const Geometry found = read_file(path("a.obj"), {}).geometry;
  const auto expected = corners_of(geometry, geometry.normals);
  const auto corners = corners_of(found, found.normals);
  ASSERT_EQ(expected.size(), corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(expected[i][k], corners[i][k], 1e-5);
  EXPECT_EQ(geometry.colours.size(), found.colours.size());
  EXPECT_EQ(geometry.texture_coordinates.size(), found.texture_coordinates.size());
}

TEST_F(RoundTrip, ObjOfPointsStaysPoints) {
  const Geometry geometry = random_geometry(3, {});
  write_file(path("a.obj"), geometry);
  EXPECT_EQ(geometry.point_count(), read_file(path("a.obj"), {}).geometry.point_count());
}

TEST_F(RoundTrip, StlOfPointsIsAnErrorAndNoFile) {
  EXPECT_THROW(write_file(path("a.stl"), random_geometry(3, {})), Error);
  EXPECT_EQ(0U, file_count());
}

TEST_F(RoundTrip, GlbIsWellFormed) {
  const Geometry geometry = random_geometry(3, {true, true, true, true});
  write_file(path("a.glb"), geometry);
  std::ifstream file(path("a.glb"), std::ios::binary);
  std::array<std::uint32_t, 5> header{};
  file.read(reinterpret_cast<char*>(header.data()), sizeof(header));
  EXPECT_EQ(0x46546C67U, header[0]);  // "glTF"
  EXPECT_EQ(2U, header[1]);
  EXPECT_EQ(std::filesystem::file_size(path("a.glb")), header[2]);
  EXPECT_EQ(0x4E4F534AU, header[4]);  // "JSON"
  std::string json(header[3], ' ');
  file.read(json.data(), static_cast<std::streamsize>(json.size()));
  for (const char* word : {"POSITION", "NORMAL", "COLOR_0", "TEXCOORD_0", "\"min\"", "\"max\""})
    EXPECT_NE(std::string::npos, json.find(word)) << word;
}

// glTF has linear colours at vertices.
TEST_F(RoundTrip, GlbKeepsColoursAndHasThemLinear) {
  Geometry geometry;
  for (std::size_t i = 0; i < 258; ++i) {  // each value of a byte, in triangles of their own
    geometry.positions.insert(geometry.positions.end(), {0.5F * static_cast<float>(i), static_cast<float>(i % 3 == 1),
                                                         static_cast<float>(i % 3 == 2)});
    const auto value = static_cast<std::uint8_t>(std::min<std::size_t>(i, 255));
    geometry.colours.insert(geometry.colours.end(), {value, value, 188, 255});
    geometry.triangles.push_back(static_cast<std::uint32_t>(i));
  }
  write_file(path("a.glb"), geometry);
  const Geometry found = read_file(path("a.glb"), {}).geometry;
  ASSERT_EQ(geometry.colours.size(), found.colours.size());
  for (std::size_t i = 0; i < geometry.triangles.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_EQ(geometry.colours[4 * geometry.triangles[i] + k], found.colours[4 * found.triangles[i] + k]) << i;
  std::ifstream file(path("a.glb"), std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(file), {});
  const std::array<std::uint16_t, 4> first{0, 0, 32957, 65535};  // 188 of 255 is half of the light
  EXPECT_NE(std::string::npos, bytes.find(std::string(reinterpret_cast<const char*>(first.data()), sizeof(first))));
}

TEST_F(RoundTrip, LinkStaysALink) {
  write_file(path("a.ply"), random_geometry(1, {}));
  std::filesystem::create_symlink("a.ply", path("b.ply"));
  write_file(path("b.ply"), random_geometry(2, {.triangles = true}));
  EXPECT_TRUE(std::filesystem::is_symlink(path("b.ply")));
  EXPECT_EQ(72U, read_file(path("a.ply"), {}).geometry.triangle_count());
  EXPECT_EQ(2U, file_count());
}

}  // namespace
}  // namespace glark::geometry
