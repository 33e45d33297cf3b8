// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/transfer/deformation.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace glark::stream {
namespace {

using common::cross;
using common::dot;
using common::length;
using common::unit;
using common::Vector3f;

// The cosine of half of the cone's apex angle, 120 degrees, and of its halves.
constexpr std::array cosines{0.5F, 0.8660254F, 0.9659258F, 0.9914449F, 0.9978589F, 0.9994646F};
constexpr float near_inside = -0.1F;  // the least coordinate of a point that a triangle is around
constexpr float far_outside = -3;
constexpr float least_flat_height = 0.01F;  // of its projection
constexpr float least_height = 0.15F;       // of a triangle, relative to its longest edge
constexpr float most_scale = 8;             // of a triangle, relative to that of all neighbours
constexpr float most_usual_scale = 4;       // that is not compared
constexpr double least_spread = 0.01;       // of neighbours across their longest direction, relative to that along it
constexpr float same_place = 1e-6F;         // the square of a distance, relative to that of the farthest neighbour

// The mean of the neighbours, and their mean normal.
struct Plane {
  Vector3f centre, normal;
  Vector3f project(const Vector3f& p) const { return p - normal * dot(p - centre, normal); }
};

Plane plane_of(std::span<const Neighbour> neighbours, const std::vector<Vector3f>& positions,
               const std::vector<Vector3f>& normals, const Vector3f& origin) {
  Plane plane;
  float sum = 0;
  for (const Neighbour& near : neighbours) {
    plane.centre += near.weight * (positions[near.index] - origin);
    plane.normal += near.weight * normals[near.index];
    sum += near.weight;
  }
  plane.centre = origin + plane.centre * (1 / sum);
  plane.normal = unit(plane.normal);
  return plane;
}

bool is_wide(const std::array<Vector3f, 3>& t, float least) {
  const float longest = std::max({common::squared_distance(t[0], t[1]), common::squared_distance(t[1], t[2]),
                                  common::squared_distance(t[2], t[0])});
  return length(cross(t[1] - t[0], t[2] - t[0])) > least * longest;
}

// Takes the three nearest samples whose directions from the point differ by more than half of the cone's angle.
bool vote(const Samples& samples, const Vector3f& point, std::span<const Neighbour> neighbours, float cosine,
          std::array<std::uint32_t, 3>& triangle) {
  std::array<Vector3f, 3> directions{};
  std::size_t have = 0;
  const float same = same_place * common::squared_distance(samples.before[neighbours.back().index], point);
  for (const Neighbour& near : neighbours) {
    const Vector3f away = samples.before[near.index] - point;
    const Vector3f direction = away * (1 / std::sqrt(dot(away, away) + std::numeric_limits<float>::min()));
    bool is_excluded = false;
    for (std::size_t k = 0; k < have; ++k)
      is_excluded |= dot(direction, directions[k]) > cosine ||
                     common::squared_distance(samples.before[near.index], samples.before[triangle[k]]) <= same;
    if (is_excluded) continue;
    triangle[have] = near.index;
    if (have == 2 &&
        !is_wide({samples.before[triangle[0]], samples.before[triangle[1]], samples.before[triangle[2]]}, least_height))
      continue;
    directions[have] = direction;
    if (++have == 3) return true;
  }
  return false;
}

// The least barycentric coordinate of a point, projected onto the plane of a triangle: negative outside.
float least_coordinate(const Samples& samples, const Vector3f& point, const std::array<std::uint32_t, 3>& triangle) {
  const Vector3f a = samples.before[triangle[1]] - samples.before[triangle[0]];
  const Vector3f b = samples.before[triangle[2]] - samples.before[triangle[0]];
  const Vector3f c = point - samples.before[triangle[0]], n = cross(a, b);
  const float u = dot(cross(c, b), n), v = dot(cross(a, c), n), whole = dot(n, n);
  return whole > 0 ? std::min({u, v, whole - u - v}) / whole : -std::numeric_limits<float>::max();
}

// How the neighbours' distances from each other have grown.
float growth_of(const Samples& samples, std::span<const Neighbour> neighbours) {
  Vector3f mean, mean_after;
  const std::uint32_t first = neighbours[0].index;
  for (const Neighbour& near : neighbours) {
    mean += samples.before[near.index] - samples.before[first];
    mean_after += samples.after[near.index] - samples.after[first];
  }
  mean = mean * (1 / static_cast<float>(neighbours.size()));
  mean_after = mean_after * (1 / static_cast<float>(neighbours.size()));
  float before = 0, after = 0;
  for (const Neighbour& near : neighbours) {
    before += common::squared_distance(samples.before[near.index] - samples.before[first], mean);
    after += common::squared_distance(samples.after[near.index] - samples.after[first], mean_after);
  }
  return before > 0 ? std::sqrt(after / before) : 1;
}

// The rotation about the axis of both, which takes `from` to `to`, applied to v. For unit vectors. Source: Rodrigues.
Vector3f turned_with(const Vector3f& from, const Vector3f& to, const Vector3f& v) {
  const Vector3f axis = cross(from, to);
  const float cosine = dot(from, to);
  if (!(cosine > -0.999F)) return v * -1.0F;
  return unit(v * cosine + cross(axis, v) + axis * (dot(axis, v) / (1 + cosine)));
}

Eigen::Vector3d wide(const Vector3f& v) { return Eigen::Vector3f(v.x, v.y, v.z).cast<double>(); }
Vector3f narrow(const Eigen::Vector3d& v) {
  const Eigen::Vector3f f = v.cast<float>();
  return {f.x(), f.y(), f.z()};
}

// The rotation and scaling that takes the neighbours nearest to where they are after the edit. Nothing if they lie on a
// line. Source: Umeyama 1991, without the restriction to rotations: of flat neighbours, the normals tell the side.
std::optional<Deformed> move_as_a_whole(const Samples& samples, const Vector3f& point, const Vector3f& normal,
                                        std::span<const Neighbour> neighbours, const Plane& from, const Plane& to) {
  const std::uint32_t first = neighbours[0].index;
  const auto before = [&](const Neighbour& near) { return wide(samples.before[near.index] - samples.before[first]); };
  const auto after = [&](const Neighbour& near) { return wide(samples.after[near.index] - samples.after[first]); };
  double sum = 0;
  for (const Neighbour& near : neighbours) sum += static_cast<double>(near.weight);
  const auto weight = [&](const Neighbour& near) { return static_cast<double>(near.weight) / sum; };
  Eigen::Vector3d mean = Eigen::Vector3d::Zero(), mean_after = Eigen::Vector3d::Zero();
  for (const Neighbour& near : neighbours) {
    mean += weight(near) * before(near);
    mean_after += weight(near) * after(near);
  }
  Eigen::Matrix3d both = Eigen::Matrix3d::Zero();
  double spread = 0;
  for (const Neighbour& near : neighbours) {
    both += weight(near) * (after(near) - mean_after) * (before(near) - mean).transpose();
    spread += weight(near) * (before(near) - mean).squaredNorm();
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> parts(both, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Vector3d size = parts.singularValues();
  if (!(size[1] > least_spread * size[0]) || !(spread > 0)) return std::nullopt;
  const auto turn = [&](double side) -> Eigen::Matrix3d {
    return parts.matrixU() * Eigen::DiagonalMatrix<double, 3>(1, 1, side) * parts.matrixV().transpose();
  };
  const double side = wide(to.normal).dot(turn(1) * wide(from.normal)) < 0 ? -1 : 1;
  const Eigen::Matrix3d turned = turn(side);
  const double scale = (size[0] + size[1] + side * size[2]) / spread;
  const Eigen::Vector3d away = wide(point - samples.before[first]) - mean;
  return Deformed{samples.after[first] + narrow(mean_after + scale * (turned * away)), narrow(turned * wide(normal))};
}

}  // namespace

// A triangle far beside the point would tear the point away from others. So smaller cones are tried until the triangle is
// around the point or nearly so; otherwise the best of all counts.
bool choose_triangle(const Samples& samples, const Vector3f& point, std::span<const Neighbour> neighbours,
                     std::array<std::uint32_t, 3>& triangle) {
  float best = -std::numeric_limits<float>::max();
  std::array<std::uint32_t, 3> tried{};
  bool is_found = false;
  for (const float cosine : cosines) {
    if (!vote(samples, point, neighbours, cosine, tried)) continue;
    const float least = least_coordinate(samples, point, tried);
    if (is_found && !(least > best)) continue;
    best = least;
    triangle = tried;
    is_found = true;
    if (best >= near_inside) break;
  }
  return is_found;
}

// All is relative to the point, so that an edit that moves nothing gives the same bits or nearly so.
Deformed deform(const Samples& samples, const Vector3f& point, const Vector3f& normal,
                std::span<const Neighbour> neighbours) {
  const Vector3f after = samples.after[neighbours[0].index];
  const Vector3f moved = after - samples.before[neighbours[0].index];
  const Plane from = plane_of(neighbours, samples.before, samples.normals, point);
  const Plane to = plane_of(neighbours, samples.after, samples.normals_after, after);
  Deformed result{point + moved, normal};
  std::array<std::uint32_t, 3> triangle{};
  if (is_zero(from.normal) || is_zero(to.normal)) return result;
  // Where no triangle tells how the surface turns, all neighbours or the planes do.
  const auto turned_by_planes = [&] {
    if (from.normal != to.normal && !is_zero(normal)) result.normal = turned_with(from.normal, to.normal, normal);
    return result;
  };
  const auto moved_as_a_whole = [&] {
    const auto is_moved = [&](const Neighbour& near) {
      return samples.after[near.index] - samples.before[near.index] != moved;
    };
    if (std::none_of(neighbours.begin(), neighbours.end(), is_moved)) return turned_by_planes();
    return move_as_a_whole(samples, point, normal, neighbours, from, to).value_or(turned_by_planes());
  };
  if (!choose_triangle(samples, point, neighbours, triangle)) return moved_as_a_whole();
  std::array<Vector3f, 3> flat{}, flat_after{};
  for (std::size_t k = 0; k < 3; ++k) {
    flat[k] = from.project(samples.before[triangle[k]]);
    flat_after[k] = to.project(samples.after[triangle[k]]);
  }
  if (!is_wide(flat, least_flat_height)) return moved_as_a_whole();
  const Vector3f p = from.project(point);
  const Vector3f a = flat[1] - flat[0], b = flat[2] - flat[0], c = p - flat[0];
  const Vector3f n = cross(a, b);
  const float whole = dot(n, n);
  const float u = dot(cross(c, b), n) / whole, v = dot(cross(a, c), n) / whole;
  if (std::min({u, v, 1 - u - v}) < far_outside) return moved_as_a_whole();  // where the surface folds
  const Vector3f a_after = flat_after[1] - flat_after[0], b_after = flat_after[2] - flat_after[0];
  // The thesis scales by the radii of the circumcircles. Those of thin triangles grow without bounds under a shear.
  const Vector3f area = cross(a_after, b_after);
  const float area_square = dot(area, area);
  float scale = std::sqrt(std::sqrt(area_square / whole));
  if (!(scale > 1 / most_usual_scale && scale < most_usual_scale)) {
    const float growth = growth_of(samples, neighbours);
    scale = std::clamp(scale, growth * (1 / most_scale), growth * most_scale);
  }
  const float distance = dot(point - from.centre, from.normal);
  result.position = flat_after[0] + a_after * u + b_after * v + to.normal * (scale * distance);
  // The normal keeps its components along the edges' dual directions and the plane's normal.
  const Vector3f unit_n = unit(n), unit_after = unit(area);
  // At a kink of the edit, a triangle may turn over.
  if (is_zero(normal) || !(dot(n, from.normal) * dot(area, to.normal) > 0)) return turned_by_planes();
  // Covectors: w with w a and w b kept. They turn by the inverse transpose of the triangle's map.
  const float wa = dot(normal, a), wb = dot(normal, b), wn = dot(normal, unit_n);
  const Vector3f dual_a = cross(b_after, area) * (1 / area_square), dual_b = cross(area, a_after) * (1 / area_square);
  result.normal = unit(dual_a * wa + dual_b * wb + unit_after * (wn / scale));
  return result;
}

}  // namespace glark::stream
