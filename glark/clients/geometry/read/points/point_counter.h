// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Counts the points and triangles that a reader finds, hands them on to a visitor, and keeps none of them.
#pragma once

#include "glark/clients/geometry/read/points/point_sink.h"

namespace glark::geometry {

class PointCounter final : public PointSink {
 public:
  using Result = Summary;

  PointCounter(std::string file, std::string element, Attributes attributes, const ReadOptions& options,
               ColourRange range = ColourRange::byte);

  void expect(std::uint64_t, std::uint64_t) override {}
  void make_colours_of_normals() override;
  // Throws Error for more points that are not finite than it can remember, if there are triangles.
  Summary finish();

 private:
  void take_point(const Point& point, const std::array<float, 3>& relative) override;
  void take_triangle(const Triangle& triangle) override;

  Summary summary_;
  std::uint64_t triangles_left_out_ = 0;
  bool knows_triangles_ = true;  // which ones have points that are not finite
};

}  // namespace glark::geometry
