// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/reconstruct/contour/thin_edges.h"

#include <bitset>

#include "glark/clients/reconstruct/contour/thin_sides.h"
#include "glark/clients/reconstruct/contour/wide_block.h"

namespace glark::reconstruct {
namespace {

constexpr float margin = 2;            // corners within this distance of a thin sheet are looked at, in cells
constexpr float thickest = 2;          // the greatest thickness there, in cells
constexpr float farthest_ends = 1.3F;  // the greatest sum of the distances of an edge's ends from a sheet it crosses
constexpr std::ptrdiff_t fewest = 4;  // fewer planes of a block are no thin sheet, but a sharp groove or a stray sample
constexpr std::int32_t part = 4;      // planes are chosen for parts of this many corners along each axis
constexpr std::size_t steps_count = 8;  // the points along an edge, both ends included
constexpr float step = 1.0F / (steps_count - 1);

std::uint64_t edge_key(const CellIndex& corner, unsigned axis) { return 4 * key_of(corner) + axis; }

Float4 float_of(const CellIndex& corner) {
  return Float4{static_cast<float>(corner[0]), static_cast<float>(corner[1]), static_cast<float>(corner[2]), 0};
}

struct ThinBlock {
  std::uint32_t number;
  std::bitset<block_corners> corners;  // near a thin sheet
};

// Marks the corners around a plane.
void mark(const SupportPlane& plane, float cells, const CellIndex& place, std::bitset<block_corners>& corners) {
  CellIndex low{}, high{};
  for (std::size_t i = 0; i < 3; ++i) {
    const float middle = plane.point[static_cast<int>(i)] * cells - static_cast<float>(block_side * place[i]);
    low[i] = std::max(0, static_cast<std::int32_t>(std::ceil(middle - margin)));
    high[i] = std::min(block_side - 1, static_cast<std::int32_t>(std::floor(middle + margin)));
  }
  for (std::int32_t z = low[2]; z <= high[2]; ++z) {
    for (std::int32_t y = low[1]; y <= high[1]; ++y) {
      for (std::int32_t x = low[0]; x <= high[0]; ++x) corners.set(corner_in_block(x, y, z));
    }
  }
}

// Finds the planes near thin sheets, in the given blocks.
std::vector<std::uint8_t> thin_planes(const TransitionLayer& layer, const Opposites& opposites,
                                      const std::vector<ThinBlock>& blocks, const Blocks& all, const Workers& workers) {
  std::vector<std::uint8_t> result(layer.planes.size());
  for (const ThinBlock& block : blocks) {
    for (const std::uint32_t i : all.planes_of(block.number)) result[i] = 1;
  }
  workers.each(result.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) result[i] = result[i] != 0 && opposites.has(layer.planes[i]) ? 1 : 0;
  });
  return result;
}

std::vector<ThinBlock> thin_blocks(const TransitionLayer& layer, unsigned level, const Blocks& blocks,
                                   const Workers& workers) {
  const auto cells = static_cast<float>(1U << level);
  const Opposites opposites(layer, level);
  std::vector<ThinBlock> result;
  for (std::uint32_t number = 0; number < blocks.places.size(); ++number) {
    if (!opposites.are_alike(blocks.planes_of(number))) result.push_back({number, {}});
  }
  const std::vector<std::uint8_t> is_thin = thin_planes(layer, opposites, result, blocks, workers);
  workers.each(result.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      ThinBlock& block = result[i];
      const std::span<const std::uint32_t> planes = blocks.planes_of(block.number);
      if (std::count_if(planes.begin(), planes.end(), [&](std::uint32_t p) { return is_thin[p] != 0; }) < fewest)
        continue;
      for (const std::uint32_t plane : planes) {
        if (is_thin[plane] != 0) mark(layer.planes[plane], cells, blocks.places[block.number], block.corners);
      }
    }
  });
  std::erase_if(result, [](const ThinBlock& block) { return block.corners.none(); });
  return result;
}

