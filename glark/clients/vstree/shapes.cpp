// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/vstree/shapes.h"

#include <algorithm>

namespace glark::vstree {
namespace {

constexpr std::size_t grain = 1 << 10;  // clusters or nodes for a thread

// Without a quadric.
Shape extent_of(std::span<const Record> records) {
  Shape shape;
  for (const Record& record : records) shape.sum += record.point() + Float4{0, 0, 0, 1};
  const Float4 centroid = shape.centroid();
  float square = 0;
  for (const Record& record : records) {
    const Float4 apart = record.point() - centroid;
    square = std::max(square, dot(apart, apart));
  }
  shape.radius = std::sqrt(square);
  return shape;
}

// A quadric about a centroid without what finding its best point does not need; a line of the cache.
struct alignas(64) Planes {
  Float4 centroid{};
  Float4 rows[3] = {};

  // The plane through `point`, with a normal as long as its weight.
  void add(Float4 point, Float4 normal, Float4 unit_normal) {
    normal[3] = -dot(normal, point - centroid);
    rows[0] += splat<0>(unit_normal) * normal;
    rows[1] += splat<1>(unit_normal) * normal;
    rows[2] += splat<2>(unit_normal) * normal;
  }
};

// A point, its cluster as the bits of the fourth.
std::uint32_t cluster_at(const Float4& corner) { return std::bit_cast<std::uint32_t>(static_cast<float>(corner[3])); }

// Of the clusters first .. last - 1, in the order of the triangles whoever does it.
void add_triangles(std::span<const std::uint32_t> triangles, std::span<const Float4> corners, std::uint32_t first,
                   std::uint32_t last, std::span<Planes> planes) {
  const std::uint32_t size = last - first;
  for (std::size_t t = 0; t < triangles.size(); t += 3) {
    const Float4 &a = corners[triangles[t]], &b = corners[triangles[t + 1]], &c = corners[triangles[t + 2]];
    const std::uint32_t groups[3] = {cluster_at(a) - first, cluster_at(b) - first, cluster_at(c) - first};
    if (groups[0] >= size && groups[1] >= size && groups[2] >= size) continue;
    const Float4 point = without_fourth(a);
    const Float4 normal = cross(without_fourth(b) - point, without_fourth(c) - point);
    const float square = dot(normal, normal);
    if (!(square > 0)) continue;
    const Float4 unit_normal = normal / std::sqrt(square);
    if (groups[0] == groups[1] && groups[1] == groups[2]) {
      planes[first + groups[0]].add(point, normal * 3, unit_normal);
      continue;
    }
    for (const std::uint32_t group : groups) {
      if (group < size) planes[first + group].add(point, normal, unit_normal);
    }
  }
}

void add_triangles(const Surface& surface, const Clusters& clusters, const Workers& workers,
                   std::vector<Shape>& shapes) {
  std::vector<Float4> corners(surface.size());
  workers.each(corners.size(), 1 << 14, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      corners[i] = surface.point(i);
      corners[i][3] = std::bit_cast<float>(clusters.of[i]);
    }
  });
  std::vector<Planes> planes(clusters.count);
  const std::size_t parts = std::clamp<std::size_t>(surface.triangles.size() / 50000, 1, workers.count());
  workers.each(parts, 1, [&](std::size_t first_part, std::size_t last_part) {
    const auto first = static_cast<std::uint32_t>(clusters.count * first_part / parts);
    const auto last = static_cast<std::uint32_t>(clusters.count * last_part / parts);
    for (std::uint32_t i = first; i < last; ++i) planes[i].centroid = shapes[i].centroid();
    add_triangles(surface.triangles, corners, first, last, planes);
    for (std::uint32_t i = first; i < last; ++i) std::copy_n(planes[i].rows, 3, shapes[i].quadric.rows);
  });
}

}  // namespace

Shape shape_of(std::span<const Record> records) {
  Shape shape = extent_of(records);
  const Float4 centroid = shape.centroid();
  for (const Record& record : records)
    shape.quadric.add_plane(record.point() - centroid, record.normal, record.normal[3]);
  return shape;
}

Shape sum_of(std::span<const Shape> shapes) {
  if (shapes.size() == 1) return shapes.front();
  Shape result;
  for (const Shape& shape : shapes) result.sum += shape.sum;
  for (const Shape& shape : shapes) {
    const Float4 apart = result.centroid() - shape.centroid();
    result.quadric.add(shape.quadric.moved(apart));
    result.radius = std::max(result.radius, shape.radius + std::sqrt(dot(apart, apart)));
  }
  return result;
}

std::vector<Float4> representatives(const Surface& surface, const Clusters& clusters, Representative how,
                                    const Workers& workers) {
  const bool by_samples = how == Representative::qef && surface.triangles.empty();
  std::vector<Shape> shapes(clusters.count);
  workers.each(clusters.count, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      shapes[i] = by_samples ? shape_of(clusters.samples(i)) : extent_of(clusters.samples(i));
  });
  if (how == Representative::qef && !by_samples) add_triangles(surface, clusters, workers, shapes);
  std::vector<Float4> points(clusters.count);
  workers.each(clusters.count, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      points[i] = shapes[i].centroid();
      if (how == Representative::qef) points[i] += shapes[i].best_step();
    }
  });
  return points;
}

}  // namespace glark::vstree
