// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "glark/clients/vstree/clusters.h"
#include "glark/clients/vstree/reindex.h"
#include "glark/clients/vstree/samples.h"

namespace glark::vstree {
namespace {

// Area-weighted means of the triangles' normals.
std::vector<Float4> vertex_normals(const Surface& surface) {
  std::vector<Float4> normals(surface.points.size());
  for (std::size_t t = 0; t < surface.triangles.size(); t += 3) {
    const std::uint32_t* const corners = &surface.triangles[t];
    const Float4 a = surface.points[corners[0]];
    const Float4 normal = cross(surface.points[corners[1]] - a, surface.points[corners[2]] - a);
    for (int i = 0; i < 3; ++i) normals[corners[i]] += normal;
  }
  for (Float4& normal : normals) {
    normal = unit(normal);
    normal[3] = dot(normal, normal) > 0 ? 1.0F : 0.0F;
  }
  return normals;
}

Surface surface_of(const Mesh& mesh, const SimplifyOptions& options, const Workers& workers) {
  Surface surface;
  surface.cube = bounding_cube(mesh.points.positions, workers);
  surface.triangles = mesh.triangles;
  const std::size_t count = mesh.points.positions.size() / 3;
  surface.points.resize(count);
  for (std::size_t i = 0; i < count; ++i) surface.points[i] = surface.cube.inside(&mesh.points.positions[3 * i]);
  std::span<const float> normals = mesh.points.normals;
  std::vector<float> estimated;
  if (normals.empty() && !mesh.triangles.empty()) {
    surface.normals = vertex_normals(surface);
    return surface;
  }
  if (normals.empty()) {
    estimated = estimate_normals(mesh.points, {.threads = options.threads});
    normals = estimated;
  }
  surface.normals.resize(count);
  for (std::size_t i = 0; i < count; ++i) surface.normals[i] = unit_normal(&normals[3 * i]);
  return surface;
}

// What stands for each cluster, in the unit cube.
std::vector<Float4> representatives(const Surface& surface, Clusters& clusters, Representative how) {
  if (clusters.shapes.empty()) clusters.shapes = shapes_of(surface, clusters.of, clusters.count);
  std::vector<Float4> points;
  points.reserve(clusters.count);
  for (const Shape& shape : clusters.shapes)
    points.push_back(how == Representative::qef ? shape.centroid() + shape.best_step() : shape.centroid());
  return points;
}

void write_attributes(const Mesh& mesh, const Surface& surface, const Clusters& clusters,
                      std::span<const Float4> points, std::span<const std::uint32_t> cluster_of, Simplified& result) {
  std::vector<Float4> normals(clusters.count), colours(mesh.points.colours.empty() ? 0 : clusters.count);
  std::vector<std::uint32_t> nearest(mesh.points.texcoords.empty() ? 0 : clusters.count, none);
  const auto squared = [&](std::uint32_t sample, std::uint32_t cluster) {
    const Float4 d = surface.points[sample] - points[cluster];
    return dot(d, d);
  };
  for (std::uint32_t i = 0; i < clusters.of.size(); ++i) {
    const std::uint32_t cluster = clusters.of[i];
    normals[cluster] += surface.normals[i];
    if (!colours.empty()) {
      const std::uint8_t* const colour = &mesh.points.colours[3 * std::size_t{i}];
      colours[cluster] +=
          Float4{static_cast<float>(colour[0]), static_cast<float>(colour[1]), static_cast<float>(colour[2]), 1};
    }
    if (!nearest.empty() && (nearest[cluster] == none || squared(i, cluster) < squared(nearest[cluster], cluster)))
      nearest[cluster] = i;
  }
  for (const std::uint32_t cluster : cluster_of) {
    const Float4 normal = unit(normals[cluster]);
    result.normals.insert(result.normals.end(), {normal[0], normal[1], normal[2]});
    for (int k = 0; k < 3 && !colours.empty(); ++k)
      result.colours.push_back(static_cast<std::uint8_t>(colours[cluster][k] / colours[cluster][3] + 0.5F));
    for (std::size_t k = 0; k < 2 && !nearest.empty(); ++k)
      result.texcoords.push_back(mesh.points.texcoords[2 * std::size_t{nearest[cluster]} + k]);
  }
}

// Leaves out what no triangle uses. Returns of each vertex that stays which one it was.
std::vector<std::uint32_t> compact(std::vector<std::uint32_t>& triangles, std::size_t count) {
  std::vector<std::uint32_t> number(count, none), kept;
  for (const std::uint32_t i : triangles) number[i] = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (number[i] == none) continue;
    number[i] = static_cast<std::uint32_t>(kept.size());
    kept.push_back(i);
  }
  for (std::uint32_t& i : triangles) i = number[i];
  return kept;
}

}  // namespace

Simplified simplify(const Mesh& mesh, const SimplifyOptions& options) {
  const Workers workers(options.threads);
  check(mesh.points, workers);
  check_triangles(mesh.triangles, mesh.points.positions.size() / 3);
  check(Options{.threshold = options.threshold, .delta_a = options.delta_a, .delta_d = options.delta_d});
  const Surface surface = surface_of(mesh, options, workers);
  Clusters clusters = cluster(surface, options, workers);
  const std::vector<Float4> points = representatives(surface, clusters, options.representative);

  Simplified result;
  std::vector<std::uint32_t> cluster_of(clusters.count);  // of each vertex of the result
  for (std::uint32_t i = 0; i < clusters.count; ++i) cluster_of[i] = i;
  if (!mesh.triangles.empty()) {
    result.triangles = reindex(mesh.triangles, clusters.of, clusters.count);
    if (options.cut) cluster_of = cut(result.triangles, points);
    const std::vector<std::uint32_t> kept = compact(result.triangles, cluster_of.size());
    std::vector<std::uint32_t> compacted(kept.size());
    for (std::size_t i = 0; i < kept.size(); ++i) compacted[i] = cluster_of[kept[i]];
    cluster_of = std::move(compacted);
  }
  std::vector<std::uint32_t> vertex_of(clusters.count, none);
  for (std::uint32_t i = static_cast<std::uint32_t>(cluster_of.size()); i-- > 0;) vertex_of[cluster_of[i]] = i;
  result.representatives.reserve(clusters.of.size());
  for (const std::uint32_t cluster : clusters.of) result.representatives.push_back(vertex_of[cluster]);
  for (const std::uint32_t cluster : cluster_of) {
    const Float4 point = surface.cube.low + points[cluster] * surface.cube.side;
    result.positions.insert(result.positions.end(), {point[0], point[1], point[2]});
  }
  write_attributes(mesh, surface, clusters, points, cluster_of, result);
  return result;
}

}  // namespace glark::vstree
