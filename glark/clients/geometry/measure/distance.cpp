// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/geometry/measure/distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <nanoflann.hpp>
#include <numbers>
#include <optional>
#include <random>

#include "glark/clients/geometry/measure/nearest_on_triangle.h"
#include "glark/clients/geometry/measure/triangle_tree.h"

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

// The points of a geometry without triangles, for a search tree.
struct Places {
  std::vector<Vector> positions;

  std::size_t kdtree_get_point_count() const { return positions.size(); }
  double kdtree_get_pt(std::size_t index, std::size_t axis) const { return positions[index][axis]; }
  template <class Box>
  bool kdtree_get_bbox(Box& /*unused*/) const {
    return false;
  }
};

using PointTree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Places>, Places, 3, std::uint32_t>;

class Surface {
 public:
  Surface(const Geometry& geometry, const std::array<double, 3>& shift) : geometry_(geometry) {
    if (!geometry.triangles.empty()) {
      triangles_.emplace(geometry, shift);
      return;
    }
    for (std::size_t i = 0; i < geometry.point_count(); ++i) places_.positions.push_back(point_at(geometry, shift, i));
    points_.emplace(3, places_, nanoflann::KDTreeSingleIndexAdaptorParams(16));
  }

  struct Nearest {
    double distance;
    Vector normal;  // zero if there is no normal
  };

  Nearest nearest_to(const Vector& from) const {
    if (triangles_) {
      const TriangleTree::Nearest nearest = triangles_->nearest_to(from, last_);
      last_ = nearest.triangle;
      return {std::sqrt(nearest.square), normal_of(triangles_->corners_of(last_))};
    }
    const auto [point, square] = nearest_point(from);
    return {std::sqrt(square), point_normal(point)};
  }

  // Returns the squared distance. If this is less than `enough`, it may return a larger number up to `enough` instead.
  double square_to(const Vector& from, double enough) const {
    if (!triangles_) return nearest_point(from).second;
    const TriangleTree::Nearest nearest = triangles_->nearest_to(from, last_, enough);
    last_ = nearest.triangle;
    return nearest.square;
  }

 private:
  std::pair<std::uint32_t, double> nearest_point(const Vector& from) const {
    std::uint32_t place = 0;
    double square = 0;
    points_->knnSearch(&from.x, 1, &place, &square);
    return {place, square};
  }

  Vector point_normal(std::size_t point) const {
    if (geometry_.normals.empty()) return {};
    return {geometry_.normals[3 * point], geometry_.normals[3 * point + 1], geometry_.normals[3 * point + 2]};
  }

  const Geometry& geometry_;
  std::optional<TriangleTree> triangles_;
  mutable std::uint32_t last_ = 0;  // the triangle found last; the next one is often near
  Places places_;
  std::optional<PointTree> points_;
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
  // points are the same every time. Ends if `visit` returns false.
  template <class Visit>
  void by_area(std::size_t count, Visit&& visit) const {
    double total = 0;
    std::vector<double> until(geometry_.triangle_count());
    for (std::size_t i = 0; i < until.size(); ++i) until[i] = total += area_of(corners_of(i));
    if (!(total > 0)) return;
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    std::size_t triangle = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const double share = (static_cast<double>(i) + uniform(random)) / static_cast<double>(count) * total;
      while (triangle + 1 < until.size() && until[triangle] < share) ++triangle;
      const double root = std::sqrt(uniform(random));
      const double b = uniform(random);
      const std::array<Vector, 3> corners = corners_of(triangle);
      if (!visit(blend(corners, {1 - root, root * (1 - b), root * b}), normal_of(corners))) return;
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
      if (used[i] && !visit(point_at(geometry_, shift_, i), normal)) return;
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
      return true;
    };
  };
  from.points(into(by_point));
  if (has_triangles) from.by_area(samples_by_area, into(by_area));
  const Sums& sums = by_area.count > 0 ? by_area : by_point;
  OneWay way;
  way.greatest = std::max(by_point.greatest, by_area.greatest);
  way.rms = std::sqrt(sums.square / static_cast<double>(std::max<std::size_t>(sums.count, 1)));
  way.has_normals = sums.angles > 0;
  if (way.has_normals) way.normal_rms_degrees = std::sqrt(sums.angle_square / static_cast<double>(sums.angles));
  return way;
}

// Returns the greatest squared distance of a sample, or `least` if that is greater. Stops with a distance above `most`.
// Most samples are nearer than that to the triangle that was the nearest one before.
double greatest_square(const Samples& from, bool has_triangles, const Surface& to, double least, double most,
                       std::size_t samples) {
  double greatest = least;
  const auto visit = [&](const Vector& position, const Vector& /*normal*/) {
    greatest = std::max(greatest, to.square_to(position, greatest));
    return greatest <= most;
  };
  from.points(visit);
  if (has_triangles && greatest <= most) from.by_area(samples, visit);
  return greatest;
}

std::array<double, 3> shift_between(const Geometry& geometry, const Geometry& reference) {
  std::array<double, 3> shift{};
  for (std::size_t axis = 0; axis < 3; ++axis) shift[axis] = geometry.origin[axis] - reference.origin[axis];
  return shift;
}

}  // namespace

double Distance::rms() const { return std::sqrt((there.rms * there.rms + back.rms * back.rms) / 2); }

double diagonal_of(const Geometry& geometry) {
  Vector low = point_at(geometry, {}, 0);
  Vector high = low;
  for (std::size_t i = 0; i < geometry.positions.size(); ++i) {
    low[i % 3] = std::min(low[i % 3], static_cast<double>(geometry.positions[i]));
    high[i % 3] = std::max(high[i % 3], static_cast<double>(geometry.positions[i]));
  }
  return std::sqrt(squared_distance(low, high));
}

std::vector<float> distances_of_points(const Geometry& points, const Geometry& surface) {
  const std::array<double, 3> shift = shift_between(points, surface);
  const Surface wanted(surface, {});
  std::vector<float> distances(points.point_count());
  for (std::size_t i = 0; i < distances.size(); ++i)
    distances[i] = static_cast<float>(wanted.nearest_to(point_at(points, shift, i)).distance);
  return distances;
}

Distance distance_between(const Geometry& result, const Geometry& reference,
                          const std::function<void(double fraction)>& progress) {
  const std::array<double, 3> shift = shift_between(result, reference);
  Distance distance;
  distance.diagonal = diagonal_of(reference);
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

HausdorffDistance hausdorff_from(const Geometry& reference) {
  const auto surface = std::make_shared<const Surface>(reference, std::array<double, 3>{});
  return [surface, &reference](const Geometry& result, const Needed& needed) {
    const std::array<double, 3> shift = shift_between(result, reference);
    const std::size_t samples = std::max<std::size_t>(1, samples_by_area / needed.one_of);
    const double most = needed.most * needed.most;
    double square = needed.least * needed.least;
    square = greatest_square({result, shift}, !result.triangles.empty(), *surface, square, most, samples);
    if (square <= most)
      square =
          greatest_square({reference, {}}, !reference.triangles.empty(), Surface(result, shift), square, most, samples);
    return std::sqrt(square);
  };
}

}  // namespace glark::geometry
