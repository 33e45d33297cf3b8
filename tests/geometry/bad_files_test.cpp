// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Each bad file gives an error that names the file, the element and the remedy, before memory is allocated for
// announced elements.
#include <cstring>

#include "tests/geometry/temporary_file.h"

namespace glark::geometry {
namespace {

using BadFiles = TemporaryFolder;

const std::string xyz = "property float x\nproperty float y\nproperty float z\n";

std::string ply(const std::string& format, const std::string& rest) {
  return "ply\nformat " + format + " 1.0\n" + rest;
}

TEST_F(BadFiles, PlyIsExplained) {
  struct Case {
    const char* name;
    std::string contents;
    const char* said;
  };
  const std::string faces = "element face 1\nproperty list uint uint vertex_indices\n";
  const std::string three = "element vertex 3\n" + xyz;
  const std::string zeros(36, '\0');
  const Case cases[] = {
      {"empty", "", "is empty"},
      {"another format", "solid\n", "does not begin with \"ply\""},
      {"header cut off", "ply\nformat ascii 1.0\nelement vertex 3\n", "end_header"},
      {"no format", "ply\nelement vertex 1\n" + xyz + "end_header\n0 0 0\n", "format line is missing"},
      {"unknown format", ply("ascii2", three + "end_header\n"), "\"ascii2\" is unknown"},
      {"unknown type", ply("ascii", "element vertex 1\nproperty half x\nend_header\n"), "\"half\" is not a type"},
      {"negative count", ply("ascii", "element vertex -3\n" + xyz + "end_header\n"), "\"-3\", which is not a number"},
      {"count beyond 64 bits", ply("ascii", "element vertex 99999999999999999999\n" + xyz + "end_header\n"),
       "which is not a number"},
      {"no vertices", ply("ascii", "element face 0\nproperty list uchar int vertex_indices\nend_header\n"),
       "no element vertex"},
      {"no points", ply("ascii", "element vertex 0\n" + xyz + "end_header\n"), "no points"},
      {"colours without positions",
       ply("ascii",
           "element vertex 1\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n1 2 3\n"),
       "no property x"},
      {"vertices cut off", ply("binary_little_endian", three + "end_header\n") + zeros.substr(1), "too short"},
      {"lying header", ply("binary_little_endian", "element vertex 4000000000000\n" + xyz + "end_header\n") + zeros,
       "too short"},
      {"text cut off", ply("ascii", three + "end_header\n0 0 0.0000000000\n1 0 0.0000000\n"), "vertex 2 of 3"},
      {"no number", ply("ascii", three + "end_header\n0 0 0\n1 zero 0\n0 0 0\n"),
       "vertex 1 of 3: \"zero\" is not a number"},
      {"NaN", ply("ascii", three + "end_header\n0 0 0\n1 nan 0\n0 0 0\n"), "vertex 1 has a coordinate that is NaN"},
      {"infinite", ply("ascii", three + "end_header\n0 0 0\n1 1 1\n0 1e999 0\n"), "vertex 2 has a coordinate"},
      {"beyond a float",
       ply("ascii",
           "element vertex 2\nproperty double x\nproperty double y\nproperty double z\nend_header\n0 0 0\n1e300 1 1\n"),
       "scale"},
      {"corner beyond the points", ply("ascii", three + faces + "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"),
       "corner 3"},
      {"negative corner",
       ply("ascii",
           three +
               "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n"),
       "corner -1"},
      {"a corner with a fraction",
       ply("ascii",
           three +
               "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1.5 2\n"),
       "face 0 of 1: a corner is not an index"},
      {"a list length with a fraction",
       ply("ascii",
           three +
               "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3.5 0 1 2\n"),
       "has 3.5 entries"},
      {"a list of 2^31",
       ply("binary_little_endian", three + faces + "end_header\n") + zeros + std::string("\0\0\0\x80", 4) + zeros,
       "face 0 of 1: the list vertex_indices has 2147483648 entries"},
      {"list cut off",
       ply("binary_little_endian", three + faces + "end_header\n") + zeros + std::string("\x03\0\0\0", 4) + "\1",
       "face 0 of 1: the file ends"},
      {"faces without corners",
       ply("ascii", three + "element face 1\nproperty int flag\nend_header\n0 0 0\n1 0 0\n0 1 0\n3\n"),
       "no list vertex_indices"},
      {"counted by a float",
       ply("ascii", three + "element face 1\nproperty list float int vertex_indices\nend_header\n"),
       "counted by a float"},
      {"a list in the vertices",
       ply("ascii", "element vertex 1\n" + xyz + "property list uchar int more\nend_header\n0 0 0 0\n"),
       "more is a list"},
  };
  for (const Case& bad : cases) {
    SCOPED_TRACE(bad.name);
    const std::string problem = problem_with(made("bad.ply", bad.contents));
    EXPECT_NE(std::string::npos, problem.find("bad.ply")) << problem;
    EXPECT_NE(std::string::npos, problem.find(bad.said)) << problem;
    EXPECT_NE(std::string::npos, problem.find_first_of(";,")) << "no remedy: " << problem;
  }
}

TEST_F(BadFiles, TextPointsAreExplained) {
  struct Case {
    const char* file;
    const char* contents;
    const char* said;
  };
  const Case cases[] = {
      {"a.xyz", "", "is empty"},
      {"a.xyz", "# nothing\n\n", "no points"},
      {"a.xyz", "1 2 3\n1 2\n", "line 2: 2 columns"},
      {"a.xyz", "1 2 3\n1 2 three\n", "line 2"},
      {"a.xyz", "1 2 3 4 5\n", "5 columns"},
      {"a.xyz", "1 2 3\n1 2 inf\n", "NaN or infinite"},
      {"a.xyz", "1 2 3\n1 2 inf\n", "point 1 has"},
      {"a.xyz", "1,5 2,5 3,5\n", "line 1: \"1,5 2,5 3,5\" has commas"},
      {"a.csv", "x;y;z\r\n1,5;2,5;3,5\r\n", "line 2"},
      {"a.pts", "3\n1 2 3\n4 5 6 \n       ", "announces 3 points, 2 follow"},
      {"a.pts", "4000000000\n1 2 3\n", "too short"},
  };
  for (const Case& bad : cases) {
    const std::string problem = problem_with(made(bad.file, bad.contents));
    EXPECT_NE(std::string::npos, problem.find(bad.said)) << bad.contents << ": " << problem;
    EXPECT_NE(std::string::npos, problem.find(bad.file)) << problem;
  }
}

TEST_F(BadFiles, MeshesAreExplained) {
  std::string stl(84, ' ');
  const std::uint32_t count = 4000000000U;
  std::memcpy(stl.data() + 80, &count, sizeof(count));
  EXPECT_NE(std::string::npos,
            problem_with(made("a.stl", stl + std::string(50, '\0'))).find("announces 4000000000 triangles"));
  EXPECT_NE(std::string::npos, problem_with(made("b.stl", std::string("\0\1", 2))).find("too short"));
  EXPECT_NE("", problem_with(made("c.stl", "solid\nfacet normal 0 0")));
  EXPECT_NE("", problem_with(made("a.obj", "v 0 0\nf 1 2 3\n")));
  EXPECT_NE("", problem_with(made("b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 nan\nf 1 2 3\n")));
  EXPECT_NE("", problem_with(made("c.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1.5 2 3\n")));
  const std::string off = "OFF # a square\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n\n0 1 0\n3 0 1 2 .5 .5 0\n";
  EXPECT_NE(std::string::npos, problem_with(made("a.off", off + "3 0 2.5 3\n")).find("face 1: \"2.5\" is no index"));
  EXPECT_EQ(2U, read_file(made("b.off", off + "3 0 2 3\n"), {}, {}).geometry.triangle_count());
  EXPECT_NE(std::string::npos, problem_with(made("a.doc", "text")).find(".doc"));
  EXPECT_NE(std::string::npos, problem_with(path("missing.ply")).find("No such file"));
  EXPECT_NE(std::string::npos, problem_with(path("")).find("folder"));
}

TEST_F(BadFiles, BytesAfterStlAreIgnoredWithAWarning) {
  const Geometry geometry = random_geometry(1, {.triangles = true});
  write_file(path("a.stl"), geometry);
  EXPECT_TRUE(read_file(path("a.stl"), {}).warnings.empty());
  std::ofstream(path("a.stl"), std::ios::binary | std::ios::app) << "garbage";
  const std::string facet =
      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
  const std::string solid = "solid a\n" + facet + "endsolid a\n";
  made("b.stl", solid + solid + "garbage\n");
  made("c.stl", solid + solid + "\n");
  const Reading binary = read_file(path("a.stl"), {});
  EXPECT_EQ(geometry.triangle_count(), binary.geometry.triangle_count());
  ASSERT_EQ(1U, binary.warnings.size());
  EXPECT_EQ("7 bytes follow the 72 triangles that the STL header announces; they are ignored", binary.warnings[0]);
  const Reading text = read_file(path("b.stl"), {});
  ASSERT_EQ(1U, text.warnings.size());
  EXPECT_EQ("something follows the last endsolid; it is ignored", text.warnings[0]);
  EXPECT_TRUE(read_file(path("c.stl"), {}).warnings.empty());
}

TEST_F(BadFiles, MoreThanTheMemoryIsAnError) {
  const std::string header = ply("binary_little_endian", "element vertex 80000000000\n" + xyz + "end_header\n");
  made("big.ply", header);
  std::error_code error;
  std::filesystem::resize_file(path("big.ply"), header.size() + 80000000000ULL * 12, error);  // a hole, no bytes
  if (error) GTEST_SKIP() << "this file system holds no such file";
  EXPECT_NE(std::string::npos, problem_with(path("big.ply")).find("of memory"));
}

TEST_F(BadFiles, OutputIsNeverHalfWritten) {
  const std::filesystem::path old = made("a.ply", "precious");
  Geometry geometry = random_geometry(1, {});
  EXPECT_THROW(write_file(path("a.xyzzy"), geometry), Error);
  EXPECT_THROW(write_file(path("folder/a.ply"), geometry), Error);
  EXPECT_THROW(check_writable(path("")), Error);
  check_writable(old);
  EXPECT_EQ(8U, std::filesystem::file_size(old));
  EXPECT_EQ(1U, file_count());
}

}  // namespace
}  // namespace glark::geometry
