// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/reconstruct/base_mesh.h"

#include <algorithm>
#include <cmath>

#include "glark/clients/common/disjoint_sets.h"
#include "glark/clients/reconstruct/half_edges.h"
#include "glark/clients/vstree/reindex.h"

namespace glark::vstree {
namespace {

constexpr std::size_t grain = 1024;
constexpr float apart = 0.25F;  // of the way from a vertex that sheets share to the middle of the triangles of each
constexpr float seen = 1.1F;    // around a vertex that settles, by the side of the finest cells

// The transition node coarser than the grid that the cell lies in: its key with its level in the highest bits; 0 if there is none.
std::uint64_t coarse_node_of(std::uint64_t cell, const TransitionLayer& layer) {
  if (layer.cells[0].find(cell) != CellTable::absent) return 0;
  for (std::size_t depth = 1; depth < layer.cells.size(); ++depth) {
    if (layer.cells[depth].find(cell >> (3 * depth)) != CellTable::absent)
      return (cell >> (3 * depth)) | (static_cast<std::uint64_t>(depth) << 60);
  }
  return 0;
}

// One vertex for those of a sheet in a node; gives whether there were any to put together.
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

// By the diagonal across which the halves bend less.
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

std::vector<Float4> triangle_normals(const BaseMesh& mesh) {
  std::vector<Float4> normals(mesh.points.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    const std::uint32_t* const v = &mesh.triangles[t];
    const Float4 normal = cross(mesh.points[v[1]] - mesh.points[v[0]], mesh.points[v[2]] - mesh.points[v[0]]);
    for (int i = 0; i < 3; ++i) normals[v[i]] += normal;
  }
  for (Float4& normal : normals) normal = dot(normal, normal) > 0 ? unit(normal) : Float4{0, 0, 1, 0};
  return normals;
}

// Moves the vertices to the samples.
void settle(BaseMesh& mesh, const Octree& octree, const Workers& workers) {
  const float side = octree.finest().side();
  const Float4 reach = Float4{1, 1, 1, 0} * (seen * side);
  mesh.normals = triangle_normals(mesh);
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

// Returns whether it takes any: triangles from the border inwards that have a vertex far from all samples: there the planes only go on beyond the last of
// these. Such triangles within the surface close a gap.
// Between two sheets that both face one way there is a surface that faces the other: it goes too. So does what only hangs on by one edge.
bool peel(BaseMesh& mesh) {
  const std::vector<std::uint32_t>& opposite = mesh.opposite;
  const std::size_t count = mesh.triangles.size() / 3;
  std::vector<bool> gone(count);
  std::vector<std::uint32_t> at_border;
  const auto visit = [&](std::uint32_t t) {
    bool far = false;
    for (std::uint32_t i = 3 * t; i < 3 * t + 3; ++i) far |= mesh.normals[mesh.triangles[i]][3] <= 0;
    if (!far || gone[t]) return;
    gone[t] = true;
    at_border.push_back(t);
  };
  for (std::uint32_t i = 0; i < opposite.size(); ++i) {
    if (opposite[i] == none || mesh.normals[mesh.triangles[i]][3] < 0) visit(i / 3);
  }
  while (!at_border.empty()) {
    const std::uint32_t t = at_border.back();
    at_border.pop_back();
    for (std::uint32_t i = 3 * t; i < 3 * t + 3; ++i) {
      if (opposite[i] != none) visit(opposite[i] / 3);
    }
  }
  for (int round = 0; round < 2; ++round) {
    std::vector<std::uint32_t> ears;
    for (std::uint32_t t = 0; t < count; ++t) {
      int edges = 0;
      for (std::uint32_t i = 3 * t; i < 3 * t + 3; ++i) edges += opposite[i] == none || gone[opposite[i] / 3] ? 1 : 0;
      if (!gone[t] && edges > 1) ears.push_back(t);
    }
    for (const std::uint32_t t : ears) gone[t] = true;
  }
  std::vector<std::uint32_t> kept;
  for (std::size_t t = 0; t < count; ++t) {
    if (!gone[t]) kept.insert(kept.end(), &mesh.triangles[3 * t], &mesh.triangles[3 * t] + 3);
  }
  const bool changed = kept.size() < mesh.triangles.size();
  mesh.triangles = std::move(kept);
  return changed;
}

// Returns whether there are any: a fan of triangles in each hole with a border of so few edges.
bool close_gaps(BaseMesh& mesh, std::uint32_t most_edges) {
  const std::vector<std::uint32_t>& opposite = mesh.opposite;
  const std::size_t before = mesh.triangles.size();
  std::vector<std::uint32_t> border(mesh.points.size(), none);  // of a vertex on one the half-edge that ends there
  for (std::uint32_t i = 0; i < opposite.size(); ++i) {
    if (opposite[i] == none) border[mesh.triangles[next_corner(i)]] = i;
  }
  std::vector<std::uint32_t> loop;
  for (std::uint32_t start = 0; start < border.size(); ++start) {
    loop.clear();
    for (std::uint32_t at = start; border[at] != none; at = loop.back()) {
      loop.push_back(mesh.triangles[border[at]]);
      if (loop.back() == start || loop.size() > most_edges) break;
    }
    if (loop.size() < 3 || loop.back() != start) continue;
    Float4 middle{}, normal{};
    for (const std::uint32_t i : loop) {
      middle += mesh.points[i];
      normal += without_fourth(mesh.normals[i]);
      border[i] = none;
    }
    const auto centre = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.push_back(Float4(middle / static_cast<float>(loop.size())));
    mesh.normals.push_back(dot(normal, normal) > 0 ? unit(normal) : Float4{0, 0, 1, 0});
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::uint32_t next = loop[(i + 1) % loop.size()];
      mesh.triangles.insert(mesh.triangles.end(), {loop[i], next, centre});
    }
  }
  return mesh.triangles.size() > before;
}

// What was one vertex of several sheets becomes one for each, a little towards its own neighbours.
void cut_sheets(BaseMesh& mesh) {
  const std::size_t count = mesh.points.size();
  const std::vector<std::uint32_t> copies =
      cut(mesh.triangles, mesh.points, irregular_vertices(mesh.triangles, mesh.points.size()));
  if (copies.size() == count) return;
  std::vector<bool> shared(copies.size());
  for (std::size_t i = count; i < copies.size(); ++i) {
    shared[i] = shared[copies[i]] = true;
    mesh.points.push_back(Float4(mesh.points[copies[i]]));
    if (!mesh.normals.empty()) mesh.normals.push_back(Float4(mesh.normals[copies[i]]));
  }
  std::vector<Float4> sums(copies.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    const std::uint32_t* const v = &mesh.triangles[t];
    Float4 middle = (mesh.points[v[0]] + mesh.points[v[1]] + mesh.points[v[2]]) / 3;
    middle[3] = 1;
    for (int i = 0; i < 3; ++i) sums[v[i]] += middle;
  }
  for (std::size_t i = 0; i < copies.size(); ++i) {
    if (shared[i] && sums[i][3] > 0) mesh.points[i] += (without_fourth(sums[i] / sums[i][3]) - mesh.points[i]) * apart;
  }
}

// Leaves out the parts that are small, and numbers the vertices that stay.
bool drop_parts(BaseMesh& mesh, float least_part) {
  DisjointSets sets(mesh.points.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    sets.join(mesh.triangles[t], mesh.triangles[t + 1]);
    sets.join(mesh.triangles[t], mesh.triangles[t + 2]);
  }
  std::vector<double> areas(mesh.points.size());
  double all = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    const Float4 a = mesh.points[mesh.triangles[t]];
    const Float4 normal = cross(mesh.points[mesh.triangles[t + 1]] - a, mesh.points[mesh.triangles[t + 2]] - a);
    const double area = std::sqrt(static_cast<double>(dot(normal, normal)));
    areas[sets.find(mesh.triangles[t])] += area;
    all += area;
  }
  std::vector<std::uint32_t> kept;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    if (areas[sets.find(mesh.triangles[t])] < static_cast<double>(least_part) * all) continue;
    kept.insert(kept.end(), &mesh.triangles[t], &mesh.triangles[t] + 3);
  }
  for (std::uint32_t i = 0; i < areas.size(); ++i)
    mesh.left_out += areas[i] > 0 && areas[i] < static_cast<double>(least_part) * all ? 1 : 0;
  const bool changed = kept.size() < mesh.triangles.size();
  mesh.triangles = std::move(kept);
  std::vector<std::uint32_t> number(mesh.points.size(), none);
  std::vector<Float4> points, normals;
  for (std::uint32_t& i : mesh.triangles) {
    if (number[i] == none) {
      number[i] = static_cast<std::uint32_t>(points.size());
      points.push_back(mesh.points[i]);
      normals.push_back(mesh.normals[i]);
    }
    i = number[i];
  }
  mesh.points = std::move(points);
  mesh.normals = std::move(normals);
  return changed;
}

}  // namespace

