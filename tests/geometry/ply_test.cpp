// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <zstd.h>

#include <cmath>

#include "tests/geometry/temporary_file.h"

namespace glark::geometry {
namespace {

using Ply = TemporaryFolder;

constexpr char triangle[] =
    "ply\r\nformat ascii 1.0\r\nelement vertex 3\r\nproperty float x\r\nproperty float y\r\nproperty float z\r\n"
    "element face 1\r\nproperty list uchar int vertex_index\r\nend_header\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n3 0 1 2\r\n";

TEST_F(Ply, LinesOfDosAreRead) {
  const Geometry geometry = read_file(made("a.ply", triangle), {}).geometry;
  EXPECT_EQ((std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}), geometry.positions);
  EXPECT_EQ((std::vector<std::uint32_t>{0, 1, 2}), geometry.triangles);
}

TEST_F(Ply, ZstdIsRead) {
  const std::string_view text(triangle);
  std::string packed(ZSTD_compressBound(text.size()), ' ');
  packed.resize(ZSTD_compress(packed.data(), packed.size(), text.data(), text.size(), 3));
  EXPECT_EQ(1U, read_file(made("a.ply.zst", packed), {}).geometry.triangle_count());
  EXPECT_EQ(1U, read_file(made("b.ply.zst", packed + packed.substr(0, 0)), {}).geometry.triangle_count());
  EXPECT_NE(std::string::npos, problem_with(made("c.ply.zst", packed.substr(0, packed.size() - 9))).find("cut off"));
}

TEST_F(Ply, BigEndianAndOtherTypesAreRead) {
  const std::string header =
      "ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty short x\nproperty int y\nproperty double z\n"
      "property float red\nproperty ushort green\nproperty uchar blue\nend_header\n";
  const std::string body("\xff\xfe\x00\x00\x00\x03\x3f\xe0\x00\x00\x00\x00\x00\x00\x3f\x80\x00\x00\xff\xff\x07", 21);
  const Geometry geometry = read_file(made("a.ply", header + body), {}).geometry;
  EXPECT_EQ((std::vector<float>{-2, 3, 0.5F}), geometry.positions);
  EXPECT_EQ((std::vector<std::uint8_t>{255, 255, 7, 255}), geometry.colours);
}

TEST_F(Ply, FloatColoursGoToOneOrTo255) {
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "property float red\nproperty float green\nproperty float blue\n";
  const auto colours = [&](const std::string& rest) {
    return read_file(made("a.ply", header + rest), {}).geometry.colours;
  };
  EXPECT_EQ((std::vector<std::uint8_t>{255, 0, 128, 255, 0, 0, 0, 255, 51, 255, 0, 255}),
            colours("end_header\n0 0 0 1 0 0.5\n1 0 0 0 -1 nan\n0 1 0 0.2 1.01 -3\n"));
  EXPECT_EQ((std::vector<std::uint8_t>{1, 0, 1, 255, 0, 0, 0, 255, 200, 255, 13, 255}),
            colours("end_header\n0 0 0 1 0 0.6\n1 0 0 0 0 0\n0 1 0 200 255 13\n"));
  EXPECT_EQ((std::vector<std::uint8_t>{1, 0, 1, 0, 0, 0, 0, 1, 200, 255, 13, 128}),
            colours("property float alpha\nend_header\n0 0 0 1 0 1 0\n1 0 0 0 0 0 1\n0 1 0 200 255 13 128\n"));
}

TEST_F(Ply, PolygonsAndStripsBecomeTriangles) {
  const std::string vertices = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string points = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  const Geometry square =
      read_file(made("a.ply", "ply\nformat ascii 1.0\n" + vertices +
                                  "element face 1\nproperty list uchar int vertex_indices\nend_header\n" + points +
                                  "4 0 1 2 3\n"),
                {})
          .geometry;
  EXPECT_EQ((std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}), square.triangles);
  const Geometry strip =
      read_file(made("b.ply", "ply\nformat ascii 1.0\n" + vertices +
                                  "element tristrips 1\nproperty list int int vertex_indices\nend_header\n" + points +
                                  "8 0 1 3 2 -1 0 1 2\n"),
                {})
          .geometry;
  EXPECT_EQ((std::vector<std::uint32_t>{0, 1, 3, 1, 2, 3, 0, 1, 2}), strip.triangles);
}

TEST_F(Ply, WhatIsNotKeptIsSaid) {
  const Reading reading = read_file(made("a.ply",
                                         "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float "
                                         "y\nproperty float z\nproperty float quality\n"
                                         "element edge 1\nproperty int vertex1\nend_header\n0 0 0 7\n0\nmore\n"),
                                    {});
  ASSERT_EQ(3U, reading.warnings.size());
  EXPECT_NE(std::string::npos, reading.warnings[0].find("quality"));
  EXPECT_NE(std::string::npos, reading.warnings[1].find("edge"));
  EXPECT_NE(std::string::npos, reading.warnings[2].find("follows"));
}

TEST_F(Ply, PropertiesOfFacesThatAreNotKeptAreSaid) {
  const Reading reading = read_file(made("a.ply",
                                         "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float "
                                         "y\nproperty float z\nelement face 1\n"
                                         "property list uchar int vertex_indices\nproperty list uchar float "
                                         "texcoord\nproperty uchar flags\nend_header\n"
                                         "0 0 0\n1 0 0\n0 1 0\n3 0 1 2 6 0 0 1 0 0 1 7\n"),
                                    {});
  EXPECT_EQ(1U, reading.geometry.triangle_count());
  ASSERT_EQ(1U, reading.warnings.size());
  EXPECT_NE(std::string::npos, reading.warnings[0].find("face that are not kept: texcoord, flags"));
}

TEST_F(Ply, PointsThatAreNotFiniteCanBeLeftOut) {
  Geometry geometry = random_geometry(1, {.normals = true, .colours = true, .triangles = true});
  const Geometry whole = geometry;
  geometry.positions[3 * 8 + 1] = NAN;
  write_file(path("a.ply"), geometry);
  const std::string problem = problem_with(path("a.ply"));
  EXPECT_NE(std::string::npos, problem.find("vertex 8"));
  EXPECT_NE(std::string::npos, problem.find("the option skip_invalid"));
  const Geometry found = read_file(path("a.ply"), {.skip_invalid = true}).geometry;
  EXPECT_EQ(48U, found.point_count());
  EXPECT_EQ(66U, found.triangle_count());  // six triangles met at the vertex
  EXPECT_EQ(std::vector<float>(whole.positions.begin() + 27, whole.positions.end()),
            std::vector<float>(found.positions.begin() + 24, found.positions.end()));
  EXPECT_EQ(std::vector<std::uint8_t>(whole.colours.begin() + 36, whole.colours.end()),
            std::vector<std::uint8_t>(found.colours.begin() + 32, found.colours.end()));
}

TEST_F(Ply, NormalsThatAreAllZeroCountAsMissing) {
  Geometry geometry = random_geometry(1, {.normals = true});
  geometry.normals.assign(geometry.normals.size(), 0);
  write_file(path("a.ply"), geometry);
  const Reading reading = read_file(path("a.ply"), {});
  EXPECT_TRUE(reading.geometry.normals.empty());
  EXPECT_EQ(1U, reading.warnings.size());
}

}  // namespace
}  // namespace glark::geometry
