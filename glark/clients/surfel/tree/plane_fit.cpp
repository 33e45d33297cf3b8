// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/tree/plane_fit.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

namespace glark::surfel {
namespace {

// Returns the eigenvector of the smallest eigenvalue of the positions' covariance. Its largest coordinate is positive.
Vector direction_of_least_variance(std::span<const Surfel> surfels, Vector centre) {
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Surfel& surfel : surfels) {
    const Vector d = surfel.position - centre;
    const Eigen::Vector3d difference(d.x, d.y, d.z);
    covariance += difference * difference.transpose();
  }
  // computeDirect() would be faster, but its eigenvectors are inaccurate where eigenvalues are almost equal.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const Eigen::Vector3f least = solver.eigenvectors().col(0).cast<float>();  // eigenvalues are in ascending order
  const Vector normal = unit(Vector{least.x(), least.y(), least.z()});
  const float largest = std::max({normal.x, normal.y, normal.z});
  return -std::min({normal.x, normal.y, normal.z}) > largest ? normal * -1.0F : normal;
}

}  // namespace

Plane fit_plane(std::span<const Surfel> surfels) {
  std::array<double, 3> sum{};
  Vector normal;
  for (const Surfel& surfel : surfels) {
    for (std::size_t k = 0; k < 3; ++k) sum[k] += double{surfel.position[k]};
    normal = normal + surfel.normal;
  }
  const auto count = static_cast<double>(std::max<std::size_t>(surfels.size(), 1));
  Plane plane;
  plane.centre = {static_cast<float>(sum[0] / count), static_cast<float>(sum[1] / count),
                  static_cast<float>(sum[2] / count)};
  constexpr float cancelled = 1e-3F;  // a shorter mean is only rounding error, because the normals cancel
  plane.normal = length(normal) > cancelled ? unit(normal) : direction_of_least_variance(surfels, plane.centre);
  if (plane.normal == Vector{}) plane.normal = {0, 0, 1};
  return plane;
}

float mean_spacing(std::span<const Surfel> surfels, const Plane& plane) {
  if (surfels.empty()) return 0;
  const Vector u = perpendicular(plane.normal), v = cross(plane.normal, u);
  double xx = 0, xy = 0, yy = 0;
  for (const Surfel& surfel : surfels) {
    const Vector d = surfel.position - plane.centre;
    const double x = dot(d, u), y = dot(d, v);
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }
  const auto points = static_cast<double>(surfels.size());
  constexpr double squared_side = 12;  // the squared side of a rectangle whose variance along this side is 1
  const double area = squared_side / points * std::sqrt(std::max(0.0, xx * yy - xy * xy));
  const double length = std::sqrt(squared_side * (xx + yy) / points);
  return static_cast<float>(std::max(std::sqrt(area / points), length / points));
}

}  // namespace glark::surfel
