// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/reconstruct/mesh/clean_mesh.h"

#include <cmath>
#include <utility>

#include "glark/clients/common/disjoint_sets.h"
#include "glark/clients/common/mesh/cut_sheets.h"
#include "glark/clients/common/mesh/half_edges.h"
#include "glark/clients/common/mesh/reindex.h"

namespace glark::reconstruct {
namespace {

// The share of the way that a shared vertex moves towards the middle of its sheet's triangles.
constexpr float apart = 0.25F;

// Keeps the triangles that are not gone. Returns whether any are gone.
bool keep(BaseMesh& mesh, const std::vector<bool>& gone) {
  std::vector<std::uint32_t> kept;
  for (std::size_t t = 0; t < gone.size(); ++t) {
    if (!gone[t]) kept.insert(kept.end(), &mesh.triangles[3 * t], &mesh.triangles[3 * t] + 3);
  }
  const bool changed = kept.size() < mesh.triangles.size();
  mesh.triangles = std::move(kept);
  return changed;
}

// Marks ears: triangles that are connected by at most one edge. Runs twice, because removing ears may uncover others.
void mark_ears(const BaseMesh& mesh, std::vector<bool>& gone) {
  for (int round = 0; round < 2; ++round) {
    std::vector<std::uint32_t> ears;
    for (std::uint32_t t = 0; t < gone.size(); ++t) {
      int edges = 0;
      for (std::uint32_t i = 3 * t; i < 3 * t + 3; ++i)
        edges += mesh.opposite[i] == no_half_edge || gone[mesh.opposite[i] / 3] ? 1 : 0;
      if (!gone[t] && edges > 1) ears.push_back(t);
    }
    for (const std::uint32_t t : ears) gone[t] = true;
  }
}

void drop_unused_vertices(BaseMesh& mesh) {
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
}

}  // namespace

void separate_sheets(BaseMesh& mesh) {
  const std::size_t count = mesh.points.size();
  const std::vector<std::uint32_t> copies =
      cut_sheets(mesh.triangles, mesh.points, irregular_vertices(mesh.triangles, mesh.points.size()));
  if (copies.size() == count) return;
  for (std::size_t i = count; i < copies.size(); ++i) {
    mesh.points.push_back(Float4(mesh.points[copies[i]]));
    if (!mesh.normals.empty()) mesh.normals.push_back(Float4(mesh.normals[copies[i]]));
  }
  move_apart(mesh.points, mesh.triangles, copies, apart);
}

bool peel(BaseMesh& mesh) {
  const std::vector<std::uint32_t>& opposite = mesh.opposite;
  std::vector<bool> gone(mesh.triangles.size() / 3);
  std::vector<std::uint32_t> at_boundary;
  const auto visit = [&](std::uint32_t t) {
    bool far = false;
    for (std::uint32_t i = 3 * t; i < 3 * t + 3; ++i) far |= mesh.normals[mesh.triangles[i]][3] <= 0;
    if (!far || gone[t]) return;
    gone[t] = true;
    at_boundary.push_back(t);
  };
  for (std::uint32_t i = 0; i < opposite.size(); ++i) {
    if (opposite[i] == no_half_edge || mesh.normals[mesh.triangles[i]][3] < 0) visit(i / 3);
  }
  while (!at_boundary.empty()) {
    const std::uint32_t t = at_boundary.back();
    at_boundary.pop_back();
    for (std::uint32_t i = 3 * t; i < 3 * t + 3; ++i) {
      if (opposite[i] != no_half_edge) visit(opposite[i] / 3);
    }
  }
  mark_ears(mesh, gone);
  return keep(mesh, gone);
}

bool close_gaps(BaseMesh& mesh, std::uint32_t most_edges) {
  const std::vector<std::uint32_t>& opposite = mesh.opposite;
  const std::size_t before = mesh.triangles.size();
  std::vector<std::uint32_t> boundary(mesh.points.size(),
                                      none);  // for each vertex, the boundary half-edge that ends there
  for (std::uint32_t i = 0; i < opposite.size(); ++i) {
    if (opposite[i] == no_half_edge) boundary[mesh.triangles[next_corner(i)]] = i;
  }
  std::vector<std::uint32_t> loop;
  for (std::uint32_t start = 0; start < boundary.size(); ++start) {
    loop.clear();
    for (std::uint32_t at = start; boundary[at] != none; at = loop.back()) {
      loop.push_back(mesh.triangles[boundary[at]]);
      if (loop.back() == start || loop.size() > most_edges) break;
    }
    if (loop.size() < 3 || loop.back() != start) continue;
    Float4 middle{}, normal{};
    for (const std::uint32_t i : loop) {
      middle += mesh.points[i];
      normal += without_fourth(mesh.normals[i]);
      boundary[i] = none;
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
  for (const double area : areas) {
    if (area <= 0 || area >= static_cast<double>(least_part) * all) continue;
    ++mesh.left_out;
    mesh.area_left_out += static_cast<float>(area / all);
  }
  const bool changed = kept.size() < mesh.triangles.size();
  mesh.triangles = std::move(kept);
  drop_unused_vertices(mesh);
  return changed;
}

}  // namespace glark::reconstruct
