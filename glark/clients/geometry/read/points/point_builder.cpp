// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/geometry/read/points/point_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace glark::geometry {
namespace {

constexpr std::uint32_t removed = std::numeric_limits<std::uint32_t>::max();
// Points are far from zero if their coordinates are more than so many diagonals of their bounding box. Nearer to zero, a
// float is exact to 1/2 millionth of the diagonal.
constexpr double far_diagonals = 8;

template <class Value>
void keep(std::vector<Value>& values, const std::vector<std::uint32_t>& target, std::size_t width) {
  for (std::size_t i = 0; i * width < values.size(); ++i)
    if (target[i] != removed)
      std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(i * width), width,
                  values.begin() + static_cast<std::ptrdiff_t>(target[i] * width));
}

}  // namespace

void PointBuilder::expect(std::uint64_t points, std::uint64_t triangles) {
  constexpr std::uint64_t most = removed;
  const double point_bytes =
      12.0 + (attributes_.normals ? 12 : 0) + (attributes_.colours ? 4 : 0) + (attributes_.texture_coordinates ? 8 : 0);
  require_memory(file_, static_cast<double>(points) * point_bytes + static_cast<double>(triangles) * 12.0);
  if (points >= most)
    throw Error(
        fmt::format("{}: {} of {}; at most {} can be indexed, split the file", file_, points, element_, most - 1));
  geometry_.positions.reserve(3 * points);
  if (attributes_.normals) geometry_.normals.reserve(3 * points);
  if (attributes_.colours) geometry_.colours.reserve(4 * points);
  if (attributes_.texture_coordinates) geometry_.texture_coordinates.reserve(2 * points);
  geometry_.triangles.reserve(3 * triangles);
}

void PointBuilder::take_point(const Point& point, const std::array<float, 3>& relative) {
  if (geometry_.point_count() >= removed) throw Error(file_ + ": more points than 32 bits can count; split the file");
  geometry_.positions.insert(geometry_.positions.end(), relative.begin(), relative.end());
  if (needs_double_ && keeps_rests_ && origin_ == std::array<double, 3>{}) keep_rest(point, relative);
  if (attributes_.normals) geometry_.normals.insert(geometry_.normals.end(), point.normal.begin(), point.normal.end());
  if (attributes_.colours) add_colour(point.colour);
  if (attributes_.texture_coordinates)
    geometry_.texture_coordinates.insert(geometry_.texture_coordinates.end(), point.texture_coordinate.begin(),
                                         point.texture_coordinate.end());
}

void PointBuilder::keep_rest(const Point& point, const std::array<float, 3>& relative) {
  const bool is_finite = invalid_.empty() || invalid_.back() != points_ - 1;
  if (is_finite) {
    if (!has_box_) low_ = high_ = point.position;
    has_box_ = true;
    double farthest = 0, diagonal = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low_[axis] = std::min(low_[axis], point.position[axis]);
      high_[axis] = std::max(high_[axis], point.position[axis]);
      farthest = std::max({farthest, -low_[axis], high_[axis]});
      diagonal = std::hypot(diagonal, high_[axis] - low_[axis]);
    }
    if (farthest <= far_diagonals * diagonal || farthest == 0) {
      // More points only make the box larger.
      keeps_rests_ = farthest == 0;
      if (!keeps_rests_) rests_ = {};
      return;
    }
  }
  rests_.resize(geometry_.positions.size() - 3);  // of points at zero
  for (std::size_t axis = 0; axis < 3; ++axis)
    rests_.push_back(static_cast<float>(point.position[axis] - static_cast<double>(relative[axis])));
}

void PointBuilder::move_origin() {
  const bool has_origin = origin_ != std::array<double, 3>{};
  if (has_origin || !keeps_rests_ || std::all_of(rests_.begin(), rests_.end(), [](float rest) { return rest == 0; }))
    return;
  std::vector<float>& positions = geometry_.positions;
  rests_.resize(positions.size());  // of points at zero
  std::size_t first = 0;
  while (first / 3 < invalid_.size() && invalid_[first / 3] == first / 3) first += 3;
  for (std::size_t axis = 0; axis < 3; ++axis) origin_[axis] = static_cast<double>(positions[first + axis]);
  for (std::size_t i = 0; i < positions.size(); ++i)
    positions[i] =
        static_cast<float>(static_cast<double>(positions[i]) - origin_[i % 3] + static_cast<double>(rests_[i]));
  rests_ = {};
}

