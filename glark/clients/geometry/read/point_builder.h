// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Builds the geometry of the points and polygons that a reader finds.
#pragma once

#include "glark/clients/geometry/read/point_sink.h"

namespace glark::geometry {

class PointBuilder final : public PointSink {
 public:
  using Result = Reading;

  PointBuilder(std::string file, std::string element, Attributes attributes, const ReadOptions& options,
               ColourRange range = ColourRange::byte)
      : PointSink(std::move(file), std::move(element), attributes, options), range_(range) {}

  void expect(std::uint64_t points, std::uint64_t triangles) override;
  void make_colours_of_normals() override;
  Reading finish();

 private:
  void take_point(const Point& point, const std::array<float, 3>& relative) override;
  void take_triangle(const Triangle& triangle) override;
  void add_colour(const std::array<float, 4>& colour);
  void leave_out_invalid();

  ColourRange range_;
  Geometry geometry_;
};

}  // namespace glark::geometry
