// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The texels that samples along seams depend on, numbered.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/maps/seams/seams.h"

namespace glark::maps {

// A set of texels of all charts, as bits. The members have numbers in the order of charts and texels.
class TouchedTexels {
 public:
  explicit TouchedTexels(std::span<const ChartImage> charts) {
    std::size_t texels = 0;
    for (const ChartImage& chart : charts) {
      first_.push_back(texels);
      texels += std::size_t{chart.width} * chart.height;
    }
    bits_.resize(texels / 64 + 1);
  }

  void insert(std::uint32_t chart, std::size_t texel) {
    const std::size_t at = first_[chart] + texel;
    bits_[at / 64] |= std::uint64_t{1} << at % 64;
  }
  // After the last insertion: numbers the texels.
  void finish() {
    before_.clear();
    size_ = 0;
    for (const std::uint64_t bits : bits_) {
      before_.push_back(static_cast<std::uint32_t>(size_));
      size_ += static_cast<std::size_t>(std::popcount(bits));
    }
  }
  std::size_t size() const { return size_; }
  bool contains(std::uint32_t chart, std::size_t texel) const {
    const std::size_t at = first_[chart] + texel;
    return (bits_[at / 64] >> at % 64 & 1U) != 0;
  }
  // The number of a texel of the set.
  std::uint32_t number(std::uint32_t chart, std::size_t texel) const {
    const std::size_t at = first_[chart] + texel;
    const std::uint64_t lower = bits_[at / 64] & ((std::uint64_t{1} << at % 64) - 1);
    return before_[at / 64] + static_cast<std::uint32_t>(std::popcount(lower));
  }
  // Calls visit(chart, texel, number) for each texel of the set, in the order of the numbers.
  template <class Visit>
  void for_each(const Visit& visit) const {
    std::uint32_t chart = 0, number = 0;
    for (std::size_t word = 0; word < bits_.size(); ++word) {
      for (std::uint64_t left = bits_[word]; left != 0; left &= left - 1) {
        const std::size_t at = word * 64 + static_cast<std::size_t>(std::countr_zero(left));
        while (chart + 1 < first_.size() && first_[chart + 1] <= at) ++chart;
        visit(chart, at - first_[chart], number++);
      }
    }
  }

 private:
  std::vector<std::size_t> first_;     // of each chart: its texels' first bit
  std::vector<std::uint64_t> bits_;    // of the texels of all charts
  std::vector<std::uint32_t> before_;  // for each word of bits: the members before it
  std::size_t size_ = 0;
};

}  // namespace glark::maps
