// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/geometry/read/point_builder.h"

#include <fmt/format.h>

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace glark::geometry {
namespace {

// Above this number, the step between floats is about a thousandth or more.
constexpr double far_from_zero = 8192;
constexpr std::uint32_t removed = std::numeric_limits<std::uint32_t>::max();

template <class Array>
bool all_finite(const Array& values) {
  return std::all_of(values.begin(), values.end(), [](auto value) { return std::isfinite(value); });
}

std::string gibibytes(double bytes) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.1f GiB", bytes / (1024.0 * 1024 * 1024));
  return text.data();
}

template <class Value>
void keep(std::vector<Value>& values, const std::vector<std::uint32_t>& target, std::size_t width) {
  for (std::size_t i = 0; i * width < values.size(); ++i)
    if (target[i] != removed)
      std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(i * width), width,
                  values.begin() + static_cast<std::ptrdiff_t>(target[i] * width));
}

}  // namespace

void require_memory(const std::string& file, double bytes) {
  double have = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
    have = std::min(have, static_cast<double>(limit.rlim_cur));
  if (bytes > have)
    throw Error(file + ": its contents take " + gibibytes(bytes) + " of memory, this machine has " + gibibytes(have) +
                "; split the file into tiles or thin it first");
}

PointBuilder::PointBuilder(std::string file, std::string element, Attributes attributes, const ReadOptions& options,
                           ColourRange range)
    : file_(std::move(file)), element_(std::move(element)), attributes_(attributes), options_(options), range_(range) {}

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

void PointBuilder::choose_origin(const Point& point) {
  const double farthest =
      std::max({std::abs(point.position[0]), std::abs(point.position[1]), std::abs(point.position[2])});
  if (farthest < far_from_zero) return;
  for (int axis = 0; axis < 3; ++axis) geometry_.origin[axis] = std::floor(point.position[axis]);
}

void PointBuilder::add_point(const Point& point, bool needs_double) {
  const std::size_t index = geometry_.point_count();
  if (index >= removed) throw Error(file_ + ": more points than 32 bits can count; split the file");
  if (!all_finite(point.position)) {
    if (!options_.skip_invalid)
      throw Error(
          fmt::format("{}: {} {} has a coordinate that is NaN or infinite; repair the file, or leave such points out "
                      "with --skip-invalid",
                      file_, element_, index));
    invalid_.push_back(static_cast<std::uint32_t>(index));
  } else if (needs_double && index == invalid_.size()) {
    choose_origin(point);
  }
  for (int axis = 0; axis < 3; ++axis) {
    const auto relative = static_cast<float>(point.position[axis] - geometry_.origin[axis]);
    if (!std::isfinite(relative) && std::isfinite(point.position[axis]))
      throw Error(
          fmt::format("{}: {} {} has a coordinate beyond 3.4e38; scale the model down", file_, element_, index));
    geometry_.positions.push_back(relative);
  }
  if (attributes_.normals) {
    const bool good = all_finite(point.normal);
    bad_normals_ += good ? 0 : 1;
    if (good && (point.normal[0] != 0 || point.normal[1] != 0 || point.normal[2] != 0)) ++real_normals_;
    for (const float component : point.normal) geometry_.normals.push_back(good ? component : 0.0F);
  }
  if (attributes_.colours) add_colour(point.colour);
  if (attributes_.texture_coordinates)
    geometry_.texture_coordinates.insert(geometry_.texture_coordinates.end(), point.texture_coordinate.begin(),
                                         point.texture_coordinate.end());
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

void PointBuilder::add_polygon(std::span<const std::int64_t> corners) {
  for (const std::int64_t corner : corners)
    if (corner < 0 || corner >= static_cast<std::int64_t>(removed))
      throw Error(fmt::format("{}: face {} has the corner {}, which is not an index; get the file again", file_,
                              polygons_, corner));
  ++polygons_;
  if (corners.size() < 3) ++small_polygons_;
  for (std::size_t i = 2; i < corners.size(); ++i)
    for (const std::int64_t corner : {corners[0], corners[i - 1], corners[i]})
      geometry_.triangles.push_back(static_cast<std::uint32_t>(corner));
}

void PointBuilder::check_triangles() const {
  const std::size_t points = geometry_.point_count();
  const auto bad = std::find_if(geometry_.triangles.begin(), geometry_.triangles.end(),
                                [&](std::uint32_t corner) { return corner >= points; });
  if (bad != geometry_.triangles.end())
    throw Error(
        fmt::format("{}: a face has the corner {}, but there are only {} of {}; the file is damaged, get it again",
                    file_, *bad, points, element_));
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
  warn(fmt::format("{} points with NaN or infinite coordinates and {} of their triangles are left out", invalid_.size(),
                   (triangles.size() - kept) / 3));
  triangles.resize(kept);
}

Reading PointBuilder::finish() {
  if (geometry_.positions.empty()) throw Error(file_ + ": it has no points; export it again");
  check_triangles();
  if (!invalid_.empty()) leave_out_invalid();
  if (geometry_.positions.empty()) throw Error(file_ + ": no point has finite coordinates; export it again");
  if (small_polygons_ > 0) warn(fmt::format("{} faces of fewer than three corners are left out", small_polygons_));
  if (bad_normals_ > 0) warn(fmt::format("{} normals are NaN or infinite and count as missing", bad_normals_));
  if (attributes_.normals && real_normals_ == 0) {
    warn("all normals are zero; they count as missing");
    geometry_.normals = {};
  }
  return {std::move(geometry_), std::move(warnings_)};
}

}  // namespace glark::geometry
