// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/reconstruct/mesh/base_mesh.h"

#include <algorithm>
#include <cmath>

#include "glark/clients/common/disjoint_sets.h"
#include "glark/clients/common/mesh/half_edges.h"
#include "glark/clients/common/mesh/reindex.h"
#include "glark/clients/common/vertex_normals.h"
#include "glark/clients/reconstruct/mesh/clean_mesh.h"
#include "glark/clients/reconstruct/mesh/repeated_edges.h"

namespace glark::reconstruct {
namespace {

constexpr std::size_t grain = 1024;
constexpr float seen = 1.1F;  // the maximum distance of a vertex's samples, relative to the side of the finest cells

// Returns the key of the coarse transition node that contains the cell, with the node's height above the finest level
// in the highest bits. Returns 0 if the transition node is on the finest level, or there is none.
std::uint64_t coarse_node_of(std::uint64_t cell, const TransitionLayer& layer) {
  if (layer.cells[0].find(cell) != CellTable::absent) return 0;
  for (std::size_t depth = 1; depth < layer.cells.size(); ++depth) {
    if (layer.cells[depth].find(cell >> (3 * depth)) != CellTable::absent)
      return (cell >> (3 * depth)) | (static_cast<std::uint64_t>(depth) << 60);
  }
  return 0;
}

// Merges vertices that lie on one sheet in one node. Returns whether any were merged.
bool cluster(const Contour& contour, const TransitionLayer& layer, std::vector<Float4>& points,
             std::vector<std::uint32_t>& cluster_of) {
  const std::size_t count = contour.points.size();
  std::vector<std::uint64_t> nodes(count);
  for (std::size_t i = 0; i < count; ++i) nodes[i] = coarse_node_of(contour.cells[i], layer);
  DisjointSets sets(count);
  bool any = false;
  for (std::size_t q = 0; q < contour.quads.size(); q += 4) {
    for (std::size_t i = 0; i < 4; ++i) {
      const std::uint32_t a = contour.quads[q + i], b = contour.quads[q + (i + 1) % 4];
      if (nodes[a] == 0 || nodes[a] != nodes[b]) continue;
      sets.join(a, b);
      any = true;
    }
  }
  cluster_of.resize(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t root = sets.find(i);
    if (root == i) {
      cluster_of[i] = static_cast<std::uint32_t>(points.size());
      points.push_back(Float4{});
    }
    cluster_of[i] = cluster_of[root];
    Float4 point = contour.points[i];
    point[3] = 1;
    points[cluster_of[i]] += point;
  }
  for (Float4& point : points) point = without_fourth(point / point[3]);
  return any;
}

// Divides each quadrilateral by the diagonal across which the halves bend less.
std::vector<std::uint32_t> divide(const std::vector<std::uint32_t>& quads, const std::vector<Float4>& points,
                                  const std::vector<std::uint32_t>& cluster_of) {
  std::vector<std::uint32_t> triangles;
  triangles.reserve(quads.size() / 4 * 6);
  for (std::size_t q = 0; q < quads.size(); q += 4) {
    const std::uint32_t* const v = &quads[q];
    const auto normal = [&](int i, int j, int k) {
      const Float4 a = points[cluster_of[v[i]]];
      return unit(cross(points[cluster_of[v[j]]] - a, points[cluster_of[v[k]]] - a));
    };
    if (dot(normal(0, 1, 2), normal(0, 2, 3)) >= dot(normal(0, 1, 3), normal(1, 2, 3))) {
      triangles.insert(triangles.end(), {v[0], v[1], v[2], v[0], v[2], v[3]});
    } else {
      triangles.insert(triangles.end(), {v[0], v[1], v[3], v[1], v[2], v[3]});
    }
  }
  return triangles;
}

std::vector<Float4> vertex_normals(const BaseMesh& mesh) {
  std::vector<Float4> normals(mesh.points.size());
  add_triangle_normals(
      mesh.triangles, [&](std::uint32_t vertex) { return mesh.points[vertex]; },
      [&](std::uint32_t vertex, Float4 normal) { normals[vertex] += normal; });
  for (Float4& normal : normals) normal = dot(normal, normal) > 0 ? unit(normal) : Float4{0, 0, 1, 0};
  return normals;
}

// Moves the vertices to the samples.
void settle(BaseMesh& mesh, const Octree& octree, const Workers& workers) {
  const float side = octree.finest().side();
  const Float4 reach = Float4{1, 1, 1, 0} * (seen * side);
  mesh.normals = vertex_normals(mesh);
  workers.each(mesh.points.size(), grain, [&](std::size_t begin, std::size_t end) {
    LocalSurface surface(octree);
    for (std::size_t i = begin; i < end; ++i) {
      surface.look_around(mesh.points[i] - reach, mesh.points[i] + reach);
      bool supported = false;
      for (const float radius : {1.0F, 0.7F}) {
        const LocalEstimate estimate = surface.near(mesh.points[i], mesh.normals[i], radius * side);
        if (estimate.opposed) mesh.normals[i][3] = -1;
        if (!estimate.found) continue;
        mesh.points[i] = estimate.point;
        mesh.normals[i] = estimate.normal;
        mesh.normals[i][3] = estimate.near || supported ? 1.0F : 0.0F;
        supported = estimate.near;
      }
    }
  });
}

}  // namespace

BaseMesh base_mesh(const Contour& contour, const TransitionLayer& layer, const Octree& octree,
                   const ReconstructOptions& options, const Workers& workers) {
  BaseMesh mesh;
  std::vector<std::uint32_t> cluster_of;
  const bool clustered = cluster(contour, layer, mesh.points, cluster_of);
  mesh.triangles = divide(contour.quads, mesh.points, cluster_of);
  if (clustered || contour.has_thin_cells) {
    std::vector<std::uint32_t> triangles = spanning(mesh.triangles, cluster_of, workers);
    const std::vector<std::uint8_t> irregular = irregular_vertices(triangles, mesh.points.size());
    mesh.triangles = without_repeats(std::move(triangles), irregular);
  } else {
    for (std::uint32_t& i : mesh.triangles) i = cluster_of[i];
  }
  separate_sheets(mesh);
  if (contour.has_thin_cells && divide_repeated_edges(mesh)) separate_sheets(mesh);
  settle(mesh, octree, workers);
  const auto find_opposite = [&] { mesh.opposite = opposite_of(mesh.triangles, mesh.points.size()); };
  find_opposite();
  if (peel(mesh)) {
    separate_sheets(mesh);
    find_opposite();
  }
  if (close_gaps(mesh, options.gap_edges)) find_opposite();
  if (drop_parts(mesh, options.least_part)) find_opposite();
  return mesh;
}

}  // namespace glark::reconstruct
