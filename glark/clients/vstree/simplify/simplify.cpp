// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "glark/clients/common/mesh/cut_sheets.h"
#include "glark/clients/common/mesh/reindex.h"
#include "glark/clients/common/points/point_set.h"
#include "glark/clients/common/vertex_normals.h"
#include "glark/clients/vstree/simplify/clusters.h"
#include "glark/clients/vstree/simplify/collapse.h"
#include "glark/clients/vstree/simplify/shapes.h"
#include "glark/clients/vstree/simplify/sheets/boundary.h"
#include "glark/clients/vstree/simplify/sheets/components.h"
#include "glark/clients/vstree/simplify/sheets/touching_sheets.h"
#include "glark/clients/vstree/validation.h"

namespace glark::vstree {
namespace {

constexpr float apart = 0.02F;  // how far vertices of touching sheets move, relative to the middle of their triangles

// Returns means of the triangles' normals, weighted by area. They do not have unit length.
std::vector<float> vertex_normals(const Surface& surface) {
  std::vector<float> normals(surface.points.positions.size());
  add_triangle_normals(
      surface.triangles, [&](std::uint32_t vertex) { return surface.point(vertex); },
      [&](std::uint32_t vertex, Float4 normal) {
        for (int k = 0; k < 3; ++k) normals[3 * std::size_t{vertex} + static_cast<std::size_t>(k)] += normal[k];
      });
  return normals;
}

// Writes the mean normal of the samples of each vertex of the result, and their other attributes.
void write_attributes(const Surface& surface, const Clusters& clusters, const Representatives& representatives,
                      std::span<const std::uint32_t> cluster_of, Simplified& result) {
  const PointSet& from = surface.points;
  result.normals.reserve(3 * cluster_of.size());
  for (const std::uint32_t cluster : cluster_of) {
    const Float4 normal = unit(representatives.normals[cluster]);
    result.normals.insert(result.normals.end(), {normal[0], normal[1], normal[2]});
  }
  if (!from.colours.empty()) {
    std::vector<std::array<std::uint64_t, 4>> sums(clusters.count);
    for (std::size_t i = 0; i < clusters.of.size(); ++i) {
      std::array<std::uint64_t, 4>& sum = sums[clusters.of[i]];
      for (std::size_t k = 0; k < 3; ++k) sum[k] += from.colours[3 * i + k];
      ++sum[3];
    }
    for (const std::uint32_t cluster : cluster_of) {
      const std::array<std::uint64_t, 4>& sum = sums[cluster];
      for (std::size_t k = 0; k < 3; ++k)
        result.colours.push_back(static_cast<std::uint8_t>((2 * sum[k] + sum[3]) / (2 * sum[3])));
    }
  }
  if (!from.texcoords.empty()) {
    struct Nearest {
      float square = std::numeric_limits<float>::infinity();
      std::uint32_t sample = 0;
    };
    std::vector<Nearest> nearest(clusters.count);
    for (std::uint32_t i = 0; i < clusters.of.size(); ++i) {
      const Float4 way = surface.point(i) - representatives.points[clusters.of[i]];
      Nearest& best = nearest[clusters.of[i]];
      if (dot(way, way) < best.square) best = {dot(way, way), i};
    }
    for (const std::uint32_t cluster : cluster_of) {
      const float* const texcoord = &from.texcoords[2 * std::size_t{nearest[cluster].sample}];
      result.texcoords.insert(result.texcoords.end(), {texcoord[0], texcoord[1]});
    }
  }
}

// Removes vertices without triangles and renumbers the others. Returns the old number of each remaining vertex.
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

// The vertices of the result: the representatives of clusters, several of a cluster whose sheets are cut apart.
struct Vertices {
  std::vector<std::uint32_t> cluster_of;
  std::vector<Float4> points;  // in the unit cube
  bool is_cut = false;
};

// Cuts sheets that touch, and drops the vertices that no triangle uses.
void cut_and_compact(const Clusters& clusters, bool cut, std::vector<std::uint32_t>& triangles, Vertices& vertices) {
  auto& [cluster_of, points, is_cut] = vertices;
  if (cut) {
    cluster_of = cut_sheets(triangles, points, clusters.irregular);
    for (std::size_t i = points.size(); i < cluster_of.size(); ++i) points.push_back(Float4(points[cluster_of[i]]));
    move_apart(points, triangles, cluster_of, apart);
    is_cut = cluster_of.size() > clusters.count;
  }
  const std::vector<std::uint32_t> kept = compact(triangles, cluster_of.size());
  for (std::size_t i = 0; i < kept.size(); ++i) {  // kept[i] is not below i
    cluster_of[i] = cluster_of[kept[i]];
    points[i] = points[kept[i]];
  }
  cluster_of.resize(kept.size());
  points.resize(kept.size());
}

Simplified cluster_vertices(const Surface& surface, const SimplifyOptions& options, const Workers& workers) {
  const std::span<const std::uint32_t> triangles = surface.triangles;
  Clusters clusters = cluster(surface, options, workers);
  if (!triangles.empty() && clusters.triangles.empty())
    clusters.set_triangles(spanning(triangles, clusters.of, workers));
  if (!clusters.boundary) clusters.boundary = boundary_edges(surface, clusters);
  const Representatives stand = representatives(surface, clusters, options.representative, workers);

  Simplified result;
  Vertices vertices{std::vector<std::uint32_t>(clusters.count), stand.points};
  std::iota(vertices.cluster_of.begin(), vertices.cluster_of.end(), 0U);
  if (!triangles.empty()) {
    result.triangles = std::move(clusters.triangles);
    cut_and_compact(clusters, options.cut, result.triangles, vertices);
  }
  const std::vector<std::uint32_t>& cluster_of = vertices.cluster_of;
  std::vector<std::uint32_t> vertex_of(clusters.count, none);
  for (std::uint32_t i = static_cast<std::uint32_t>(cluster_of.size()); i-- > 0;) vertex_of[cluster_of[i]] = i;
  result.representatives.reserve(clusters.of.size());
  for (const std::uint32_t cluster : clusters.of) result.representatives.push_back(vertex_of[cluster]);
  result.positions.reserve(3 * cluster_of.size());
  for (const Float4& inside : vertices.points) {
    const Float4 point = surface.cube.low + inside * surface.cube.side;
    result.positions.insert(result.positions.end(), {point[0], point[1], point[2]});
  }
  write_attributes(surface, clusters, stand, cluster_of, result);
  if (vertices.is_cut) {
    drop_pinched_off(surface, result);
    drop_unused_vertices(result);
  }
  return result;
}

#if GLARK_HAS_MESHOPTIMIZER
// Whether more edges have more than two triangles than in the surface.
bool adds_crowded_edges(const Surface& surface, const Simplified& result) {
  const std::size_t edges = crowded_edge_count(result.positions, result.triangles);
  return edges > 0 && edges > crowded_edge_count(surface.points.positions, surface.triangles);
}
#else
bool adds_crowded_edges(const Surface&, const Simplified&) { return false; }
#endif

void check(const SimplifyOptions& options) {
  check(Options{.threshold = options.threshold, .delta_a = options.delta_a, .delta_d = options.delta_d});
  if (!(options.max_error >= 0) || options.max_error > 1e18F)
    throw Error(Element::option, 0, "max_error is " + std::to_string(options.max_error) + "; 0 to 1e18 is possible");
  if (options.method == Method::cluster && options.max_error > 0)
    throw Error(Element::option, 0,
                "max_error needs the method collapse; for clusters, use threshold without a target");
}

}  // namespace

Simplified simplify(const Mesh& mesh, const SimplifyOptions& options) {
  const Workers workers(options.threads);
  check(mesh.points, workers);
  check_triangles(mesh.triangles, mesh.points.positions.size() / 3);
  check(options);
  Surface surface{bounding_cube(mesh.points.positions, workers), mesh.points, mesh.triangles};
  std::vector<float> normals;
  if (mesh.points.normals.empty()) {
    normals =
        mesh.triangles.empty() ? estimate_normals(mesh.points, {.threads = options.threads}) : vertex_normals(surface);
    surface.points.normals = normals;
  }
  const bool is_automatic = options.method == Method::automatic;
  std::optional<Simplified> clustered;
  if (method_for(mesh, options) == Method::cluster) {
    clustered = cluster_vertices(surface, options, workers);
    const bool may_collapse = is_automatic && can_collapse(mesh, options);
    if (!may_collapse || !falls_apart(surface, *clustered)) return *std::move(clustered);
  }
  Simplified collapsed = collapse(surface, options);
  if (!is_automatic || options.max_error > 0) return collapsed;
  if (collapsed.triangles.size() / 3 <= options.target) {
    if (!adds_crowded_edges(surface, collapsed)) return collapsed;
    if (!clustered) clustered = cluster_vertices(surface, options, workers);
    const bool is_better = !clustered->triangles.empty() && !adds_crowded_edges(surface, *clustered);
    return is_better && !falls_apart(surface, *clustered) ? *std::move(clustered) : collapsed;
  }
  return clustered ? *std::move(clustered) : cluster_vertices(surface, options, workers);
}

}  // namespace glark::vstree
