// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The values of one texel as vectors of four floats.
#pragma once

#include <algorithm>
#include <cstring>

#include "glark/clients/common/float4.h"

namespace glark::maps {

using common::Float4;

constexpr unsigned most_channels_at_once = 8;

constexpr unsigned blocks_of(unsigned channels) { return (channels + 3) / 4; }

// Loads and stores the `channels` values of a texel, 1 to 8. From four channels on, the last block may overlap the one
// before it: both have the same values in the shared channels, so all blocks are full.
template <unsigned channels>
struct TexelBlocks {
  static constexpr unsigned count = blocks_of(channels);
  static constexpr unsigned lanes = std::min(channels, 4U);

  static constexpr unsigned offset(unsigned block) { return std::min(4 * block, channels - lanes); }
  static Float4 load(const float* texel, unsigned block) {
    if constexpr (channels == 1) return Float4{texel[0], 0, 0, 0};
    if constexpr (channels == 2) return Float4{texel[0], texel[1], 0, 0};
    if constexpr (channels == 3) return Float4{texel[0], texel[1], texel[2], 0};
    Float4 values{};
    std::memcpy(&values, texel + offset(block), sizeof(values));
    return values;
  }
  static void store(float* texel, unsigned block, Float4 values) {
    if constexpr (channels >= 4) {
      std::memcpy(texel + offset(block), &values, sizeof(values));
    } else {
      for (unsigned lane = 0; lane < channels; ++lane) texel[lane] = values[lane];
    }
  }
};

}  // namespace glark::maps
