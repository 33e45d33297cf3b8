// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Checks the points and polygons that a reader finds, chooses the origin, and counts the elements that it leaves out.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "glark/clients/geometry/geometry.h"

namespace glark::geometry {

struct Attributes {
  bool normals = false;
  bool colours = false;
  bool texture_coordinates = false;
};

// The range of a colour's numbers. In most files, floats go from 0 to 1; in some, from 0 to 255. The greatest number of
// the file decides.
enum class ColourRange { byte, fraction, by_greatest };

inline constexpr float opaque = -1;  // stands for an alpha that the file does not have

struct Point {
  std::array<double, 3> position{};
  std::array<float, 3> normal{};
  std::array<float, 4> colour{0, 0, 0, opaque};
  std::array<float, 2> texture_coordinate{};
};

class PointBuilder {
 public:
  // element: the word for a point in messages, as the format has it.
  PointBuilder(std::string file, std::string element, Attributes attributes, const ReadOptions& options,
               ColourRange range = ColourRange::byte);

  // Throws Error if the memory is too small for these numbers of points and triangles.
  void expect(std::uint64_t points, std::uint64_t triangles);
  // needs_double: the file's numbers have more digits than a float can hold.
  void add_point(const Point& point, bool needs_double);
  // Divides a polygon into a fan around its first corner. finish() checks the indices.
  void add_polygon(std::span<const std::int64_t> corners);
  void warn(std::string text) { warnings_.push_back(std::move(text)); }

  Reading finish();

 private:
  void choose_origin(const Point& point);
  void add_colour(const std::array<float, 4>& colour);
  void check_triangles() const;
  void leave_out_invalid();

  std::string file_;
  std::string element_;
  Attributes attributes_;
  ReadOptions options_;
  ColourRange range_;
  Geometry geometry_;
  std::vector<std::string> warnings_;
  std::vector<std::uint32_t> invalid_;  // points with coordinates that are not finite
  std::uint64_t bad_normals_ = 0;
  std::uint64_t real_normals_ = 0;
  std::uint64_t small_polygons_ = 0;
  std::uint64_t polygons_ = 0;
};

}  // namespace glark::geometry
