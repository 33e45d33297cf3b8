// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/charts/surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace glark::maps {
namespace {

using common::unit;

constexpr float largest = 1e18F;

void require(const CoarseMesh& mesh) {
  if (mesh.positions.size() % 3 != 0)
    throw Error(Element::array, 0,
                fmt::format("the coarse mesh has {} coordinates; give three for each vertex", mesh.positions.size()));
  if (!mesh.normals.empty() && mesh.normals.size() != mesh.positions.size())
    throw Error(Element::array, 0,
                fmt::format("the coarse mesh has {} coordinates and {} of normals; give as many, or none",
                            mesh.positions.size(), mesh.normals.size()));
  if (!mesh.texcoords.empty() && 3 * mesh.texcoords.size() != 2 * mesh.positions.size())
    throw Error(
        Element::array, 0,
        fmt::format("the coarse mesh has {} numbers of texture coordinates; give two for each of its {} vertices, "
                    "or none",
                    mesh.texcoords.size(), mesh.positions.size() / 3));
  if (mesh.triangles.size() % 3 != 0)
    throw Error(Element::array, 0,
                fmt::format("the coarse mesh has {} indices; give three for each triangle", mesh.triangles.size()));
  if (mesh.triangles.empty())
    throw Error(Element::array, 0, "the coarse mesh has no triangles; maps need a surface to lie on");
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const bool is_usable =
        std::abs(mesh.positions[i]) <= largest && (mesh.normals.empty() || std::isfinite(mesh.normals[i]));
    if (!is_usable)
      throw Error(Element::point, i / 3,
                  "of the coarse mesh has a coordinate or normal that is not finite or above 1e18; remove it");
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (mesh.triangles[i] >= mesh.positions.size() / 3)
      throw Error(Element::triangle, i / 3,
                  fmt::format("of the coarse mesh has the vertex {}, but there are {}", mesh.triangles[i],
                              mesh.positions.size() / 3));
  }
}

Vector vector_at(std::span<const float> values, std::size_t index) {
  return {values[3 * index], values[3 * index + 1], values[3 * index + 2]};
}

// Returns the new vertex of each vertex of the mesh. Vertices at one position become one.
std::vector<std::uint32_t> weld(const CoarseMesh& mesh, std::vector<Vector>& positions) {
  std::vector<std::uint32_t> order(mesh.positions.size() / 3);
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [&](std::uint32_t i) {
    const Vector p = vector_at(mesh.positions, i);
    return std::tuple(p.x, p.y, p.z);
  };
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  std::vector<std::uint32_t> first(order.size());  // the first vertex at the position of each
  for (std::size_t i = 0; i < order.size(); ++i)
    first[order[i]] = i > 0 && key(order[i]) == key(order[i - 1]) ? first[order[i - 1]] : order[i];
  std::vector<std::uint32_t> welded(order.size());
  for (std::uint32_t i = 0; i < first.size(); ++i) {
    if (first[i] == i) {
      welded[i] = static_cast<std::uint32_t>(positions.size());
      positions.push_back(vector_at(mesh.positions, i));
    } else {
      welded[i] = welded[first[i]];
    }
  }
  return welded;
}

void add_neighbours(Surface& surface) {
  struct Edge {
    std::uint32_t low, high, triangle, side;
  };
  std::vector<Edge> edges;
  edges.reserve(3 * surface.triangles.size());
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t a = surface.triangles[t][k];
      const std::uint32_t b = surface.triangles[t][(k + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b), t, k});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return std::tie(a.low, a.high, a.triangle, a.side) < std::tie(b.low, b.high, b.triangle, b.side);
  });
  surface.neighbours.assign(surface.triangles.size(), {none, none, none});
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const Edge& a = edges[i];
    const Edge& b = edges[i + 1];
    if (a.low != b.low || a.high != b.high || surface.neighbours[a.triangle][a.side] != none) continue;
    surface.neighbours[a.triangle][a.side] = b.triangle;
    surface.neighbours[b.triangle][b.side] = a.triangle;
  }
}

void add_triangles_of_vertices(Surface& surface) {
  surface.first_of_vertex.assign(surface.positions.size() + 1, 0);
  for (const auto& triangle : surface.triangles)
    for (const std::uint32_t vertex : triangle) ++surface.first_of_vertex[vertex + 1];
  std::partial_sum(surface.first_of_vertex.begin(), surface.first_of_vertex.end(), surface.first_of_vertex.begin());
  std::vector<std::uint32_t> next(surface.first_of_vertex.begin(), surface.first_of_vertex.end() - 1);
  surface.of_vertex.resize(3 * surface.triangles.size());
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
    for (const std::uint32_t vertex : surface.triangles[t]) surface.of_vertex[next[vertex]++] = t;
}

