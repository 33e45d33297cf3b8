// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/vstree/simplify/shapes.h"

#include <algorithm>
#include <limits>
#include <memory>

#include "glark/clients/vstree/simplify/sheets/boundary.h"

namespace glark::vstree {
namespace {

constexpr float boundary_weight = 6;  // relative to triangles as wide as the cluster

// Returns the shape of the records without its quadric.
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

// The part of a quadric that determines its best point, relative to a centroid. It fills one cache line.
struct alignas(64) Planes {
  Float4 centroid{};
  Float4 squares{};   // xx yy zz
  Float4 products{};  // xy yz zx
  Float4 offsets{};   // b

  // The plane through `point`. The length of its normal is its weight.
  struct Plane {
    Float4 point, normal, unit_normal, squares, products;
    Plane(Float4 p, Float4 n, Float4 unit)
        : point(p),
          normal(n),
          unit_normal(unit),
          squares(n * unit),
          products(n * __builtin_shufflevector(unit, unit, 1, 2, 0, 3)) {}
  };
  // Adds the plane to three quadrics, which may be the same. It computes the three distances together, which takes
  // fewer instructions.
  static void add(const Plane& plane, Planes& a, Planes& b, Planes& c) {
    const Float4 at_a = plane.normal * (a.centroid - plane.point), at_b = plane.normal * (b.centroid - plane.point);
    const Float4 at_c = plane.normal * (c.centroid - plane.point);
    const Float4 low = __builtin_shufflevector(at_a, at_b, 0, 4, 1, 5),
                 high = __builtin_shufflevector(at_a, at_b, 2, 6, 3, 7);
    const Float4 distances = __builtin_shufflevector(low, at_c, 0, 1, 4, 7) +
                             __builtin_shufflevector(low, at_c, 2, 3, 5, 7) +
                             __builtin_shufflevector(high, at_c, 0, 1, 6, 7);
    a.add(plane, splat<0>(distances));
    b.add(plane, splat<1>(distances));
    c.add(plane, splat<2>(distances));
  }
  void add(const Plane& plane) { add(plane, Float4{} + dot(plane.normal, centroid - plane.point)); }
  Quadric quadric() const {
    Quadric result;
    result.rows[0] = Float4{squares[0], products[0], products[2], offsets[0]};
    result.rows[1] = Float4{products[0], squares[1], products[1], offsets[1]};
    result.rows[2] = Float4{products[2], products[1], squares[2], offsets[2]};
    return result;
  }

 private:
  void add(const Plane& plane, Float4 distance) {
    squares += plane.squares;
    products += plane.products;
    offsets += plane.unit_normal * distance;
  }
};

// Returns the cluster of a corner, from the bits of the fourth float.
std::uint32_t cluster_at(const Float4& corner) { return std::bit_cast<std::uint32_t>(static_cast<float>(corner[3])); }

struct alignas(64) Extent {
  Float4 sum{};  // the sum of the points; the fourth is their number
  Float4 low{1, 1, 1, 0}, high{};
  Float4 normal{};

  Float4 centroid() const { return without_fourth(sum / splat<3>(sum)); }
  float radius() const { return 0.5F * std::sqrt(dot(high - low, high - low)); }
};

// Sums over clusters, in the order of the samples or triangles for any number of threads. Each thread owns some
// clusters and reads all samples.
class Sums {
 public:
  Sums(const Surface& surface, std::span<const Float4> corners, std::span<const BoundaryEdge> boundary,
       std::span<Extent> extents, std::span<Planes> planes)
      : surface_(surface), corners_(corners), boundary_(boundary), extents_(extents), planes_(planes) {}

  // Adds to the clusters first .. last - 1. `is_all`: this range has all clusters.
  template <bool is_all>
  void add(std::uint32_t first, std::uint32_t last, Representative how) {
    const std::uint32_t size = last - first;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const std::uint32_t cluster = cluster_at(corners_[i]);
      if (is_all || cluster - first < size) add_sample(i, extents_[cluster]);
    }
    if (how != Representative::qef) return;
    for (std::uint32_t i = first; i < last; ++i) planes_[i].centroid = extents_[i].centroid();
    if (!surface_.triangles.empty()) {
      add_triangles<is_all>(first, size);
      return add_boundary(first, size);
    }
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const std::uint32_t cluster = cluster_at(corners_[i]);
      if (!is_all && cluster - first >= size) continue;
      const Float4 normal = without_fourth(unit_normal(&surface_.points.normals[3 * i]));
      planes_[cluster].add({without_fourth(corners_[i]), normal, normal});
    }
  }

 private:
  void add_sample(std::size_t i, Extent& extent) {
    const Float4 point = without_fourth(corners_[i]);
    extent.sum += point + Float4{0, 0, 0, 1};
    extent.low = least(extent.low, point);
    extent.high = greatest(extent.high, point);
    extent.normal += unit_normal(&surface_.points.normals[3 * i]);
  }

