// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/tree/plane_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace glark::surfel {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

// A Jacobi rotation in the plane of the axes p and q.
void rotate(Matrix& a, Matrix& vectors, std::size_t p, std::size_t q) {
  if (a[p][q] == 0) return;
  const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
  const double tangent = std::copysign(1 / (std::fabs(theta) + std::sqrt(theta * theta + 1)), theta);
  const double cosine = 1 / std::sqrt(tangent * tangent + 1);
  const double sine = tangent * cosine;
  const std::size_t r = 3 - p - q;
  const double app = a[p][p];
  const double aqq = a[q][q];
  const double apq = a[p][q];
  const double apr = a[p][r];
  const double aqr = a[q][r];
  a[p][p] = app - tangent * apq;
  a[q][q] = aqq + tangent * apq;
  a[p][q] = a[q][p] = 0;
  a[p][r] = a[r][p] = cosine * apr - sine * aqr;
  a[q][r] = a[r][q] = sine * apr + cosine * aqr;
  for (std::size_t k = 0; k < 3; ++k) {
    const double vp = vectors[k][p];
    const double vq = vectors[k][q];
    vectors[k][p] = cosine * vp - sine * vq;
    vectors[k][q] = sine * vp + cosine * vq;
  }
}

// The eigenvector to the smallest eigenvalue of the positions' covariance. Its largest coordinate is positive.
Vector direction_of_least_variance(std::span<const Surfel> surfels, Vector centre) {
  Matrix a{};
  for (const Surfel& surfel : surfels) {
    const Vector d = surfel.position - centre;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) a[i][j] += double{d[i]} * double{d[j]};
    }
  }
  Matrix vectors{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  constexpr int sweeps = 8;  // each squares the size of the off-diagonal elements
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    rotate(a, vectors, 0, 1);
    rotate(a, vectors, 0, 2);
    rotate(a, vectors, 1, 2);
  }
  const std::size_t best = a[2][2] <= a[0][0] && a[2][2] <= a[1][1] ? 2 : a[1][1] <= a[0][0] ? 1 : 0;
  const Vector normal = unit(Vector{static_cast<float>(vectors[0][best]), static_cast<float>(vectors[1][best]),
                                    static_cast<float>(vectors[2][best])});
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
  constexpr float cancelled = 1e-3F;  // a shorter mean is only the rounding error of normals that cancel
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
  constexpr double squared_side = 12;  // squared side of a rectangle whose variance along this side is 1
  const double area = squared_side / points * std::sqrt(std::max(0.0, xx * yy - xy * xy));
  const double length = std::sqrt(squared_side * (xx + yy) / points);
  return static_cast<float>(std::max(std::sqrt(area / points), length / points));
}

}  // namespace glark::surfel
