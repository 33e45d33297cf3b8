// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/transfer/deformation.h"

#include <algorithm>
#include <cmath>
#include <limits>

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
constexpr float most_scale = 8;             // of the distance from the plane
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

// The rotation about the axis of both, which takes `from` to `to`, applied to v. For unit vectors. Source: Rodrigues.
Vector3f turned_with(const Vector3f& from, const Vector3f& to, const Vector3f& v) {
  const Vector3f axis = cross(from, to);
  const float cosine = dot(from, to);
  if (!(cosine > -0.999F)) return v * -1.0F;
  return unit(v * cosine + cross(axis, v) + axis * (dot(axis, v) / (1 + cosine)));
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
  const Plane from = plane_of(neighbours, samples.before, samples.normals, point);
  const Plane to = plane_of(neighbours, samples.after, samples.normals_after, after);
  Deformed result{point + (after - samples.before[neighbours[0].index]), normal};
  std::array<std::uint32_t, 3> triangle{};
  if (is_zero(from.normal) || is_zero(to.normal)) return result;
  // Where no triangle tells how the surface turns, the planes do.
  const auto turned_by_planes = [&] {
    if (from.normal != to.normal && !is_zero(normal)) result.normal = turned_with(from.normal, to.normal, normal);
    return result;
  };
  if (!choose_triangle(samples, point, neighbours, triangle)) return turned_by_planes();
  std::array<Vector3f, 3> flat{}, flat_after{};
  for (std::size_t k = 0; k < 3; ++k) {
    flat[k] = from.project(samples.before[triangle[k]]);
    flat_after[k] = to.project(samples.after[triangle[k]]);
  }
  if (!is_wide(flat, least_flat_height)) return turned_by_planes();
  const Vector3f p = from.project(point);
  const Vector3f a = flat[1] - flat[0], b = flat[2] - flat[0], c = p - flat[0];
  const Vector3f n = cross(a, b);
  const float whole = dot(n, n);
  const float u = dot(cross(c, b), n) / whole, v = dot(cross(a, c), n) / whole;
  if (std::min({u, v, 1 - u - v}) < far_outside) return turned_by_planes();  // where the surface folds
  const Vector3f a_after = flat_after[1] - flat_after[0], b_after = flat_after[2] - flat_after[0];
  // The thesis scales by the radii of the circumcircles. Those of thin triangles grow without bounds under a shear.
  const Vector3f area = cross(a_after, b_after);
  const float area_square = dot(area, area);
  const float scale = std::clamp(std::sqrt(std::sqrt(area_square / whole)), 1 / most_scale, most_scale);
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
