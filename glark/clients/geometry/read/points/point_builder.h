// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Builds the geometry of the points and polygons that a reader finds.
#pragma once

#include "glark/clients/geometry/read/points/point_sink.h"

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
  // Keeps what a float has lost of the position, as long as the points lie far from zero for their extent.
  void keep_rest(const Point& point, const std::array<float, 3>& relative);
  // Makes the positions relative to the first point, if the points lie far from zero for their extent and floats have lost
  // something.
  void move_origin();
  void add_colour(const std::array<float, 4>& colour);
  void leave_out_invalid();

  ColourRange range_;
  Geometry geometry_;
  bool keeps_rests_ = true;
  std::vector<float> rests_;              // what is to be added to the positions: 3 per point, or empty
  std::array<double, 3> low_{}, high_{};  // the bounding box of the first points
  bool has_box_ = false;
};

}  // namespace glark::geometry
