// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/fill/texel_lists.h"

#include <algorithm>

namespace glark::maps {
namespace {

// Returns the number of texels with samples.
std::size_t mark(std::span<const float> weights, StateMap& map) {
  map.states.assign(map.stride() * (std::size_t{map.height} + 2), TexelState::outside);
  std::size_t known = 0;
  for (unsigned y = 0; y < map.height; ++y) {
    const float* from = weights.data() + std::size_t{y} * map.width;
    TexelState* to = map.states.data() + map.at(0, y);
    unsigned known_of_row = 0;
    for (unsigned x = 0; x < map.width; ++x) {
      to[x] = from[x] > 0 ? TexelState::known : TexelState::unknown;
      known_of_row += from[x] > 0 ? 1 : 0;
    }
    known += known_of_row;
  }
  return known;
}

// Writes the columns of the texels without samples. Returns their number.
std::size_t unknown_of_row(const StateMap& map, unsigned y, std::uint32_t* columns) {
  const TexelState* states = map.states.data() + map.at(0, y);
  std::size_t count = 0;
  for (unsigned x = 0; x < map.width; ++x) {
    columns[count] = x;
    count += states[x] == TexelState::unknown ? 1 : 0;
  }
  return count;
}

}  // namespace

void TexelLists::build(unsigned width, unsigned height, std::span<const float> weights) {
  map.width = width;
  map.height = height;
  known = mark(weights, map);
  single.clear();
  inner.clear();
  border.clear();
  odd.clear();
  row.resize(width);
  const std::size_t stride = map.stride();
  for (unsigned y = 0; y < height; ++y) {
    const std::size_t count = unknown_of_row(map, y, row.data());
    const std::size_t odd_before = odd.size();
    for (std::size_t k = 0; k < count; ++k) {
      const unsigned x = row[k];
      const std::uint32_t index = y * width + x;
      const std::uint32_t child = 4 * (y / 2 * ((width + 1) / 2) + x / 2) + quadrant_of(x, y);
      TexelState* state = map.states.data() + map.at(x, y);
      if (x == 0 || x + 1 == width || y == 0 || y + 1 == height) {
        border.push_back({index, child, {x > 0, x + 1 < width, y > 0, y + 1 < height}});
      } else if (state[-1] == TexelState::known && state[1] == TexelState::known &&
                 *(state - stride) == TexelState::known && state[stride] == TexelState::known) {
        *state = TexelState::outside;
        single.push_back(index);
      } else if ((x + y) % 2 == 0) {
        inner.push_back({index, child});
      } else {
        odd.push_back({index, child});
      }
    }
    inner.insert(inner.end(), odd.begin(), odd.begin() + static_cast<std::ptrdiff_t>(odd_before));
    odd.erase(odd.begin(), odd.begin() + static_cast<std::ptrdiff_t>(odd_before));
  }
  inner.insert(inner.end(), odd.begin(), odd.end());
}

}  // namespace glark::maps
