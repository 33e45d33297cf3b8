// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/vstree/simplify/collapse.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>

#include "glark/clients/common/mixed_bits.h"
#include "glark/clients/vstree/simplify/touching_sheets.h"
#include "glark/clients/vstree/validation.h"
#if GLARK_HAS_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif

namespace glark::vstree {

Method method_for(const Mesh& mesh, const SimplifyOptions& options) {
  if (mesh.triangles.empty()) return Method::cluster;
  if (options.method != Method::automatic) return options.method;
  const bool is_small = mesh.triangles.size() / 3 < least_to_cluster;
  return can_collapse(mesh, options) && (is_small || options.max_error > 0) ? Method::collapse : Method::cluster;
}

bool can_collapse(const Mesh& mesh, const SimplifyOptions& options) {
  const bool has_goal = options.target != 0 || options.max_error > 0;
  return GLARK_HAS_MESHOPTIMIZER != 0 && !mesh.triangles.empty() && has_goal;
}

#if GLARK_HAS_MESHOPTIMIZER
namespace {

constexpr float little = 1e-5F;  // of the longest side

// Points that differ only in their normals are one vertex.
struct Welded {
  std::vector<std::uint32_t> vertex_of;       // [points]; none if no triangle uses the point
  std::vector<float> positions;               // [3 * vertices]
  std::vector<std::uint32_t> begins, points;  // vertex i has points[begins[i]] .. points[begins[i + 1] - 1]
  std::vector<std::uint32_t> triangles;       // without those that have fewer than three vertices

  explicit Welded(const Surface& surface);
  std::size_t size() const { return positions.size() / 3; }
};

Welded::Welded(const Surface& surface) : vertex_of(surface.size()) {
  const PointSet& from = surface.points;
  std::vector<float> places(from.positions.begin(), from.positions.end());
  for (float& number : places) number += 0.0F;  // -0 becomes 0; bytes are compared
  std::vector<meshopt_Stream> streams{{places.data(), 3 * sizeof(float), 3 * sizeof(float)}};
  if (!from.colours.empty()) streams.push_back({from.colours.data(), 3, 3});
  if (!from.texcoords.empty()) streams.push_back({from.texcoords.data(), 2 * sizeof(float), 2 * sizeof(float)});
  const std::size_t count =
      meshopt_generateVertexRemapMulti(vertex_of.data(), surface.triangles.data(), surface.triangles.size(),
                                       surface.size(), streams.data(), streams.size());
  positions.resize(3 * count);
  begins.resize(count + 1);
  for (const std::uint32_t vertex : vertex_of) {
    if (vertex != none) ++begins[vertex + 1];
  }
  for (std::size_t i = 0; i < count; ++i) begins[i + 1] += begins[i];
  points.resize(begins.back());
  std::vector<std::uint32_t> next(begins.begin(), begins.end() - 1);
  for (std::uint32_t i = 0; i < vertex_of.size(); ++i) {
    if (vertex_of[i] == none) continue;
    points[next[vertex_of[i]]++] = i;
    std::copy_n(&places[3 * std::size_t{i}], 3, &positions[3 * std::size_t{vertex_of[i]}]);
  }
  triangles.reserve(surface.triangles.size());
  for (std::size_t t = 0; t < surface.triangles.size(); t += 3) {
    const std::uint32_t a = vertex_of[surface.triangles[t]], b = vertex_of[surface.triangles[t + 1]];
    const std::uint32_t c = vertex_of[surface.triangles[t + 2]];
    if (a != b && b != c && c != a) triangles.insert(triangles.end(), {a, b, c});
  }
}

// Returns the positions, each moved by less than `most` on each axis. Equal positions move alike. In flat faces, collapses
// cost nothing and make triangles without area, after which meshoptimizer 0.18 does not see that a triangle turns over.
// Among moved points, three are hardly ever on a line.
std::vector<float> moved_a_little(const std::vector<float>& positions, float most) {
  std::vector<float> moved(positions.size());
  for (std::size_t i = 0; i + 2 < positions.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = common::mixed_bits(bits ^ std::bit_cast<std::uint32_t>(positions[i + k]));
    for (std::size_t k = 0; k < 3; ++k) {
      bits = common::mixed_bits(bits + 1);
      const float share = static_cast<float>(bits >> 8) / static_cast<float>(1U << 23) - 1;  // -1 to 1
      moved[i + k] = positions[i + k] + most * share;
    }
  }
  return moved;
}

// Replaces each vertex by one of its points: the first whose normal is nearest to the normal of the triangle.
void choose_points(const Surface& surface, const Welded& welded, std::vector<std::uint32_t>& triangles) {
  for (std::size_t t = 0; t < triangles.size(); t += 3) {
    Float4 corners[3];
    for (std::size_t k = 0; k < 3; ++k) corners[k] = surface.point(welded.points[welded.begins[triangles[t + k]]]);
    const Float4 normal = without_fourth(cross(corners[1] - corners[0], corners[2] - corners[0]));
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t vertex = triangles[t + k];
      float most = -std::numeric_limits<float>::infinity();
      triangles[t + k] = welded.points[welded.begins[vertex]];
      for (std::uint32_t i = welded.begins[vertex]; i < welded.begins[vertex + 1]; ++i) {
        const std::uint32_t point = welded.points[i];
        const float along = dot(without_fourth(unit_normal(&surface.points.normals[3 * std::size_t{point}])), normal);
        if (along <= most) continue;
        most = along;
        triangles[t + k] = point;
      }
    }
  }
}

template <typename Number>
std::vector<Number> chosen(std::span<const Number> all, std::span<const std::uint32_t> points, std::size_t size) {
  std::vector<Number> result;
  if (all.empty()) return result;
  result.reserve(size * points.size());
  for (const std::uint32_t point : points) result.insert(result.end(), &all[size * point], &all[size * point] + size);
  return result;
}

// Keeps the points of the surface that the triangles use, in their order.
Simplified with_used_points(const Surface& surface, std::vector<std::uint32_t> triangles) {
  Simplified result;
  result.representatives.assign(surface.size(), none);
  for (const std::uint32_t i : triangles) result.representatives[i] = 0;
  std::vector<std::uint32_t> kept;
  for (std::uint32_t i = 0; i < surface.size(); ++i) {
    if (result.representatives[i] == none) continue;
    result.representatives[i] = static_cast<std::uint32_t>(kept.size());
    kept.push_back(i);
  }
  for (std::uint32_t& i : triangles) i = result.representatives[i];
  result.triangles = std::move(triangles);
  result.positions = chosen(surface.points.positions, kept, 3);
  result.normals.reserve(3 * kept.size());
  for (const std::uint32_t i : kept) {
    const Float4 normal = unit_normal(&surface.points.normals[3 * std::size_t{i}]);
    result.normals.insert(result.normals.end(), {normal[0], normal[1], normal[2]});
  }
  result.colours = chosen(surface.points.colours, kept, 3);
  result.texcoords = chosen(surface.points.texcoords, kept, 2);
  return result;
}

Simplified whole(const Surface& surface) {
  std::vector<std::uint32_t> all(surface.size());
  std::iota(all.begin(), all.end(), 0U);
  Simplified result = with_used_points(surface, std::move(all));
  result.triangles.assign(surface.triangles.begin(), surface.triangles.end());
  result.method = Method::collapse;
  return result;
}

}  // namespace