  template <bool is_all>
  void add_triangles(std::uint32_t first, std::uint32_t size) {
    constexpr std::size_t far = 96, near = 24;  // distances of the prefetches, in corners
    const std::span<const std::uint32_t> triangles = surface_.triangles;
    Planes others;  // stands for clusters of other threads
    for (std::size_t t = 0; t < triangles.size(); t += 3) {
      for (std::size_t k = 0; k < 3 && t + far + 3 <= triangles.size(); ++k) {
        __builtin_prefetch(&corners_[triangles[t + far + k]]);
        __builtin_prefetch(&planes_[cluster_at(corners_[triangles[t + near + k]])], 1);
      }
      const Float4 &a = corners_[triangles[t]], &b = corners_[triangles[t + 1]], &c = corners_[triangles[t + 2]];
      const std::uint32_t groups[3] = {cluster_at(a), cluster_at(b), cluster_at(c)};
      if (!is_all && groups[0] - first >= size && groups[1] - first >= size && groups[2] - first >= size) continue;
      const Float4 point = without_fourth(a);
      const Float4 normal = cross(without_fourth(b) - point, without_fourth(c) - point);
      const float length = std::sqrt(dot(normal, normal) + std::numeric_limits<float>::min());
      const Planes::Plane plane(point, normal, normal * (1 / length));
      const auto of = [&](std::uint32_t group) -> Planes& {
        return is_all || group - first < size ? planes_[group] : others;
      };
      Planes::add(plane, of(groups[0]), of(groups[1]), of(groups[2]));
    }
  }

  // Adds planes through the edges, perpendicular to their triangles. They keep representatives on the boundary.
  void add_boundary(std::uint32_t first, std::uint32_t size) {
    for (const BoundaryEdge& edge : boundary_) {
      const Float4 &from = corners_[edge.from], &to = corners_[edge.to], &opposite = corners_[edge.opposite];
      const Float4 along = without_fourth(to - from), normal = boundary_normal(from, to, opposite);
      if (!(dot(normal, normal) > 0)) continue;
      const std::uint32_t groups[2] = {cluster_at(from), cluster_at(to)};
      for (std::size_t k = 0; k < (groups[0] == groups[1] ? 1 : 2); ++k) {
        if (groups[k] - first >= size) continue;
        const float weight = boundary_weight * extents_[groups[k]].radius() * std::sqrt(dot(along, along));
        planes_[groups[k]].add({without_fourth(from), normal * weight, normal});
      }
    }
  }

  const Surface& surface_;
  std::span<const Float4> corners_;
  std::span<const BoundaryEdge> boundary_;
  std::span<Extent> extents_;
  std::span<Planes> planes_;
};

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

Representatives representatives(const Surface& surface, const Clusters& clusters, Representative how,
                                const Workers& workers) {
  const auto corners = std::make_unique_for_overwrite<Float4[]>(surface.size());
  workers.each(surface.size(), 1 << 14, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      corners[i] = surface.point(i);
      corners[i][3] = std::bit_cast<float>(clusters.of[i]);
    }
  });
  std::vector<Extent> extents(clusters.count);
  std::vector<Planes> planes(how == Representative::qef ? clusters.count : 0);
  std::vector<bool> is_at_boundary(clusters.count);
  const std::vector<BoundaryEdge>& boundary = *clusters.boundary;
  for (const BoundaryEdge& edge : boundary)
    is_at_boundary[clusters.of[edge.from]] = is_at_boundary[clusters.of[edge.to]] = true;
  Sums sums(surface, {corners.get(), surface.size()}, boundary, extents, planes);
  const std::size_t parts = std::clamp<std::size_t>(surface.size() / 25000, 1, workers.count());
  Representatives result{std::vector<Float4>(clusters.count), std::vector<Float4>(clusters.count)};
  workers.each(parts, 1, [&](std::size_t first_part, std::size_t last_part) {
    const auto first = static_cast<std::uint32_t>(clusters.count * first_part / parts);
    const auto last = static_cast<std::uint32_t>(clusters.count * last_part / parts);
    if (last - first == clusters.count) {
      sums.add<true>(first, last, how);
    } else {
      sums.add<false>(first, last, how);
    }
    for (std::uint32_t i = first; i < last; ++i) {
      result.points[i] = extents[i].centroid();
      result.normals[i] = extents[i].normal;
      if (how != Representative::qef) continue;
      Shape shape;
      shape.radius = extents[i].radius();
      shape.quadric = planes[i].quadric();
      result.points[i] += shape.best_step(is_at_boundary[i] ? most_step_at_boundary : most_step);
    }
  });
  return result;
}

}  // namespace glark::vstree
