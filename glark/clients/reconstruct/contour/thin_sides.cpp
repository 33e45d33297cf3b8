// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/reconstruct/contour/thin_sides.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "glark/clients/reconstruct/contour/blocks.h"

namespace glark::reconstruct {
namespace {

constexpr float opposed = -0.6F;  // the greatest cosine between the normals of the two sides
constexpr float thin = 1.6F;      // the greatest distance of the two sides, in cells
constexpr float alike = 0.45F;    // normals with this cosine to their mean cannot be opposed

Float4 all(float a) { return Float4{a, a, a, a}; }

Float4 dot(const Float4 (&a)[3], const Float4 (&b)[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// The nearest plane of each of four points.
struct Nearest {
  Float4 square = all(no_value);
  Float4 point[3]{}, normal[3]{};

  void take(Int4 where, Float4 squares, const SupportPlane& plane) {
    square = where ? squares : square;
    for (int i = 0; i < 3; ++i) {
      point[i] = where ? all(plane.point[i]) : point[i];
      normal[i] = where ? all(plane.normal[i]) : normal[i];
    }
  }
};

Float4 squared_distance(const Float4 (&points)[3], const SupportPlane& plane) {
  const Float4 d[3] = {points[0] - plane.point[0], points[1] - plane.point[1], points[2] - plane.point[2]};
  return dot(d, d);
}

bool meets(const SupportPlane& plane, Float4 low, Float4 high) {
  const Float4 d = without_fourth(greatest(greatest(low - plane.point, plane.point - high), Float4{}));
  return common::dot(d, d) < plane.point[3] * plane.point[3];
}

}  // namespace

bool Opposites::are_alike(std::span<const std::uint32_t> planes) const {
  Float4 sum{};
  for (const std::uint32_t i : planes) sum += layer_.planes[i].normal;
  const Float4 mean = unit(sum);
  return std::all_of(planes.begin(), planes.end(),
                     [&](std::uint32_t i) { return common::dot(layer_.planes[i].normal, mean) > alike; });
}

bool Opposites::has(const SupportPlane& plane) const {
  for (const float way : {0.0F, -0.5F, 0.5F, -1.1F, 1.1F}) {
    const Float4 there = plane.point + plane.normal * (way / cells_);
    const std::uint64_t key = key_of(cell_of(there, level_));
    for (std::size_t depth = 0; depth < layer_.cells.size(); ++depth) {
      if (is_opposed_in(depth, key >> (3 * depth), plane)) return true;
    }
  }
  return false;
}

bool Opposites::is_opposed_in(std::size_t depth, std::uint64_t key, const SupportPlane& plane) const {
  std::uint32_t i = layer_.cells[depth].find(key);
  if (i == CellTable::absent) return false;
  for (; i < layer_.planes.size() && layer_.planes[i].key == key; ++i) {
    const SupportPlane& other = layer_.planes[i];
    const float apart = common::dot(other.point - plane.point, plane.normal) * cells_;
    if (common::dot(other.normal, plane.normal) < opposed && std::abs(apart) < thin) return true;
  }
  return false;
}

void ThinSides::look_around(std::span<const std::uint32_t> which, Float4 low, Float4 high) {
  around_.clear();
  for (const std::uint32_t i : which) {
    SupportPlane plane = planes_[i];
    plane.point *= cells_;
    if (meets(plane, low, high)) around_.push_back(plane);
  }
}

void ThinSides::look_at(Float4 low, Float4 high) {
  near_.clear();
  std::copy_if(around_.begin(), around_.end(), std::back_inserter(near_),
               [&](const SupportPlane& plane) { return meets(plane, low, high); });
}

// The partition of unity of the planes that face the same way as the normals.
Float4 ThinSides::height_over(const Float4 (&points)[3], const Float4 (&normal)[3]) const {
  Float4 weights{}, heights{};
  for (const SupportPlane& plane : near_) {
    const float radius = plane.point[3], band = band_of(radius);
    const Float4 d[3] = {points[0] - plane.point[0], points[1] - plane.point[1], points[2] - plane.point[2]};
    const Float4 n[3] = {all(plane.normal[0]), all(plane.normal[1]), all(plane.normal[2])};
    const Float4 t = dot(d, d) / (radius * radius), height = dot(d, n), facing = dot(n, normal);
    const Int4 counts = (t < 1) & (facing > 0) & (height <= band) & (height >= -band);
    const Float4 weight = counts ? hermite(t) * facing * plane.normal[3] : Float4{};
    weights += weight;
    heights += weight * height;
  }
  return weights > 0 ? heights / weights : all(no_value);
}

FourValues ThinSides::at(const Float4 (&points)[3]) const {
  Nearest mine, other;
  for (const SupportPlane& plane : near_) {
    const Float4 square = squared_distance(points, plane);
    mine.take((square < mine.square) & (square < plane.point[3] * plane.point[3]), square, plane);
  }
  for (const SupportPlane& plane : near_) {
    const Float4 square = squared_distance(points, plane);
    const Float4 n[3] = {all(plane.normal[0]), all(plane.normal[1]), all(plane.normal[2])};
    other.take((square < other.square) & (square < plane.point[3] * plane.point[3]) & (dot(n, mine.normal) < opposed),
               square, plane);
  }
  const Float4 value = height_over(points, mine.normal), behind = height_over(points, other.normal);
  Float4 along[3], between[3];
  for (int i = 0; i < 3; ++i) {
    along[i] = mine.normal[i] - other.normal[i];
    between[i] = mine.point[i] - other.point[i];
  }
  const Int4 is_matter = dot(along, between) >= 0;
  const Int4 is_known = (behind != no_value) & (value != no_value);
  const Int4 take_other = is_known & (is_matter ? behind > value : behind < value);
  const Float4 sum = value + behind;
  FourValues result{take_other ? behind : value, {}, is_known ? (sum < 0 ? -sum : sum) : all(no_value)};
  for (int i = 0; i < 3; ++i) result.normal[i] = take_other ? other.normal[i] : mine.normal[i];
  return result;
}

}  // namespace glark::reconstruct