void PointBuilder::take_triangle(const Triangle& triangle) {
  geometry_.triangles.insert(geometry_.triangles.end(), triangle.begin(), triangle.end());
}

// Numbers are fractions until one is clearly above 1. From then on, they are bytes, and the earlier numbers become 0 or
// 1 of 255.
void PointBuilder::add_colour(const std::array<float, 4>& colour) {
  constexpr float above_fractions = 2;
  const auto is_above = [](float channel) { return channel > above_fractions; };
  if (range_ == ColourRange::by_greatest && std::any_of(colour.begin(), colour.end(), is_above)) {
    range_ = ColourRange::byte;
    for (std::size_t i = 0; i < geometry_.colours.size(); ++i)
      if (i % 4 < 3 || colour[3] != opaque) geometry_.colours[i] = geometry_.colours[i] < 128 ? 0 : 1;
  }
  const float scale = range_ == ColourRange::byte ? 1.0F : 255.0F;
  const auto add = [&](float channel) {
    const float scaled = channel > 0 ? std::min(channel * scale, 255.0F) : 0.0F;  // NaN becomes 0
    geometry_.colours.push_back(static_cast<std::uint8_t>(std::lround(scaled)));
  };
  for (std::size_t i = 0; i < 3; ++i) add(colour[i]);
  if (colour[3] == opaque)
    geometry_.colours.push_back(255);
  else
    add(colour[3]);
}

void PointBuilder::make_colours_of_normals() {
  const std::vector<float> normals = std::move(geometry_.normals);
  geometry_.normals = {};
  const bool are_fractions = std::all_of(normals.begin(), normals.end(), [](float n) { return n <= 1; });
  const float scale = are_fractions ? 255.0F : 1.0F;
  geometry_.colours.assign(normals.size() / 3 * 4, 255);
  for (std::size_t i = 0; i < normals.size(); ++i)
    geometry_.colours[i / 3 * 4 + i % 3] =
        static_cast<std::uint8_t>(std::lround(std::clamp(scale * normals[i], 0.0F, 255.0F)));
  attributes_.normals = false;
  attributes_.colours = true;
}

void PointBuilder::leave_out_invalid() {
  std::vector<std::uint32_t> target(geometry_.point_count());
  std::uint32_t next = 0;
  std::size_t bad = 0;
  for (std::uint32_t i = 0; i < target.size(); ++i) {
    const bool is_bad = bad < invalid_.size() && invalid_[bad] == i;
    bad += is_bad ? 1 : 0;
    target[i] = is_bad ? removed : next++;
  }
  keep(geometry_.positions, target, 3);
  keep(geometry_.normals, target, 3);
  keep(geometry_.colours, target, 4);
  keep(geometry_.texture_coordinates, target, 2);
  geometry_.positions.resize(std::size_t{3} * next);
  if (attributes_.normals) geometry_.normals.resize(std::size_t{3} * next);
  if (attributes_.colours) geometry_.colours.resize(std::size_t{4} * next);
  if (attributes_.texture_coordinates) geometry_.texture_coordinates.resize(std::size_t{2} * next);
  std::vector<std::uint32_t>& triangles = geometry_.triangles;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    const std::array corners{target[triangles[i]], target[triangles[i + 1]], target[triangles[i + 2]]};
    if (std::find(corners.begin(), corners.end(), removed) != corners.end()) continue;
    std::copy(corners.begin(), corners.end(), triangles.begin() + static_cast<std::ptrdiff_t>(kept));
    kept += 3;
  }
  warn_of_invalid((triangles.size() - kept) / 3);
  triangles.resize(kept);
}

Reading PointBuilder::finish() {
  require_sound(points_ - invalid_.size());
  move_origin();
  geometry_.origin = origin_;
  if (!invalid_.empty()) leave_out_invalid();
  if (!end_warnings()) geometry_.normals = {};
  return {std::move(geometry_), std::move(warnings_)};
}

}  // namespace glark::geometry
