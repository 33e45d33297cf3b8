// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Source: Boubekeur 2007, ch. 3.4.1; Y. Ohtake et al., Multi-level Partition of Unity Implicits, 2003.
#include "glark/clients/reconstruct/contour/blocks.h"

namespace glark::reconstruct {
namespace {

// A box of corners of the grid, low .. high.
struct Box {
  CellIndex low, high;
};

Box box_of(const SupportPlane& plane, float cells) {
  const float radius = plane.point[3] * cells;
  Box box;
  for (std::size_t i = 0; i < 3; ++i) {
    const float middle = plane.point[static_cast<int>(i)] * cells;
    box.low[i] = std::max(0, static_cast<std::int32_t>(std::ceil(middle - radius)));
    box.high[i] = std::min(static_cast<std::int32_t>(cells), static_cast<std::int32_t>(std::floor(middle + radius)));
  }
  return box;
}

template <typename Body>
void each_block(const Box& box, const Body& body) {
  for (std::int32_t z = box.low[2] / block_side; z <= box.high[2] / block_side; ++z) {
    for (std::int32_t y = box.low[1] / block_side; y <= box.high[1] / block_side; ++y) {
      for (std::int32_t x = box.low[0] / block_side; x <= box.high[0] / block_side; ++x) body(CellIndex{x, y, z});
    }
  }
}

// Each vector has four corners along x, one in each lane.
constexpr std::size_t fours = block_corners / 4;
using Fours = std::array<Float4, fours>;
Float4 all(float a) { return Float4{a, a, a, a}; }

// Calls body for each group of four corners in the rows that cross the plane's ball. The arguments are the group, the
// offsets from the plane's point in cells, and the squared distances.
template <typename Body>
void each_four(const SupportPlane& plane, float cells, const CellIndex& place, const Body& body) {
  Box box = box_of(plane, cells);
  for (std::size_t i = 0; i < 3; ++i) {
    box.low[i] = std::max(box.low[i] - block_side * place[i], 0);
    box.high[i] = std::min(box.high[i] - block_side * place[i], block_side - 1);
  }
  constexpr Float4 steps{0, 1, 2, 3};
  const auto offset = [&](std::int32_t i, int axis) {
    return static_cast<float>(block_side * place[static_cast<std::size_t>(axis)] + i) - plane.point[axis] * cells;
  };
  const float radius = plane.point[3] * cells;
  for (std::int32_t z = box.low[2]; z <= box.high[2]; ++z) {
    for (std::int32_t y = box.low[1]; y <= box.high[1]; ++y) {
      const float dy = offset(y, 1), dz = offset(z, 2);
      const float rest = dy * dy + dz * dz;
      if (rest >= radius * radius) continue;
      for (std::int32_t x = box.low[0] & ~3; x <= box.high[0]; x += 4) {
        const Float4 d[3] = {offset(x, 0) + steps, all(dy), all(dz)};
        body(corner_in_block(x, y, z) / 4, d, d[0] * d[0] + rest);
      }
    }
  }
}

// Finds for each corner the normal of the nearest plane, among the planes that reach the corner.
void find_nearest(const std::vector<SupportPlane>& planes, std::span<const std::uint32_t> mine, float cells,
                  const CellIndex& place, std::array<Fours, 3>& normals) {
  Fours least;
  least.fill(all(std::numeric_limits<float>::max()));
  for (const std::uint32_t i : mine) {
    const SupportPlane& plane = planes[i];
    const float radius = plane.point[3] * cells;
    each_four(plane, cells, place, [&](std::size_t four, const Float4(&)[3], Float4 square) {
      const Int4 nearer = (square < least[four]) & (square < radius * radius);
      least[four] = nearer ? square : least[four];
      for (int k = 0; k < 3; ++k) {
        Float4& normal = normals[static_cast<std::size_t>(k)][four];
        normal = nearer ? all(plane.normal[k]) : normal;
      }
    });
  }
}

void evaluate_block(const std::vector<SupportPlane>& planes, std::span<const std::uint32_t> mine, float cells,
                    const CellIndex& place, BlockValues& values) {
  std::array<Fours, 3> nearest{};
  find_nearest(planes, mine, cells, place, nearest);
  Fours weights{}, heights{};
  for (const std::uint32_t i : mine) {
    const SupportPlane& plane = planes[i];
    const float radius = plane.point[3] * cells, scale = 1 / (radius * radius);
    const float band = band_of(radius);
    const Float4 n[3] = {all(plane.normal[0]), all(plane.normal[1]), all(plane.normal[2])};
    each_four(plane, cells, place, [&](std::size_t four, const Float4(&d)[3], Float4 square) {
      const Float4 facing = n[0] * nearest[0][four] + n[1] * nearest[1][four] + n[2] * nearest[2][four];
      const Float4 height = d[0] * n[0] + d[1] * n[1] + d[2] * n[2];
      const Float4 t = square * scale;
      const Int4 counts = (t < 1) & (facing > 0) & (height <= band) & (height >= -band);
      const Float4 weight = counts ? hermite(t) * facing * plane.normal[3] : Float4{};
      weights[four] += weight;
      heights[four] += weight * height;
    });
  }
  for (std::size_t i = 0; i < block_corners; ++i) {
    const float weight = weights[i / 4][i % 4];
    values[i] = weight > 0 ? heights[i / 4][i % 4] / weight : no_value;
  }
}

}  // namespace

Blocks evaluate(const TransitionLayer& layer, unsigned level, const Workers& workers) {
  const auto cells = static_cast<float>(1U << level);
  Blocks blocks{.table = CellTable(layer.planes.size() / 8), .places = {}, .values = {}, .begins = {0}, .planes = {}};
  std::vector<std::uint32_t>& begins = blocks.begins;  // initially the number of planes
  for (const SupportPlane& plane : layer.planes) {
    each_block(box_of(plane, cells), [&](const CellIndex& place) {
      const auto next = static_cast<std::uint32_t>(blocks.places.size());
      const std::uint32_t number = blocks.table.insert(key_of(place), next);
      if (number == next) {
        blocks.places.push_back(place);
        begins.push_back(0);
      }
      ++begins[number + 1];
    });
  }
  for (std::size_t i = 1; i < begins.size(); ++i) begins[i] += begins[i - 1];
  blocks.planes.resize(begins.back());
  std::vector<std::uint32_t> at(begins.begin(), begins.end() - 1);
  for (std::uint32_t i = 0; i < layer.planes.size(); ++i) {
    each_block(box_of(layer.planes[i], cells),
               [&](const CellIndex& place) { blocks.planes[at[blocks.table.find(key_of(place))]++] = i; });
  }
  blocks.values.resize(blocks.places.size());
  workers.each(blocks.places.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      evaluate_block(layer.planes, blocks.planes_of(static_cast<std::uint32_t>(i)), cells, blocks.places[i],
                     blocks.values[i]);
    }
  });
  return blocks;
}

}  // namespace glark::reconstruct