// Vertices whose normals cancel out, or that have none, get the normal of their triangles.
void add_normals(const CoarseMesh& mesh, const std::vector<std::uint32_t>& welded, Surface& surface) {
  surface.normals.assign(surface.positions.size(), {});
  if (!mesh.normals.empty())
    for (std::uint32_t i = 0; i < welded.size(); ++i) surface.normals[welded[i]] += unit(vector_at(mesh.normals, i));
  std::vector<Vector> of_triangles(surface.positions.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (const std::uint32_t vertex : surface.triangles[t]) {
      const auto& corners = surface.triangles[t];
      of_triangles[vertex] += common::cross(surface.positions[corners[1]] - surface.positions[corners[0]],
                                            surface.positions[corners[2]] - surface.positions[corners[0]]);
    }
  for (std::size_t i = 0; i < surface.normals.size(); ++i) {
    constexpr float least = 0.1F;
    if (common::length(surface.normals[i]) < least) surface.normals[i] = of_triangles[i];
    surface.normals[i] = unit(surface.normals[i]);
    if (common::is_zero(surface.normals[i])) surface.normals[i] = {0, 0, 1};
  }
}

void measure_box(Surface& surface) {
  Vector low = surface.positions.front();
  Vector high = low;
  for (const Vector& p : surface.positions) {
    low = common::least(low, p);
    high = common::greatest(high, p);
  }
  surface.diagonal = static_cast<double>(common::robust_length(high - low));
}

void measure(Surface& surface) {
  measure_box(surface);
  double sum = 0;
  for (const auto& corners : surface.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      sum += static_cast<double>(
          common::robust_length(surface.positions[corners[(k + 1) % 3]] - surface.positions[corners[k]]));
  surface.mean_edge = sum / (3 * static_cast<double>(surface.triangles.size()));
}

void add_texcoords(const CoarseMesh& mesh, Surface& surface) {
  for (const auto& corners : surface.sources) {
    auto& of_triangle = surface.texcoords.emplace_back();
    for (std::size_t k = 0; k < 3; ++k)
      of_triangle[k] = {mesh.texcoords[2 * std::size_t{corners[k]}], mesh.texcoords[2 * std::size_t{corners[k]} + 1]};
  }
}

// Squares of lengths must neither overflow nor underflow.
void scale(Surface& surface) {
  measure_box(surface);
  if (surface.diagonal > 0) surface.scale = std::ldexp(1.0, -std::ilogb(surface.diagonal));
  for (Vector& p : surface.positions)
    for (std::size_t axis = 0; axis < 3; ++axis)
      p[axis] = static_cast<float>(static_cast<double>(p[axis]) * surface.scale);
}

}  // namespace

Surface surface_of(const CoarseMesh& mesh) {
  require(mesh);
  Surface surface;
  surface.welded = weld(mesh, surface.positions);
  const std::vector<std::uint32_t>& welded = surface.welded;
  scale(surface);
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    const std::array<std::uint32_t, 3> corners{welded[mesh.triangles[t]], welded[mesh.triangles[t + 1]],
                                               welded[mesh.triangles[t + 2]]};
    surface.triangles.push_back(corners);
    surface.sources.push_back({mesh.triangles[t], mesh.triangles[t + 1], mesh.triangles[t + 2]});
    surface.triangle_normals.push_back(
        unit(common::cross(surface.positions[corners[1]] - surface.positions[corners[0]],
                           surface.positions[corners[2]] - surface.positions[corners[0]])));
  }
  if (!mesh.texcoords.empty()) add_texcoords(mesh, surface);
  add_normals(mesh, welded, surface);
  add_neighbours(surface);
  add_triangles_of_vertices(surface);
  measure(surface);
  if (std::all_of(surface.triangle_normals.begin(), surface.triangle_normals.end(),
                  [](const Vector& normal) { return common::is_zero(normal); }))
    throw Error(Element::array, 0, "no triangle of the coarse mesh has an area; give a mesh with a surface");
  return surface;
}

std::size_t corner_at(const Surface& surface, std::uint32_t triangle, std::uint32_t vertex) {
  const auto& corners = surface.triangles[triangle];
  return static_cast<std::size_t>(std::find(corners.begin(), corners.end(), vertex) - corners.begin());
}

}  // namespace glark::maps
