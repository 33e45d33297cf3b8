// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Source: Boubekeur 2007, ch. 3.4.1; Y. Ohtake et al., Multi-level Partition of Unity Implicits, 2003.
#include "glark/clients/reconstruct/blocks.h"

#include <algorithm>
#include <cmath>

namespace glark::vstree {
namespace {

constexpr float least_band = 2.5F;  // of cells, on either side of a plane

// Corners low .. high of the grid.
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

// body(corner, offset from the plane's point in cells, square of the distance by the radius), within its ball.
template <typename Body>
void each_corner(const SupportPlane& plane, float cells, const CellIndex& place, const Body& body) {
  Box box = box_of(plane, cells);
  for (std::size_t i = 0; i < 3; ++i) {
    box.low[i] = std::max(box.low[i] - block_side * place[i], 0);
    box.high[i] = std::min(box.high[i] - block_side * place[i], block_side - 1);
  }
  const Float4 point = without_fourth(plane.point) * cells;
  const float radius = plane.point[3] * cells;
  const float scale = 1 / (radius * radius);
  const Float4 low{static_cast<float>(block_side * place[0]), static_cast<float>(block_side * place[1]),
                   static_cast<float>(block_side * place[2]), 0};
  const Float4 start = low - point;
  for (std::int32_t z = box.low[2]; z <= box.high[2]; ++z) {
    for (std::int32_t y = box.low[1]; y <= box.high[1]; ++y) {
      for (std::int32_t x = box.low[0]; x <= box.high[0]; ++x) {
        const Float4 d = start + Float4{static_cast<float>(x), static_cast<float>(y), static_cast<float>(z), 0};
        const float t = dot(d, d) * scale;
        if (t < 1) body(corner_in_block(x, y, z), d, t);
      }
    }
  }
}

void evaluate_block(const std::vector<SupportPlane>& planes, std::span<const std::uint32_t> mine, float cells,
                    const CellIndex& place, BlockValues& values) {
  std::array<float, block_corners> least;
  std::array<std::uint32_t, block_corners> nearest;
  std::array<float, block_corners> weights{};
  least.fill(std::numeric_limits<float>::max());
  for (const std::uint32_t i : mine) {
    each_corner(planes[i], cells, place, [&](std::size_t corner, Float4, float t) {
      const float square = t * planes[i].point[3] * planes[i].point[3];
      if (square >= least[corner]) return;
      least[corner] = square;
      nearest[corner] = i;
    });
  }
  values.fill(0);
  for (const std::uint32_t i : mine) {
    const SupportPlane& plane = planes[i];
    const float band = std::max(least_band, 0.8F * plane.point[3] * cells);
    each_corner(plane, cells, place, [&](std::size_t corner, Float4 d, float t) {
      const float facing = dot(plane.normal, planes[nearest[corner]].normal);
      const float height = dot(d, plane.normal);
      if (facing <= 0 || std::abs(height) > band) return;
      const float away = 1 + t * (2 * std::sqrt(t) - 3);  // Hermite's kernel
      const float weight = away * facing * plane.normal[3];
      weights[corner] += weight;
      values[corner] += weight * height;
    });
  }
  for (std::size_t i = 0; i < block_corners; ++i) values[i] = weights[i] > 0 ? values[i] / weights[i] : no_value;
}

}  // namespace

Blocks evaluate(const TransitionLayer& layer, unsigned level, const Workers& workers) {
  const auto cells = static_cast<float>(1U << level);
  Blocks blocks{.table = CellTable(layer.planes.size() / 8), .places = {}, .values = {}};
  std::vector<std::uint32_t> begins(1);  // of the planes of each block, first their numbers
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
  std::vector<std::uint32_t> planes(begins.back()), at(begins.begin(), begins.end() - 1);
  for (std::uint32_t i = 0; i < layer.planes.size(); ++i) {
    each_block(box_of(layer.planes[i], cells),
               [&](const CellIndex& place) { planes[at[blocks.table.find(key_of(place))]++] = i; });
  }
  blocks.values.resize(blocks.places.size());
  workers.each(blocks.places.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::span<const std::uint32_t> mine(planes.data() + begins[i], begins[i + 1] - begins[i]);
      evaluate_block(layer.planes, mine, cells, blocks.places[i], blocks.values[i]);
    }
  });
  return blocks;
}

}  // namespace glark::vstree
