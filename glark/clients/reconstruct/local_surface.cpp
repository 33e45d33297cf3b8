// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/reconstruct/local_surface.h"

namespace glark::vstree {
namespace {

constexpr float least_facing = 0.2F;  // of a sample's normal and the one looked along
constexpr float least_opposed = -0.8F;
constexpr float few = 3;            // samples
constexpr float sharpness = 0.01F;  // the least of what weights fall with
constexpr float planes = 0.25F;     // share of the samples' planes in a height
constexpr float noise_weight = 100;

struct Query {
  Float4 point, normal;
  float scale;  // 1 / radius^2
  float blur;
};

struct Sums {
  float weight = 0;
  float count = 0;
  float opposed = 0;  // samples
  Float4 offset{};    // from the point
  Float4 normal{};
  float heights = 0;  // above the point, of the samples' planes
};

// Four records at a time, one in each lane: a branch for each sample would take longer than all that is done with it.
class Lanes {
 public:
  explicit Lanes(const Query& query)
      : x_(splat<0>(query.point)),
        y_(splat<1>(query.point)),
        z_(splat<2>(query.point)),
        u_(splat<0>(query.normal)),
        v_(splat<1>(query.normal)),
        w_(splat<2>(query.normal)),
        scale_(all(query.scale)),
        blur_(all(query.blur)) {}

  // May look at three records more than there are.
  void add(const Record* record, std::uint32_t count) {
    constexpr Int4 numbers{0, 1, 2, 3};
    for (std::uint32_t i = 0; i < count; i += 4) add(record + i, numbers < static_cast<int>(count - i));
  }

  Sums sums() const {
    return {.weight = sum(weight_),
            .count = sum(count_),
            .opposed = sum(opposed_),
            .offset = Float4{sum(offset_[0]), sum(offset_[1]), sum(offset_[2]), 0},
            .normal = Float4{sum(normal_[0]), sum(normal_[1]), sum(normal_[2]), 0},
            .heights = sum(heights_)};
  }

 private:
  static Float4 all(float a) { return Float4{a, a, a, a}; }
  static float sum(Float4 a) { return (a[0] + a[1]) + (a[2] + a[3]); }
  static Float4 where(Int4 mask, Float4 a) { return std::bit_cast<Float4>(std::bit_cast<Int4>(a) & mask); }
  static bool any(Int4 mask) {
    const auto halves = std::bit_cast<std::array<std::uint64_t, 2>>(mask);
    return (halves[0] | halves[1]) != 0;
  }
  static void transpose(Float4 a, Float4 b, Float4 c, Float4 d, Float4 (&out)[3]) {
    const Float4 ab = __builtin_shufflevector(a, b, 0, 4, 1, 5), cd = __builtin_shufflevector(c, d, 0, 4, 1, 5);
    const Float4 ab_z = __builtin_shufflevector(a, b, 2, 6, 3, 7), cd_z = __builtin_shufflevector(c, d, 2, 6, 3, 7);
    out[0] = __builtin_shufflevector(ab, cd, 0, 1, 4, 5);
    out[1] = __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
    out[2] = __builtin_shufflevector(ab_z, cd_z, 0, 1, 4, 5);
  }

  void add(const Record* r, Int4 given) {
    Float4 p[3], n[3];
    transpose(r[0].position, r[1].position, r[2].position, r[3].position, p);
    const Float4 dx = p[0] - x_, dy = p[1] - y_, dz = p[2] - z_;
    const Float4 t = (dx * dx + dy * dy + dz * dz) * scale_;
    Int4 near = (t < all(1)) & given;
    if (!any(near)) return;
    transpose(r[0].normal, r[1].normal, r[2].normal, r[3].normal, n);
    const Float4 facing = n[0] * u_ + n[1] * v_ + n[2] * w_;
    opposed_ += where(near & (facing < all(least_opposed)), all(1));
    near &= facing >= all(least_facing);
    const Float4 weight = where(near, (all(1) - t) * (all(1) - t) / (t + blur_));
    weight_ += weight;
    count_ += where(near, all(1));
    const Float4 d[3] = {dx, dy, dz};
    for (int i = 0; i < 3; ++i) {
      offset_[i] += d[i] * weight;
      normal_[i] += n[i] * weight;
    }
    heights_ += (dx * n[0] + dy * n[1] + dz * n[2]) * weight;
  }

  Float4 x_, y_, z_, u_, v_, w_, scale_, blur_;
  Float4 weight_{}, count_{}, opposed_{}, heights_{};
  Float4 offset_[3]{}, normal_[3]{};
};

}  // namespace

// The mean height of samples that a curved surface has around a point is as far on one side of it as that of their tangent planes on the
// other; so half the sum has no error of second order, and no system of equations has to be solved.
LocalEstimate LocalSurface::within(Float4 point, Float4 normal, float radius) const {
  std::size_t depth = 0;
  while (depth + 1 < octree_.levels.size() && octree_.levels[depth].side() < radius) ++depth;
  const Level& level = octree_.levels[depth];
  const float scale = 1 / (radius * radius);
  const float noise = noise_weight * octree_.noise * octree_.noise * scale;
  const Query query{point, normal, scale, sharpness + noise * noise};
  Lanes lanes(query);
  const CellIndex cell = cell_of(point, level.level);
  // Of each axis the square of the distance to the cells before, at and after the point.
  std::array<std::array<float, 3>, 3> apart{};
  for (unsigned axis = 0; axis < 3; ++axis) {
    const float before = point[static_cast<int>(axis)] - static_cast<float>(cell[axis]) * level.side();
    const float after = level.side() - before;
    apart[axis] = {before * before, 0, after * after};
  }
  const auto take = [&](const NearCell& near) {
    const float square = apart[0][near.which % 3] + apart[1][near.which / 3 % 3] + apart[2][near.which / 9];
    if (square * scale < 1) lanes.add(octree_.records.data() + near.begin, near.end - near.begin);
  };
  const std::uint32_t number = level.find(cell);
  if (number != CellTable::absent) {
    for (std::uint32_t i = level.around_begins[number]; i < level.around_begins[number + 1]; ++i) take(level.around[i]);
  } else {
    std::vector<NearCell> cells;
    level.add_around(cell, cells);
    for (const NearCell& near : cells) take(near);
  }
  const Sums sums = lanes.sums();
  LocalEstimate estimate;
  estimate.opposed = sums.opposed >= few && sums.count == 0;
  if (sums.count < few || !(sums.weight > 0)) return estimate;
  estimate.normal = unit(without_fourth(sums.normal));
  const float height = (dot(sums.offset, estimate.normal) * (1 - planes) + sums.heights * planes) / sums.weight;
  estimate.point = point + estimate.normal * height;
  estimate.found = true;
  return estimate;
}

LocalEstimate LocalSurface::near(Float4 point, Float4 normal, float radius) const {
  LocalEstimate estimate = within(point, normal, radius);
  estimate.near = estimate.found;
  return estimate.found ? estimate : within(point, normal, 2 * radius);
}

}  // namespace glark::vstree