Simplified collapse(const Surface& surface, const SimplifyOptions& options) {
  if (options.max_error == 0 && options.target >= surface.triangles.size() / 3) return whole(surface);
  const Welded welded(surface);
  const float most_error = options.max_error > 0 || options.target > 0 ? options.max_error : options.threshold;
  // meshoptimizer's errors are relative to the longest side of the bounding box.
  const float side = meshopt_simplifyScale(welded.positions.data(), welded.size(), 3 * sizeof(float));
  const float to_diagonal = side / (surface.cube.diagonal * surface.cube.side);
  const std::vector<float> positions = moved_a_little(welded.positions, little * side);
  const bool has_limit = most_error > 0 || options.target == 0;
  const std::size_t target = std::min(3 * options.target, welded.triangles.size());
  std::vector<std::uint32_t> triangles(welded.triangles.size());
  float error = 0;
  triangles.resize(meshopt_simplify(triangles.data(), welded.triangles.data(), welded.triangles.size(),
                                    positions.data(), welded.size(), 3 * sizeof(float), target,
                                    has_limit ? most_error / to_diagonal : 1e9F, 0, &error));
  choose_points(surface, welded, triangles);
  Simplified result = with_used_points(surface, std::move(triangles));
  result.method = Method::collapse;
  result.error = error * to_diagonal;
  part_touching_sheets(surface, result);
  return result;
}

#else

Simplified collapse(const Surface&, const SimplifyOptions&) {
  throw Error(
      Element::option, 0,
      "method is collapse, but this build has no meshoptimizer; use cluster, or build with libmeshoptimizer-dev");
}

#endif

}  // namespace glark::vstree
