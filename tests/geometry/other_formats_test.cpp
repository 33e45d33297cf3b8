// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Formats that are read and not written: OFF, PCD, glTF with nodes. And --format, which the name of the file yields to.
#include <array>
#include <cstring>

#include "tests/geometry/temporary_file.h"

namespace glark::geometry {
namespace {

using OtherFormats = TemporaryFolder;

constexpr char pcd_head[] =
    "# .PCD v.7\nVERSION .7\nFIELDS x y z normal_x normal_y normal_z rgba ring\nSIZE 4 4 4 4 4 4 4 2\n"
    "TYPE F F F F F F U U\nCOUNT 1 1 1 1 1 1 1 2\nWIDTH 2\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\n";

std::string binary_points() {
  std::string bytes;
  for (const float x : {1.0F, 4.0F}) {
    const std::array<float, 6> place{x, 2, 3, 0, 0.6F, 0.8F};
    const std::uint32_t colour = 0x80ff4020U;
    const std::array<std::uint16_t, 2> ring{7, 8};
    bytes.append(reinterpret_cast<const char*>(place.data()), sizeof(place));
    bytes.append(reinterpret_cast<const char*>(&colour), sizeof(colour));
    bytes.append(reinterpret_cast<const char*>(ring.data()), sizeof(ring));
  }
  return bytes;
}

TEST_F(OtherFormats, PcdAsTextAndBinaryIsTheSame) {
  const std::string text =
      std::string(pcd_head) + "DATA ascii\n1 2 3 0 0.6 0.8 2164211744 7 8\n4 2 3 0 0.6 0.8 2164211744 7 8\n";
  for (const std::string& contents : {text, pcd_head + ("DATA binary\n" + binary_points())}) {
    const Reading reading = read_file(made("a.pcd", contents), {});
    EXPECT_EQ((std::vector<float>{1, 2, 3, 4, 2, 3}), reading.geometry.positions);
    EXPECT_EQ((std::vector<float>{0, 0.6F, 0.8F, 0, 0.6F, 0.8F}), reading.geometry.normals);
    EXPECT_EQ((std::vector<std::uint8_t>{255, 64, 32, 128, 255, 64, 32, 128}), reading.geometry.colours);
    ASSERT_EQ(reading.warnings.size(), 1U);
    EXPECT_NE(std::string::npos, reading.warnings[0].find("not kept: ring"));
  }
}

TEST_F(OtherFormats, ColoursOfPcdMayBeTheBitsOfAFloat) {
  const std::string head =
      "FIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\nWIDTH 1\nHEIGHT 1\nDATA ascii\n";
  const Geometry geometry = read_file(made("a.pcd", head + "1 2 3 4.2108e+06\n"), {}).geometry;  // 0x4a8080e0
  EXPECT_EQ((std::vector<std::uint8_t>{128, 128, 224, 255}), geometry.colours);
}

TEST_F(OtherFormats, WhatIsNoColourInPcdIsBlack) {
  const std::string head = "FIELDS x y z rgb\nSIZE 4 4 4 8\nTYPE F F F F\nWIDTH 3\nHEIGHT 1\nDATA ascii\n";
  const Geometry geometry = read_file(made("a.pcd", head + "1 2 3 nan\n1 2 3 1e30\n1 2 3 65536\n"), {}).geometry;
  EXPECT_EQ((std::vector<std::uint8_t>{0, 0, 0, 255, 0, 0, 0, 255, 1, 0, 0, 255}), geometry.colours);
}

TEST_F(OtherFormats, BadPcdIsExplained) {
  const std::string fields = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 2\nHEIGHT 1\n";
  struct Case {
    std::string contents;
    const char* said;
  };
  const Case cases[] = {
      {fields, "without a line DATA"},
      {fields + "DATA ascii\n1.25 2.25 3.25\n4 5", "ends here"},
      {fields + "DATA ascii\n1 2 3\n4 five 6\n", "point 1 of 2: \"five\""},
      {fields + "DATA binary\n0123456789", "announces 2 points"},
      {fields + "DATA binary_compressed\n0123456789", "DATA is binary_compressed"},
      {fields + "POINTS 99999999999999\nDATA ascii\n1 2 3\n", "announces 99999999999999 points"},
      {fields + "POINTS many\nDATA ascii\n1 2 3\n", "\"many\" is not a number"},
      {"FIELDS x y\nSIZE 4 4\nTYPE F F\nWIDTH 1\nDATA ascii\n1 2\n", "there is no field z"},
      {"FIELDS x y z\nSIZE 4 4\nTYPE F F F\nWIDTH 1\nDATA ascii\n1 2 3\n", "different lengths"},
      {"FIELDS x y z\nSIZE 8 8 8\nTYPE I I I\nWIDTH 1\nDATA ascii\n1 2 3\n", "type I of 8 bytes"},
      {"FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 5000000\nWIDTH 1\nDATA ascii\n1 2 3\n",
       "more than 1024 values"},
      {"FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 9999999999\nHEIGHT 9999999999\nDATA ascii\n1 2 3\n", "too large"},
  };
  for (const Case& bad : cases) {
    const std::string problem = problem_with(made("a.pcd", bad.contents));
    EXPECT_NE(std::string::npos, problem.find(bad.said)) << bad.contents << ": " << problem;
    EXPECT_NE(std::string::npos, problem.find("a.pcd")) << problem;
  }
}

TEST_F(OtherFormats, OffHasPolygons) {
  const Geometry geometry = read_file(made("a.off",
                                           "OFF\n# a square and a triangle\n5 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 2\n"
                                           "4 0 1 2 3\n3 0 1 4\n"),
                                      {})
                                .geometry;
  EXPECT_EQ(geometry.point_count(), 5U);
  EXPECT_EQ(geometry.triangle_count(), 3U);
}

// A triangle that a node moves by (10, 0, 0).
constexpr char gltf[] = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
"nodes":[{"mesh":0,"translation":[10,0,0]}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],
"bufferViews":[{"buffer":0,"byteLength":36}],
"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";

TEST_F(OtherFormats, NodesOfGltfAreInTheirPlaces) {
  const Geometry geometry = read_file(made("a.gltf", gltf), {}).geometry;
  ASSERT_EQ(geometry.triangle_count(), 1U);
  EXPECT_EQ((std::vector<float>{10, 0, 0, 11, 0, 0, 10, 1, 0}), geometry.positions);
}

TEST_F(OtherFormats, GltfMayNameAnotherFile) {
  const std::string inside = "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
  std::string text = gltf;
  text.replace(text.find(inside), inside.size(), "points.bin");
  const std::array<float, 9> points{0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::filesystem::path file = made("a.gltf", text);
  EXPECT_NE(std::string::npos, problem_with(file).find("points.bin"));
  made("points.bin", {reinterpret_cast<const char*>(points.data()), sizeof(points)});
  EXPECT_EQ((std::vector<float>{10, 0, 0, 11, 0, 0, 10, 1, 0}), read_file(file, {}).geometry.positions);
}

// Four points, and the indices of a GLB file.
std::string glb(const std::vector<std::uint32_t>& indices, const char* more_attributes = "") {
  const std::array<float, 12> points{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  std::string bytes(reinterpret_cast<const char*>(points.data()), sizeof(points));
  bytes.append(reinterpret_cast<const char*>(indices.data()), 4 * indices.size());
  const std::string size = std::to_string(bytes.size()), length = std::to_string(4 * indices.size());
  std::string text =
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[)"
      R"({"attributes":{"POSITION":0)" +
      std::string(more_attributes) + R"(},"indices":1}]}],"buffers":[{"byteLength":)" + size +
      R"(}],"bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":)" + length +
      R"(}],"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},)"
      R"({"bufferView":1,"componentType":5125,"count":)" +
      std::to_string(indices.size()) +
      R"(,"type":"SCALAR"},{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}]})";
  text.resize((text.size() + 3) / 4 * 4, ' ');
  std::string file = "glTF";
  const auto add = [&](std::size_t number) {
    const auto value = static_cast<std::uint32_t>(number);
    file.append(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  add(2);
  add(12 + 8 + text.size() + 8 + bytes.size());
  add(text.size());
  file += "JSON" + text;
  add(bytes.size());
  return file + std::string("BIN\0", 4) + bytes;
}

TEST_F(OtherFormats, DamagedGltfIsExplained) {
  EXPECT_EQ(2U, read_file(made("a.glb", glb({0, 1, 2, 0, 2, 3})), {}).geometry.triangle_count());
  struct Case {
    std::string contents;
    const char* said;
  };
  const Case cases[] = {
      {glb({0, 1, 2, 0, 2, 9}), "mesh 0, primitive 0: index 5 is 9, but there are only 4 points"},
      {glb({0, 1, 2, 0, 2, 4}), "index 5 is 4"},
      {glb({0, 1, 2, 0, 2}), "5 indices are no whole triangles"},
      {glb({0, 1, 2, 0, 2, 3}, ",\"NORMAL\":2"), "3 NORMAL for 4 points"},
  };
  for (const Case& bad : cases) {
    const std::string problem = problem_with(made("a.glb", bad.contents));
    EXPECT_NE(std::string::npos, problem.find(bad.said)) << problem;
    EXPECT_NE(std::string::npos, problem.find("a.glb")) << problem;
  }
}

TEST_F(OtherFormats, PointsOfGltfWithoutIndicesAreWholeTriangles) {
  std::string text = gltf;
  const auto replace = [&](const std::string& old, const std::string& now) {
    text.replace(text.find(old), old.size(), now);
  };
  replace("\"count\":3", "\"count\":4");
  for (int i = 0; i < 2; ++i) replace("\"byteLength\":36", "\"byteLength\":48");
  replace("base64,", "base64,AAAAAAAAAAAAAAAA");
  EXPECT_NE(std::string::npos, problem_with(made("a.gltf", text)).find("4 points are no whole triangles"));
}

TEST_F(OtherFormats, OffWithTooManyPointsOrFacesIsExplained) {
  for (const char* head : {"OFF\n353535235358 1 0\n", "OFF 3 77777777777 0\n", "COFF\n# a\n\n3\n99999999 0\n"}) {
    const std::string problem = problem_with(made("a.off", head + std::string("0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")));
    EXPECT_NE(std::string::npos, problem.find("for which the file is too short")) << head << problem;
  }
}

TEST_F(OtherFormats, PcdMayEndInZeros) {
  const std::string bytes = pcd_head + ("DATA binary\n" + binary_points());
  EXPECT_EQ(1U, read_file(made("a.pcd", bytes + std::string(4000, '\0')), {}).warnings.size());
  EXPECT_EQ(2U, read_file(made("b.pcd", bytes + std::string(4000, '\0') + "x"), {}).warnings.size());
}

TEST_F(OtherFormats, WhatIsNoMeshIsExplained) {
  for (const char* name : {"a.off", "a.gltf", "a.glb"}) {
    const std::string problem = problem_with(made(name, "something else\n1 2 3\n"));
    EXPECT_NE(std::string::npos, problem.find(name)) << problem;
    EXPECT_NE(std::string::npos, problem.find("check the format")) << problem;
  }
}

TEST_F(OtherFormats, TheWantedFormatCountsMoreThanTheName) {
  const std::filesystem::path file = made("points.ply", "1 2 3\n4 5 6\n");
  EXPECT_FALSE(problem_with(file).empty());
  EXPECT_EQ(2U, read_file(file, {.format = ".xyz"}).geometry.point_count());
}

TEST_F(OtherFormats, ObjFarFromZeroIsAWarning) {
  const auto warnings = [&](double x) {
    std::string text;
    for (const double step : {0.0, 1.0, 2.0})
      text += "v " + std::to_string(x + step) + " 0 " + std::to_string(step * step) + "\n";
    return read_file(made("a.obj", text + "f 1 2 3\n"), {}).warnings;
  };
  EXPECT_TRUE(warnings(0).empty());
  EXPECT_TRUE(warnings(500).empty());
  const std::vector<std::string> far = warnings(6e6);
  ASSERT_EQ(far.size(), 1U);
  EXPECT_NE(far[0].find("convert it to PLY with doubles"), std::string::npos) << far[0];
}

TEST_F(OtherFormats, UnusedVerticesOfObjAreKeptIfAllAreWanted) {
  const auto file =
      made("a.obj", "v 0 0 0\nv 9 8 7\nv 1 0 0\nv 0 1 0\nf 1 \\\n -2 -1\nv 2 2 2\nv 3 3 3\nl 5 6\nv 4 5 6\n");
  EXPECT_EQ(read_file(file, {}).geometry.point_count(), 5U);
  const Geometry all = read_file(file, {.all_points = true}).geometry;
  ASSERT_EQ(all.point_count(), 7U);
  EXPECT_EQ((std::vector<float>(all.positions.end() - 6, all.positions.end())), (std::vector<float>{9, 8, 7, 4, 5, 6}));
}

TEST_F(OtherFormats, PointsOfObjWithoutFacesAreNotCountedTwice) {
  const auto file = made("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n");
  EXPECT_EQ(read_file(file, {.all_points = true}).geometry.point_count(), 3U);
}

}  // namespace
}  // namespace glark::geometry
