// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/reconstruct/contour/transition_layer.h"

#include <algorithm>
#include <cmath>

#include "glark/clients/common/points/height_field.h"

namespace glark::reconstruct {
namespace {

// The radius of a node's ball, relative to the side of the finest cells, or to the side of a square that its samples
// would fill.
constexpr float reach = 2;
// The radius relative to the spacing of the samples, if that is larger.
constexpr float spacings = 4;
// The limit for `spacings`, relative to the side of the finest cells.
constexpr float most_reach = 4;
constexpr std::uint32_t several = 8;  // the fewest samples that show their spacing
constexpr float most_weight = 16;     // the number of samples that gives the full weight
constexpr float agreement = 0.5F;     // the mean of normals that agree has at least this length
constexpr float opposed = -0.7F;      // the greatest cosine between the normals of two sides
constexpr std::size_t grain = 256;    // in cells
constexpr std::uint32_t few = 8;      // cells with at most half as many samples are not divided

class Layer {
 public:
  Layer(const Octree& octree, const ReconstructOptions& options) : octree_(octree), options_(options) {}

  // Adds the planes of cell `number` of a level, above `depth` finer levels.
  void visit(std::size_t depth, std::uint32_t number, float spacing, std::vector<SupportPlane>& out) const {
    const Level& level = octree_.levels[depth];
    const std::uint32_t begin = level.begins[number], end = level.begins[number + 1];
    const std::span<const Record> records(octree_.records.data() + begin, end - begin);
    if (depth + 1 == octree_.levels.size() && records.size() < several && is_alone(level, number)) return;
    const Moments moments = Moments::of(records);
    if (records.size() >= several) spacing = side_of(moments) / std::sqrt(moments.count());
    if (depth > 0 && !ends(records, moments)) {
      const Level& finer = octree_.levels[depth - 1];
      auto child = static_cast<std::uint32_t>(std::lower_bound(finer.begins.begin(), finer.begins.end() - 1, begin) -
                                              finer.begins.begin());
      for (; finer.begins[child] < end; ++child) visit(depth - 1, child, spacing, out);
      return;
    }
    if (two_sided(records, moments)) {
      part(records, level, number, spacing, out);
    } else {
      add(moments, level, number, spacing, out);
    }
  }

 private:
  // Returns whether the cells around have no samples. Then the cell's samples are stray points beside a scan.
  static bool is_alone(const Level& level, std::uint32_t number) {
    const CellIndex cell = cell_of_key(level.keys[number]);
    const std::int32_t last = (1 << level.level) - 1;
    CellBox box;
    for (unsigned i = 0; i < 3; ++i) {
      box.low[i] = std::max(cell[i] - 1, 0);
      box.high[i] = std::min(cell[i] + 1, last);
    }
    std::uint32_t records = 0;
    level.blocks.each(box, [&](std::uint32_t begin, std::uint32_t end) { records += end - begin; });
    return records == level.begins[number + 1] - level.begins[number];
  }

  // Returns the side of a square that the samples would fill.
  static float side_of(const Moments& moments) {
    return std::sqrt(6 * (moments.products[0][0] + moments.products[1][1] + moments.products[2][2]) / moments.count());
  }

  bool ends(std::span<const Record> records, const Moments& moments) const {
    if (records.size() <= few / 2) return true;
    if (static_cast<float>(records.size()) > 2 * options_.node_samples) return false;
    return is_height_field(records, moments, options_.delta_a, options_.delta_d);
  }

  // Returns whether some samples face away from the others. The two sides of a wing are slightly tilted the same way,
  // so a mean normal alone may face forwards, along the wing.
  bool two_sided(std::span<const Record> records, const Moments& moments) const {
    const Float4 normal = moments.normal();
    if (std::any_of(records.begin(), records.end(),
                    [&](const Record& record) { return dot(record.normal, normal) <= options_.delta_a; }))
      return true;
    if (dot(moments.normals, moments.normals) > agreement * agreement * moments.count() * moments.count()) return false;
    const Float4 one = farthest(records, normal);
    return dot(one, farthest(records, one)) < opposed;
  }

  // Returns the normal that deviates most from the given one.
  static Float4 farthest(std::span<const Record> records, Float4 from) {
    return std::min_element(records.begin(), records.end(),
                            [&](const Record& a, const Record& b) { return dot(a.normal, from) < dot(b.normal, from); })
        ->normal;
  }

  void add(const Moments& moments, const Level& level, std::uint32_t number, float spacing,
           std::vector<SupportPlane>& out) const {
    const Float4 normal = moments.normal();
    if (dot(normal, normal) == 0) return;
    SupportPlane plane{without_fourth(moments.mean), without_fourth(normal), level.keys[number], level.level};
    const float side = octree_.finest().side();
    plane.point[3] =
        std::max(reach * std::max(side, side_of(moments)), std::min(spacings * spacing, most_reach * side));
    plane.normal[3] = std::min(moments.count(), most_weight) / most_weight;
    out.push_back(plane);
  }

  // Adds one plane for each of the two sides. The seeds of the sides are the normal farthest from the mean normal, and
  // the normal farthest from the first seed.
  void part(std::span<const Record> records, const Level& level, std::uint32_t number, float spacing,
            std::vector<SupportPlane>& out) const {
    Float4 seeds[2] = {farthest(records, Moments::of(records).normals)};
    seeds[1] = farthest(records, seeds[0]);
    std::vector<Record> sides[2];
    for (int round = 0; round < 3; ++round) {
      Float4 sums[2] = {};
      for (auto& side : sides) side.clear();
      for (const Record& record : records) {
        const int side = dot(record.normal, seeds[0]) >= dot(record.normal, seeds[1]) ? 0 : 1;
        sums[side] += record.normal;
        sides[side].push_back(record);
      }
      for (int i = 0; i < 2; ++i) seeds[i] = unit(sums[i]);
    }
    for (const auto& side : sides) {
      if (!side.empty()) add(Moments::of(side), level, number, spacing, out);
    }
  }

  const Octree& octree_;
  const ReconstructOptions& options_;
};

}  // namespace

TransitionLayer transition_layer(const Octree& octree, const ReconstructOptions& options, const Workers& workers) {
  TransitionLayer result;
  if (octree.levels.empty()) return result;
  const Layer layer(octree, options);
  const Level& coarsest = octree.levels.back();
  std::vector<std::vector<SupportPlane>> parts((coarsest.keys.size() + grain - 1) / grain);
  workers.each(parts.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t part = begin; part < end; ++part) {
      const std::size_t last = std::min(coarsest.keys.size(), (part + 1) * grain);
      for (std::size_t i = part * grain; i < last; ++i)
        layer.visit(octree.levels.size() - 1, static_cast<std::uint32_t>(i), 0, parts[part]);
    }
  });
  for (const auto& part : parts) result.planes.insert(result.planes.end(), part.begin(), part.end());
  result.cells.resize(octree.levels.size());
  for (std::uint32_t i = 0; i < result.planes.size(); ++i)
    result.cells[octree.finest().level - result.planes[i].level].insert(result.planes[i].key, i);
  return result;
}

}  // namespace glark::reconstruct
