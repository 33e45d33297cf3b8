// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/vstree/clusters.h"

#include <algorithm>

namespace glark::vstree {
namespace {

void add_triangles(const Surface& surface, std::span<const std::uint32_t> groups, std::span<const Float4> centroids,
                   std::vector<Shape>& shapes) {
  for (std::size_t t = 0; t < surface.triangles.size(); t += 3) {
    const std::uint32_t* const corners = &surface.triangles[t];
    const Float4 a = surface.points[corners[0]];
    const Float4 normal = cross(surface.points[corners[1]] - a, surface.points[corners[2]] - a);
    const float area = std::sqrt(dot(normal, normal));
    if (!(area > 0)) continue;
    const std::uint32_t g[3] = {groups[corners[0]], groups[corners[1]], groups[corners[2]]};
    if (g[0] == g[1] && g[1] == g[2]) {
      shapes[g[0]].quadric.add_plane(a - centroids[g[0]], normal / area, 3 * area);
    } else {
      for (const std::uint32_t group : g) shapes[group].quadric.add_plane(a - centroids[group], normal / area, area);
    }
  }
}

}  // namespace

std::vector<Shape> shapes_of(const Surface& surface, std::span<const std::uint32_t> groups, std::size_t count) {
  std::vector<Shape> shapes(count);
  for (std::size_t i = 0; i < groups.size(); ++i) shapes[groups[i]].sum += surface.points[i] + Float4{0, 0, 0, 1};
  std::vector<Float4> centroids(count);
  for (std::size_t i = 0; i < count; ++i) centroids[i] = shapes[i].centroid();
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const Float4 apart = surface.points[i] - centroids[groups[i]];
    shapes[groups[i]].radius = std::max(shapes[groups[i]].radius, dot(apart, apart));
  }
  for (Shape& shape : shapes) shape.radius = std::sqrt(shape.radius);
  if (!surface.triangles.empty()) {
    add_triangles(surface, groups, centroids, shapes);
    return shapes;
  }
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const Float4 normal = surface.normals[i];
    shapes[groups[i]].quadric.add_plane(surface.points[i] - centroids[groups[i]], normal, normal[3]);
  }
  return shapes;
}

std::size_t spanning_triangles(std::span<const std::uint32_t> triangles, std::span<const std::uint32_t> clusters) {
  std::size_t count = 0;
  for (std::size_t t = 0; t < triangles.size(); t += 3) {
    const std::uint32_t a = clusters[triangles[t]], b = clusters[triangles[t + 1]], c = clusters[triangles[t + 2]];
    count += static_cast<std::size_t>((a != b) & (b != c) & (c != a));
  }
  return count;
}

}  // namespace glark::vstree
