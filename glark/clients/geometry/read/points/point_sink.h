// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Receives the points and polygons that a reader finds. Checks them, chooses the origin, and counts the elements that are
// left out. PointBuilder keeps what it gets, PointCounter only counts it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

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

class PointSink {
 public:
  // element: the word for a point in messages, as the format has it.
  PointSink(std::string file, std::string element, Attributes attributes, const ReadOptions& options);
  virtual ~PointSink() = default;
  PointSink(const PointSink&) = delete;
  PointSink& operator=(const PointSink&) = delete;

  // Throws Error if the memory is too small for these numbers of points and triangles.
  virtual void expect(std::uint64_t points, std::uint64_t triangles) = 0;
  // needs_double: the file's numbers have more digits than a float can hold.
  void add_point(const Point& point, bool needs_double);
  // Divides a polygon into a fan around its first corner. The end of the reading checks the indices.
  void add_polygon(std::span<const std::int64_t> corners);
  void warn(std::string text) { warnings_.push_back(std::move(text)); }
  // The file's normals are colours.
  virtual void make_colours_of_normals() = 0;

 protected:
  using Triangle = std::array<std::uint32_t, 3>;

  // Receives a point whose normal, if it has one, is finite. relative: its position, relative to the origin.
  virtual void take_point(const Point& point, const std::array<float, 3>& relative) = 0;
  virtual void take_triangle(const Triangle& triangle) = 0;

  // Throws Error if there are no points, or if a corner is no point.
  void require_sound(std::uint64_t kept_points) const;
  void warn_of_invalid(std::uint64_t triangles);
  // Warns of what counts as missing. Returns whether the points have normals.
  bool end_warnings();

  std::string file_;
  std::string element_;
  Attributes attributes_;
  ReadOptions options_;
  std::vector<std::string> warnings_;
  std::array<double, 3> origin_{};
  std::uint64_t points_ = 0;            // all that were added
  std::vector<std::uint64_t> invalid_;  // points with coordinates that are not finite
  bool needs_double_ = false;           // what add_point() got last

 private:
  void choose_origin(const Point& point);

  std::uint64_t bad_normals_ = 0;
  std::uint64_t real_normals_ = 0;
  std::uint64_t small_polygons_ = 0;
  std::uint64_t polygons_ = 0;
  std::int64_t greatest_corner_ = -1;
};

}  // namespace glark::geometry
