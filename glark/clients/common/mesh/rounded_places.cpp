// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/common/mesh/rounded_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <vector>

#include "glark/clients/common/mesh/half_edges.h"

namespace glark::common {
namespace {

constexpr float rounding = 0x1p-21F;

using Place = std::array<float, 3>;

float longest_side(std::span<const float> positions) {
  float longest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    float low = std::numeric_limits<float>::max(), high = std::numeric_limits<float>::lowest();
    for (std::size_t i = axis; i < positions.size(); i += 3) {
      low = std::min(low, positions[i]);
      high = std::max(high, positions[i]);
    }
    longest = std::max(longest, high - low);
  }
  return longest;
}

Place place_of(std::span<const float> positions, std::uint32_t i) {
  return {positions[3 * std::size_t{i}], positions[3 * std::size_t{i} + 1], positions[3 * std::size_t{i} + 2]};
}

// The places that were chosen so far, in cells. Almost all places have all that is within reach in their own cell.
class Chosen {
 public:
  explicit Chosen(float reach) : reach_(reach) {}

  // Returns the first chosen place within the reach, or chooses this one.
  Place nearest(const Place& place) {
    for (unsigned corner = 0; corner < 8; ++corner) {
      const std::uint64_t cell = cell_of(place, corner);
      if (corner > 0 && cell == cell_of(place, 0)) continue;
      const auto [begin, end] = cells_.equal_range(cell);
      const auto found = std::find_if(begin, end, [&](const auto& entry) { return is_near(entry.second, place); });
      if (found != end) return found->second;
    }
    for (unsigned corner = 0; corner < 8; ++corner) {
      const std::uint64_t cell = cell_of(place, corner);
      if (corner == 0 || cell != cell_of(place, 0)) cells_.emplace(cell, place);
    }
    return place;
  }

 private:
  static constexpr float cell_reaches = 64;  // the width of a cell, in reaches

  // A number for the cell at a corner of the cube around the place. Different cells may have the same number.
  std::uint64_t cell_of(const Place& place, unsigned corner) const {
    std::uint64_t number = 0;
    for (unsigned k = 0; k < 3; ++k) {
      const float at = place[k] + ((corner >> k & 1U) != 0 ? reach_ : -reach_);
      const auto cell = static_cast<std::int64_t>(std::floor(at / (cell_reaches * reach_)));
      number = (number ^ static_cast<std::uint64_t>(cell)) * 0x9e3779b97f4a7c15ULL;
      number ^= number >> 29U;
    }
    return number;
  }

  bool is_near(const Place& a, const Place& b) const {
    return std::abs(a[0] - b[0]) <= reach_ && std::abs(a[1] - b[1]) <= reach_ && std::abs(a[2] - b[2]) <= reach_;
  }

  float reach_;
  std::unordered_multimap<std::uint64_t, Place> cells_;
};

}  // namespace

std::size_t join_rounded_places(std::span<float> positions, std::span<const std::uint32_t> triangles) {
  const float side = longest_side(positions);
  if (!(side > 0) || triangles.empty()) return 0;
  const std::vector<std::uint32_t> opposites = opposite_of({triangles.begin(), triangles.end()}, positions.size() / 3);
  std::vector<bool> is_boundary(positions.size() / 3);
  for (std::uint32_t i = 0; i < opposites.size(); ++i)
    if (opposites[i] == no_half_edge) is_boundary[triangles[i]] = is_boundary[triangles[next_corner(i)]] = true;
  Chosen chosen(rounding * side);
  std::size_t moved = 0;
  for (std::uint32_t i = 0; i < is_boundary.size(); ++i) {
    if (!is_boundary[i]) continue;
    const Place old = place_of(positions, i), place = chosen.nearest(old);
    moved += place != old ? 1 : 0;
    std::copy(place.begin(), place.end(), &positions[3 * std::size_t{i}]);
  }
  return moved;
}

}  // namespace glark::common