// The crossings of the edges of one block.
struct Found {
  ThinEdges::Edge edge;
  std::vector<Crossing> crossings;
};

class Crossings {
 public:
  Crossings(const TransitionLayer& layer, float cells, Blocks& blocks) : blocks_(blocks), sides_(layer.planes, cells) {}

  // Evaluates the marked corners where the sheet is thin.
  void evaluate_corners(const ThinBlock& block) {
    each_part(
        block,
        [&](const CellIndex& at) {
          const std::uint32_t i = corner_in_block(at[0], at[1], at[2]);
          if (!(block.corners[i] || block.corners[i + 1] || block.corners[i + 2] || block.corners[i + 3])) return;
          const Float4 low = float_of(corner_at(blocks_.places[block.number], i));
          sides_.look_at(low, low + Float4{3, 0, 0, 0});
          const Float4 points[3] = {low[0] + Float4{0, 1, 2, 3}, splat<1>(low), splat<2>(low)};
          const FourValues four = sides_.at(points);
          for (std::uint32_t k = 0; k < 4; ++k) {
            const auto lane = static_cast<int>(k);
            if (block.corners[i + k] && four.apart[lane] <= thickest)
              blocks_.values[block.number][i + k] = four.value[lane];
          }
        },
        part);
  }

  void find(const ThinBlock& block, std::vector<Found>& found) {
    values_of(blocks_, block.number, values_);
    const CellIndex place = blocks_.places[block.number];
    each_part(
        block,
        [&](const CellIndex& at) {
          const std::uint32_t i = corner_in_block(at[0], at[1], at[2]);
          if (!block.corners[i]) return;
          const CellIndex corner = corner_at(place, i);
          for (unsigned axis = 0; axis < 3; ++axis) {
            CellIndex end = at;
            ++end[axis];
            const float from = values_[in_wide(at[0], at[1], at[2])], to = values_[in_wide(end[0], end[1], end[2])];
            if (from == no_value || to == no_value || std::abs(from) + std::abs(to) > farthest_ends) continue;
            Float4 high = float_of(corner);
            high[static_cast<int>(axis)] += 1;
            sides_.look_at(float_of(corner), high);
            std::vector<Crossing> crossings = along(corner, axis, from, to);
            if (!crossings.empty()) found.push_back({{corner, axis}, std::move(crossings)});
          }
        },
        1);
  }

 private:
  // Calls body for each corner of the parts that have marks, or for each first one of `stride` corners along x.
  template <typename Body>
  void each_part(const ThinBlock& block, const Body& body, std::int32_t stride) {
    constexpr std::int32_t parts = block_side / part;
    for (std::int32_t number = 0; number < parts * parts * parts; ++number) {
      const CellIndex low{number % parts * part, number / parts % parts * part, number / (parts * parts) * part};
      if (!has_marks(block, low)) continue;
      const Float4 corner = float_of(low) + float_of(blocks_.places[block.number]) * static_cast<float>(block_side);
      sides_.look_around(blocks_.planes_of(block.number), corner, corner + static_cast<float>(part));
      for (std::int32_t z = low[2]; z < low[2] + part; ++z) {
        for (std::int32_t y = low[1]; y < low[1] + part; ++y) {
          for (std::int32_t x = low[0]; x < low[0] + part; x += stride) body(CellIndex{x, y, z});
        }
      }
    }
  }

  static bool has_marks(const ThinBlock& block, const CellIndex& low) {
    for (std::int32_t z = low[2]; z < low[2] + part; ++z) {
      for (std::int32_t y = low[1]; y < low[1] + part; ++y) {
        for (std::int32_t x = low[0]; x < low[0] + part; ++x) {
          if (block.corners[corner_in_block(x, y, z)]) return true;
        }
      }
    }
    return false;
  }

