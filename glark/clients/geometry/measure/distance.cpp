// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/geometry/measure/distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nanoflann.hpp>
#include <numbers>
#include <optional>
#include <random>

#include "glark/clients/geometry/measure/nearest_on_triangle.h"

namespace glark::geometry {
namespace {

constexpr std::size_t samples_by_area = 200000;
constexpr std::size_t progress_step = 4096;

Vector point_at(const Geometry& geometry, const std::array<double, 3>& shift, std::size_t index) {
  Vector point;
  for (std::size_t axis = 0; axis < 3; ++axis)
    point[axis] = static_cast<double>(geometry.positions[3 * index + axis]) + shift[axis];
  return point;
}

// Places on a surface, each with the triangle or point that it lies on. Each point of a triangle is within `spacing` of
// one of the triangle's places.
struct Places {
  std::vector<Vector> positions;
  std::vector<std::uint32_t> owner;
  double spacing = 0;

  std::size_t kdtree_get_point_count() const { return positions.size(); }
  double kdtree_get_pt(std::size_t index, std::size_t axis) const { return positions[index][axis]; }
  template <class Box>
  bool kdtree_get_bbox(Box& /*unused*/) const {
    return false;
  }
};

using Tree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Places>, Places, 3, std::uint32_t>;

#if NANOFLANN_VERSION >= 0x150
using SearchParameters = nanoflann::SearchParameters;
using Found = nanoflann::ResultItem<std::uint32_t, double>;
#else
using SearchParameters = nanoflann::SearchParams;
using Found = std::pair<std::uint32_t, double>;
#endif

class Surface {
 public:
  Surface(const Geometry& geometry, const std::array<double, 3>& shift) : geometry_(geometry), shift_(shift) {
    gather();
    tree_.emplace(3, places_, nanoflann::KDTreeSingleIndexAdaptorParams(16));
  }

  struct Nearest {
    double distance;
    Vector normal;  // zero if there is no normal
  };

  Nearest nearest_to(const Vector& from) const {
    std::uint32_t place = 0;
    double square = 0;
    tree_->knnSearch(&from.x, 1, &place, &square);
    if (geometry_.triangles.empty()) return {std::sqrt(square), point_normal(places_.owner[place])};
    // The nearest triangle has a place within `spacing` of its nearest point, hence within this radius.
    const double radius = std::sqrt(square) + places_.spacing;
    std::vector<Found>& found = found_;
    SearchParameters unsorted;
    unsorted.sorted = false;
    tree_->radiusSearch(&from.x, radius * radius * (1 + 1e-9), found, unsorted);
    double best = square;
    std::uint32_t triangle = places_.owner[place];
    for (const auto& [candidate, unused] : found) {
      const std::array<Vector, 3> corners = corners_of(places_.owner[candidate]);
      const double distance = squared_distance(from, nearest_on_triangle(from, corners));
      if (distance < best) {
        best = distance;
        triangle = places_.owner[candidate];
      }
    }
    return {std::sqrt(best), normal_of(corners_of(triangle))};
  }

 private:
  std::array<Vector, 3> corners_of(std::size_t triangle) const {
    return {point_at(geometry_, shift_, geometry_.triangles[3 * triangle]),
            point_at(geometry_, shift_, geometry_.triangles[3 * triangle + 1]),
            point_at(geometry_, shift_, geometry_.triangles[3 * triangle + 2])};
  }

  Vector point_normal(std::size_t point) const {
    if (geometry_.normals.empty()) return {};
    return {geometry_.normals[3 * point], geometry_.normals[3 * point + 1], geometry_.normals[3 * point + 2]};
  }

  void gather() {
    if (geometry_.triangles.empty()) {
      for (std::uint32_t i = 0; i < geometry_.point_count(); ++i) {
        places_.positions.push_back(point_at(geometry_, shift_, i));
        places_.owner.push_back(i);
      }
      return;
    }
    std::vector<double> longest(geometry_.triangle_count());
    for (std::size_t i = 0; i < longest.size(); ++i) longest[i] = longest_edge(corners_of(i));
    std::vector<double> sorted = longest;
    std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2), sorted.end());
    const double median = sorted[sorted.size() / 2];
    // A triangle with an edge a thousand times as long as the median gets a million places. Longer edges increase the
    // spacing.
    places_.spacing = std::max(median, *std::max_element(sorted.begin(), sorted.end()) / 1000);
    for (std::uint32_t i = 0; i < longest.size(); ++i) add_places(i, longest[i]);
  }

  // Divides a triangle into equal parts. The places are the centroids of the parts. No point of a part is farther from
  // the centroid than two thirds of the part's longest edge.
  void add_places(std::uint32_t triangle, double longest) {
    const std::array<Vector, 3> corners = corners_of(triangle);
    const int parts = places_.spacing > 0 ? std::max(1, static_cast<int>(std::ceil(longest / places_.spacing))) : 1;
    for (int row = 0; row < parts; ++row)
      for (int column = 0; column < 2 * (parts - row) - 1; ++column) {
        const bool turned = column % 2 == 1;
        const double third = turned ? 2.0 / 3 : 1.0 / 3;
        const double a = (row + third) / parts;
        const double b = (std::floor(column / 2.0) + third) / parts;
        places_.positions.push_back(blend(corners, {1 - a - b, a, b}));
        places_.owner.push_back(triangle);
      }
  }

  const Geometry& geometry_;
  std::array<double, 3> shift_;
  Places places_;
  std::optional<Tree> tree_;
  mutable std::vector<Found> found_;
};

struct Sums {
  double square = 0, greatest = 0, angle_square = 0;
  std::size_t count = 0, angles = 0;

