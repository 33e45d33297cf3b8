// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/geometry/read/points/point_counter.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace glark::geometry {
namespace {

constexpr std::size_t most_invalid = std::size_t{1} << 20;  // 8 MiB

}  // namespace

PointCounter::PointCounter(std::string file, std::string element, Attributes attributes, const ReadOptions& options,
                           ColourRange)
    : PointSink(std::move(file), std::move(element), attributes, options) {
  summary_.low.fill(std::numeric_limits<double>::infinity());
  summary_.high.fill(-std::numeric_limits<double>::infinity());
}

void PointCounter::make_colours_of_normals() {
  attributes_.normals = false;
  attributes_.colours = true;
}

void PointCounter::take_point(const Point& point, const std::array<float, 3>& relative) {
  if (options_.visitor != nullptr) options_.visitor->add_point(point.position, point.normal);
  if (!invalid_.empty() && invalid_.back() == points_ - 1) {
    if (invalid_.size() > most_invalid)
      throw Error(
          fmt::format("{}: more than {} points have NaN or infinite coordinates; read the whole file with a "
                      "larger number for the option memory, or repair it",
                      file_, most_invalid));
    // The file has triangles before this point.
    if (summary_.triangles > 0) knows_triangles_ = false;
    return;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double coordinate = origin_[axis] + static_cast<double>(relative[axis]);
    summary_.low[axis] = std::min(summary_.low[axis], coordinate);
    summary_.high[axis] = std::max(summary_.high[axis], coordinate);
  }
}

void PointCounter::take_triangle(const Triangle& triangle) {
  const bool is_left_out =
      !invalid_.empty() && std::any_of(triangle.begin(), triangle.end(), [&](std::uint64_t corner) {
        return std::binary_search(invalid_.begin(), invalid_.end(), corner);
      });
  ++(is_left_out ? triangles_left_out_ : summary_.triangles);
  if (!is_left_out && options_.visitor != nullptr) options_.visitor->add_triangle(triangle);
}

Summary PointCounter::finish() {
  summary_.points = points_ - invalid_.size();
  require_sound(summary_.points);
  if (!knows_triangles_)
    throw Error(file_ +
                ": faces come before points with NaN or infinite coordinates; read the whole file with a larger number "
                "for the option memory");
  if (!invalid_.empty()) warn_of_invalid(triangles_left_out_);
  summary_.normals = end_warnings();
  summary_.colours = attributes_.colours;
  summary_.texture_coordinates = attributes_.texture_coordinates;
  summary_.origin = origin_;
  summary_.warnings = std::move(warnings_);
  return std::move(summary_);
}

}  // namespace glark::geometry
