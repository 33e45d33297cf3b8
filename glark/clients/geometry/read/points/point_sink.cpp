// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/geometry/read/points/point_sink.h"

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
constexpr std::int64_t indices = std::numeric_limits<std::uint32_t>::max();

template <class Array>
bool all_finite(const Array& values) {
  return std::all_of(values.begin(), values.end(), [](auto value) { return std::isfinite(value); });
}

std::string gibibytes(double bytes) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.1f GiB", bytes / (1024.0 * 1024 * 1024));
  return text.data();
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

PointSink::PointSink(std::string file, std::string element, Attributes attributes, const ReadOptions& options)
    : file_(std::move(file)), element_(std::move(element)), attributes_(attributes), options_(options) {}

void PointSink::choose_origin(const Point& point) {
  const double farthest =
      std::max({std::abs(point.position[0]), std::abs(point.position[1]), std::abs(point.position[2])});
  if (farthest < far_from_zero) return;
  for (int axis = 0; axis < 3; ++axis) origin_[axis] = std::floor(point.position[axis]);
}

void PointSink::add_point(const Point& point, bool needs_double) {
  const std::uint64_t index = points_++;
  needs_double_ = needs_double;
  if (!all_finite(point.position)) {
    if (!options_.skip_invalid)
      throw Error(
          fmt::format("{}: {} {} has a coordinate that is NaN or infinite; repair the file, or leave such points out "
                      "by the option skip_invalid",
                      file_, element_, index));
    invalid_.push_back(index);
  } else if (needs_double && index == invalid_.size()) {
    choose_origin(point);
  }
  std::array<float, 3> relative{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    relative[axis] = static_cast<float>(point.position[axis] - origin_[axis]);
    if (!std::isfinite(relative[axis]) && std::isfinite(point.position[axis]))
      throw Error(
          fmt::format("{}: {} {} has a coordinate beyond 3.4e38; scale the model down", file_, element_, index));
  }
  if (attributes_.normals && !all_finite(point.normal)) {
    ++bad_normals_;
    Point without = point;
    without.normal = {};
    return take_point(without, relative);
  }
  if (point.normal[0] != 0 || point.normal[1] != 0 || point.normal[2] != 0) ++real_normals_;
  take_point(point, relative);
}

void PointSink::add_polygon(std::span<const std::int64_t> corners) {
  for (const std::int64_t corner : corners) {
    if (corner < 0 || corner >= indices)
      throw Error(fmt::format("{}: face {} has the corner {}, which is not an index; get the file again", file_,
                              polygons_, corner));
    greatest_corner_ = std::max(greatest_corner_, corner);
  }
  ++polygons_;
  if (corners.size() < 3) ++small_polygons_;
  for (std::size_t i = 2; i < corners.size(); ++i)
    take_triangle({static_cast<std::uint32_t>(corners[0]), static_cast<std::uint32_t>(corners[i - 1]),
                   static_cast<std::uint32_t>(corners[i])});
}

void PointSink::require_sound(std::uint64_t kept_points) const {
  if (points_ == 0) throw Error(file_ + ": it has no points; export it again");
  if (greatest_corner_ >= 0 && static_cast<std::uint64_t>(greatest_corner_) >= points_)
    throw Error(
        fmt::format("{}: a face has the corner {}, but there are only {} of {}; the file is damaged, get it again",
                    file_, greatest_corner_, points_, element_));
  if (kept_points == 0) throw Error(file_ + ": no point has finite coordinates; export it again");
}

void PointSink::warn_of_invalid(std::uint64_t triangles) {
  warn(fmt::format("{} points with NaN or infinite coordinates and {} of their triangles are left out", invalid_.size(),
                   triangles));
}

bool PointSink::end_warnings() {
  if (small_polygons_ > 0) warn(fmt::format("{} faces of fewer than three corners are left out", small_polygons_));
  if (bad_normals_ > 0) warn(fmt::format("{} normals are NaN or infinite and count as missing", bad_normals_));
  if (!attributes_.normals || real_normals_ > 0) return attributes_.normals;
  warn("all normals are zero; they count as missing");
  return false;
}

}  // namespace glark::geometry
