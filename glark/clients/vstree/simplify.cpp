// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "glark/clients/vstree/clusters.h"
#include "glark/clients/vstree/reindex.h"
#include "glark/clients/vstree/samples.h"
#include "glark/clients/vstree/shapes.h"

namespace glark::vstree {
namespace {

// Area-weighted means of the triangles' normals, not of unit length.
std::vector<float> vertex_normals(const Surface& surface) {
  std::vector<float> normals(surface.points.positions.size());
  for (std::size_t t = 0; t < surface.triangles.size(); t += 3) {
    const std::uint32_t* const corners = &surface.triangles[t];
    const Float4 a = surface.point(corners[0]);
    const Float4 normal = cross(surface.point(corners[1]) - a, surface.point(corners[2]) - a);
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) normals[3 * std::size_t{corners[i]} + k] += normal[k];
    }
  }
  return normals;
}

// Of each cluster: the mean normal, and what else the samples have.
void write_attributes(const Surface& surface, const Clusters& clusters, std::span<const Float4> points,
                      std::span<const std::uint32_t> cluster_of, const Workers& workers, Simplified& result) {
  const PointSet& from = surface.points;
  result.normals.resize(3 * cluster_of.size());
  result.colours.resize(from.colours.empty() ? 0 : 3 * cluster_of.size());
  result.texcoords.resize(from.texcoords.empty() ? 0 : 2 * cluster_of.size());
  workers.each(cluster_of.size(), 1 << 10, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::span<const Record> samples = clusters.samples(cluster_of[i]);
      Float4 normal{}, colour{};
      for (const Record& sample : samples) normal += sample.normal;
      normal = unit(normal);
      for (std::size_t k = 0; k < 3; ++k) result.normals[3 * i + k] = normal[k];
      if (!from.colours.empty()) {
        for (const Record& sample : samples) {
          const std::uint8_t* const mine = &from.colours[3 * std::size_t{sample.index()}];
          colour += Float4{static_cast<float>(mine[0]), static_cast<float>(mine[1]), static_cast<float>(mine[2]), 1};
        }
        for (std::size_t k = 0; k < 3; ++k)
          result.colours[3 * i + k] = static_cast<std::uint8_t>(colour[k] / colour[3] + 0.5F);
      }
      if (!from.texcoords.empty()) {
        const auto rank = [&](const Record& sample) {
          const Float4 apart = sample.point() - points[cluster_of[i]];
          return std::pair(dot(apart, apart), sample.index());
        };
        const std::size_t nearest =
            std::min_element(samples.begin(), samples.end(), [&](const Record& a, const Record& b) {
              return rank(a) < rank(b);
            })->index();
        for (std::size_t k = 0; k < 2; ++k) result.texcoords[2 * i + k] = from.texcoords[2 * nearest + k];
      }
    }
  });
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
  Surface surface{bounding_cube(mesh.points.positions, workers), mesh.points, mesh.triangles};
  std::vector<float> normals;
  if (mesh.points.normals.empty()) {
    normals =
        mesh.triangles.empty() ? estimate_normals(mesh.points, {.threads = options.threads}) : vertex_normals(surface);
    surface.points.normals = normals;
  }
  Clusters clusters = cluster(surface, options, workers);
  const std::vector<Float4> points = representatives(surface, clusters, options.representative, workers);

  Simplified result;
  std::vector<std::uint32_t> cluster_of(clusters.count);  // of each vertex of the result
  for (std::uint32_t i = 0; i < clusters.count; ++i) cluster_of[i] = i;
  if (!mesh.triangles.empty()) {
    result.triangles = clusters.triangles.empty()
                           ? without_repeats(spanning(mesh.triangles, clusters.of, workers), clusters.count)
                           : std::move(clusters.triangles);
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
  result.positions.reserve(3 * cluster_of.size());
  for (const std::uint32_t cluster : cluster_of) {
    const Float4 point = surface.cube.low + points[cluster] * surface.cube.side;
    result.positions.insert(result.positions.end(), {point[0], point[1], point[2]});
  }
  write_attributes(surface, clusters, points, cluster_of, workers, result);
  return result;
}

}  // namespace glark::vstree