BaseMesh base_mesh(const Contour& contour, const TransitionLayer& layer, const Octree& octree,
                   const ReconstructOptions& options, const Workers& workers) {
  BaseMesh mesh;
  std::vector<std::uint32_t> cluster_of;
  const bool clustered = cluster(contour, layer, mesh.points, cluster_of);
  mesh.triangles = divide(contour.quads, mesh.points, cluster_of);
  if (clustered) {
    std::vector<std::uint32_t> triangles = spanning(mesh.triangles, cluster_of, workers);
    const std::vector<std::uint8_t> irregular = irregular_vertices(triangles, mesh.points.size());
    mesh.triangles = without_repeats(std::move(triangles), irregular);
  } else {
    for (std::uint32_t& i : mesh.triangles) i = cluster_of[i];
  }
  cut_sheets(mesh);
  settle(mesh, octree, workers);
  const auto find_opposite = [&] { mesh.opposite = opposite_of(mesh.triangles, mesh.points.size()); };
  find_opposite();
  if (peel(mesh)) {
    cut_sheets(mesh);
    find_opposite();
  }
  if (close_gaps(mesh, options.gap_edges)) find_opposite();
  if (drop_parts(mesh, options.least_part)) find_opposite();
  return mesh;
}

}  // namespace glark::vstree