  void add(const Surface::Nearest& nearest, const Vector& normal) {
    greatest = std::max(greatest, nearest.distance);
    square += nearest.distance * nearest.distance;
    ++count;
    const double lengths = std::sqrt(dot(normal, normal) * dot(nearest.normal, nearest.normal));
    if (!(lengths > 0)) return;
    const double angle =
        std::acos(std::clamp(dot(normal, nearest.normal) / lengths, -1.0, 1.0)) * 180 / std::numbers::pi;
    angle_square += angle * angle;
    ++angles;
  }
};

class Samples {
 public:
  Samples(const Geometry& geometry, const std::array<double, 3>& shift) : geometry_(geometry), shift_(shift) {}

  // Visits random points of the surface. The area is divided into equal shares, and each share has one point. The
  // points are the same every time.
  template <class Visit>
  void by_area(Visit&& visit) const {
    double total = 0;
    std::vector<double> until(geometry_.triangle_count());
    for (std::size_t i = 0; i < until.size(); ++i) until[i] = total += area_of(corners_of(i));
    if (!(total > 0)) return;
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    std::size_t triangle = 0;
    for (std::size_t i = 0; i < samples_by_area; ++i) {
      const double share = (static_cast<double>(i) + uniform(random)) / static_cast<double>(samples_by_area) * total;
      while (triangle + 1 < until.size() && until[triangle] < share) ++triangle;
      const double root = std::sqrt(uniform(random));
      const double b = uniform(random);
      const std::array<Vector, 3> corners = corners_of(triangle);
      visit(blend(corners, {1 - root, root * (1 - b), root * b}), normal_of(corners));
    }
  }

  template <class Visit>
  void points(Visit&& visit) const {
    std::vector<bool> used(geometry_.point_count(), geometry_.triangles.empty());
    for (const std::uint32_t corner : geometry_.triangles) used[corner] = true;
    for (std::size_t i = 0; i < used.size(); ++i) {
      Vector normal{};
      if (!geometry_.normals.empty())
        normal = {geometry_.normals[3 * i], geometry_.normals[3 * i + 1], geometry_.normals[3 * i + 2]};
      if (used[i]) visit(point_at(geometry_, shift_, i), normal);
    }
  }

 private:
  std::array<Vector, 3> corners_of(std::size_t triangle) const {
    return {point_at(geometry_, shift_, geometry_.triangles[3 * triangle]),
            point_at(geometry_, shift_, geometry_.triangles[3 * triangle + 1]),
            point_at(geometry_, shift_, geometry_.triangles[3 * triangle + 2])};
  }

  const Geometry& geometry_;
  std::array<double, 3> shift_;
};

OneWay one_way(const Samples& from, bool has_triangles, std::size_t points, const Surface& to,
               const std::function<void(double)>& progress) {
  const double expected = static_cast<double>(points + (has_triangles ? samples_by_area : 0));
  std::size_t done = 0;
  Sums by_point;
  Sums by_area;
  const auto into = [&](Sums& sums) {
    return [&](const Vector& position, const Vector& normal) {
      sums.add(to.nearest_to(position), normal);
      if (++done % progress_step == 0 && progress) progress(static_cast<double>(done) / expected);
    };
  };
  from.points(into(by_point));
  if (has_triangles) from.by_area(into(by_area));
  const Sums& sums = by_area.count > 0 ? by_area : by_point;
  OneWay way;
  way.greatest = std::max(by_point.greatest, by_area.greatest);
  way.rms = std::sqrt(sums.square / static_cast<double>(std::max<std::size_t>(sums.count, 1)));
  way.has_normals = sums.angles > 0;
  if (way.has_normals) way.normal_rms_degrees = std::sqrt(sums.angle_square / static_cast<double>(sums.angles));
  return way;
}

}  // namespace

double Distance::rms() const { return std::sqrt((there.rms * there.rms + back.rms * back.rms) / 2); }

std::vector<float> distances_of_points(const Geometry& points, const Geometry& surface) {
  std::array<double, 3> shift{};  // from the surface's origin to that of the points
  for (std::size_t axis = 0; axis < 3; ++axis) shift[axis] = points.origin[axis] - surface.origin[axis];
  const Surface wanted(surface, {});
  std::vector<float> distances(points.point_count());
  for (std::size_t i = 0; i < distances.size(); ++i)
    distances[i] = static_cast<float>(wanted.nearest_to(point_at(points, shift, i)).distance);
  return distances;
}

Distance distance_between(const Geometry& result, const Geometry& reference,
                          const std::function<void(double fraction)>& progress) {
  std::array<double, 3> shift{};  // from the reference's origin to the result's
  for (std::size_t axis = 0; axis < 3; ++axis) shift[axis] = result.origin[axis] - reference.origin[axis];
  Distance distance;
  Vector low = point_at(reference, {}, 0);
  Vector high = low;
  for (std::size_t i = 0; i < reference.positions.size(); ++i) {
    low[i % 3] = std::min(low[i % 3], static_cast<double>(reference.positions[i]));
    high[i % 3] = std::max(high[i % 3], static_cast<double>(reference.positions[i]));
  }
  distance.diagonal = std::sqrt(squared_distance(low, high));
  const auto half = [&](double begin) {
    return [&progress, begin](double fraction) {
      if (progress) progress(begin + fraction / 2);
    };
  };
  {
    const Surface to(reference, {});
    distance.there = one_way({result, shift}, !result.triangles.empty(), result.point_count(), to, half(0));
  }
  const Surface to(result, shift);
  distance.back = one_way({reference, {}}, !reference.triangles.empty(), reference.point_count(), to, half(0.5));
  return distance;
}

}  // namespace glark::geometry
