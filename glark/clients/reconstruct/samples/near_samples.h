// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The samples in a box, in groups of four, one in each lane.
#pragma once

#include <span>

#include "glark/clients/reconstruct/samples/octree.h"

namespace glark::reconstruct {

struct FourSamples {
  Float4 position[3];
  Float4 normal[3];
  Int4 colour;  // packed
};

// Red, green and blue as the bits of a float. It is never denormal, because comparing denormals may be slow.
inline constexpr std::uint32_t packed_bits = 0x40000000;
inline float pack_colour(const std::uint8_t* rgb) {
  return std::bit_cast<float>(packed_bits | std::uint32_t{rgb[0]} | std::uint32_t{rgb[1]} << 8U |
                              std::uint32_t{rgb[2]} << 16U);
}
// Each channel is 0 to 255; red is channel 0.
inline Float4 unpack_colour(Int4 packed, int channel) {
  return __builtin_convertvector((packed >> (8 * channel)) & 255, Float4);
}

class NearSamples {
 public:
  // Collects the samples of the box low .. high.
  void gather(const Octree& octree, Float4 low, Float4 high);
  bool covers(Float4 low, Float4 high) const;
  // Unused lanes of the last group hold samples far away.
  std::span<const FourSamples> all() const { return samples_; }

 private:
  std::vector<Record> inside_;
  std::vector<FourSamples> samples_;
  Float4 low_{1, 1, 1, 0}, high_{};
};

}  // namespace glark::reconstruct