  static CellIndex corner_at(const CellIndex& place, std::uint32_t i) {
    const auto at = static_cast<std::int32_t>(i);
    return {block_side * place[0] + at % block_side, block_side * place[1] + at / block_side % block_side,
            block_side * place[2] + at / (block_side * block_side)};
  }

  // Returns the crossings of an edge. The values at its ends are given, so that all edges of a corner agree.
  std::vector<Crossing> along(const CellIndex& corner, unsigned axis, float from, float to) const {
    std::array<float, steps_count> values{};
    std::array<Float4, steps_count> normals{};
    for (std::size_t half = 0; half < 2; ++half) {
      const Float4 low = float_of(corner);
      Float4 points[3] = {splat<0>(low), splat<1>(low), splat<2>(low)};
      points[axis] += (Float4{0, 1, 2, 3} + static_cast<float>(4 * half)) * step;
      const FourValues four = sides_.at(points);
      for (std::size_t k = 0; k < 4; ++k) {
        const auto lane = static_cast<int>(k);
        values[4 * half + k] = four.value[lane];
        normals[4 * half + k] = Float4{four.normal[0][lane], four.normal[1][lane], four.normal[2][lane], 0};
      }
    }
    values.front() = from;
    values.back() = to;
    std::vector<Crossing> crossings;
    for (std::size_t last = 0, i = 1; i < steps_count; ++i) {
      if (values[i] == no_value) continue;
      if ((values[last] < 0) != (values[i] < 0)) {
        const float share = values[last] / (values[last] - values[i]);
        const float at = (static_cast<float>(last) + share * static_cast<float>(i - last)) * step;
        // The surface faces the outside; of two sides, one does so along the edge.
        const float outwards = values[last] < 0 ? 1.0F : -1.0F;
        const int k = static_cast<int>(axis);
        crossings.push_back({at, outwards * (normals[last][k] - normals[i][k]) > 0 ? normals[last] : normals[i]});
      }
      last = i;
    }
    return crossings;
  }

  Blocks& blocks_;
  ThinSides sides_;
  WideValues values_{};
};

}  // namespace

void ThinEdges::add(const CellIndex& corner, unsigned axis, std::span<const Crossing> crossings) {
  table_.insert(edge_key(corner, axis), static_cast<std::uint32_t>(begins_.size() - 1));
  crossings_.insert(crossings_.end(), crossings.begin(), crossings.end());
  begins_.push_back(static_cast<std::uint32_t>(crossings_.size()));
  edges_.push_back({corner, axis});
}

std::span<const Crossing> ThinEdges::find(const CellIndex& corner, unsigned axis) const {
  const std::uint32_t i = table_.find(edge_key(corner, axis));
  if (i == CellTable::absent) return {};
  return std::span(crossings_).subspan(begins_[i], begins_[i + 1] - begins_[i]);
}

ThinEdges cross_thin_edges(const TransitionLayer& layer, unsigned level, Blocks& blocks, const Workers& workers) {
  const auto cells = static_cast<float>(1U << level);
  const std::vector<ThinBlock> thin = thin_blocks(layer, level, blocks, workers);
  workers.each(thin.size(), 4, [&](std::size_t begin, std::size_t end) {
    Crossings crossings(layer, cells, blocks);
    for (std::size_t i = begin; i < end; ++i) crossings.evaluate_corners(thin[i]);
  });
  std::vector<std::vector<Found>> found(thin.size());
  workers.each(thin.size(), 4, [&](std::size_t begin, std::size_t end) {
    Crossings crossings(layer, cells, blocks);
    for (std::size_t i = begin; i < end; ++i) crossings.find(thin[i], found[i]);
  });
  ThinEdges edges;
  for (const auto& of_block : found) {
    for (const Found& one : of_block) edges.add(one.edge.corner, one.edge.axis, one.crossings);
  }
  return edges;
}

}  // namespace glark::reconstruct
