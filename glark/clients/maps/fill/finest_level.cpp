// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/fill/finest_level.h"

#include <algorithm>
#include <limits>

namespace glark::maps {
namespace {

using common::greatest;
using common::Int4;
using common::least;

Float4 all(float value) { return Float4{value, value, value, value}; }
Float4 absolute(Float4 a) { return greatest(a, -a); }

// The values if the weight is that of a sample, else zeros, also for values that are no numbers.
Float4 if_known(float weight, Float4 values) {
  const int mask = weight > 0 ? -1 : 0;
  return std::bit_cast<Float4>(std::bit_cast<Int4>(values) & Int4{mask, mask, mask, mask});
}

}  // namespace

template <unsigned channels>
FinestLevel<channels>::FinestLevel(float* values, std::size_t stride, const TexelLists& lists,
                                   std::span<const float> weights)
    : values_(values), stride_(stride), row_(stride * lists.map.width), lists_(lists), weights_(weights) {}

template <unsigned channels>
template <class Visit>
unsigned FinestLevel<channels>::for_neighbours(const BorderTexel& texel, const Visit& visit) const {
  const std::uint32_t width = lists_.map.width;
  const std::array<std::uint32_t, 4> around{texel.index - 1, texel.index + 1, texel.index - width, texel.index + width};
  unsigned count = 0;
  for (unsigned k = 0; k < 4; ++k) {
    if (!texel.has_neighbour[k]) continue;
    visit(around[k]);
    ++count;
  }
  return count;
}

template <unsigned channels>
void FinestLevel<channels>::fill_single() {
  for (const std::uint32_t index : lists_.single)
    for (unsigned b = 0; b < Blocks::count; ++b) Blocks::store(at(index), b, sum_around(at(index), b) * 0.25F);
}

template <unsigned channels>
void FinestLevel<channels>::find_range() {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  least_.fill(all(infinity));
  greatest_.fill(all(-infinity));
  for (std::uint32_t i = 0; i < weights_.size(); ++i) {
    const bool is_known = weights_[i] > 0;
    for (unsigned b = 0; b < Blocks::count; ++b) {
      const Float4 values = Blocks::load(at(i), b);
      least_[b] = least(is_known ? values : least_[b], least_[b]);
      greatest_[b] = greatest(is_known ? values : greatest_[b], greatest_[b]);
    }
  }
  for (unsigned b = 0; b < Blocks::count; ++b) {
    const Float4 range = greatest_[b] - least_[b];
    inverse_range_[b] = range > 0 ? 1 / range : Float4{};
  }
}

template <unsigned channels>
void FinestLevel<channels>::restrict_samples(Level& level) const {
  Float4* sums = level.right_sides.data();
  const std::uint32_t width = lists_.map.width;
  for (const ListedTexel& texel : lists_.inner) {
    const std::uint32_t i = texel.index;
    const float* from = at(i);
    for (unsigned b = 0; b < Blocks::count; ++b) {
      const Float4 sum = (if_known(weights_[i - 1], Blocks::load(from - stride_, b)) +
                          if_known(weights_[i + 1], Blocks::load(from + stride_, b))) +
                         (if_known(weights_[i - width], Blocks::load(from - row_, b)) +
                          if_known(weights_[i + width], Blocks::load(from + row_, b)));
      sums[std::size_t{texel.child / 4} * Blocks::count + b] += sum;
    }
  }
  for (const BorderTexel& texel : lists_.border) {
    Float4* to = sums + std::size_t{texel.child / 4} * Blocks::count;
    for_neighbours(texel, [&](std::uint32_t i) {
      for (unsigned b = 0; b < Blocks::count; ++b) to[b] += if_known(weights_[i], Blocks::load(at(i), b));
    });
  }
}

template <unsigned channels>
void FinestLevel<channels>::restrict_residuals(Level& level) const {
  Float4* sums = level.right_sides.data();
  for (const ListedTexel& texel : lists_.inner) {
    const float* from = at(texel.index);
    for (unsigned b = 0; b < Blocks::count; ++b)
      sums[std::size_t{texel.child / 4} * Blocks::count + b] += sum_around(from, b) - Blocks::load(from, b) * 4.0F;
  }
  for (const BorderTexel& texel : lists_.border) {
    Float4* to = sums + std::size_t{texel.child / 4} * Blocks::count;
    const float* from = at(texel.index);
    for_neighbours(texel, [&](std::uint32_t i) {
      for (unsigned b = 0; b < Blocks::count; ++b) to[b] += Blocks::load(at(i), b) - Blocks::load(from, b);
    });
  }
}

template <unsigned channels>
void FinestLevel<channels>::set(const Level& level) {
  const auto set_all = [&](const auto& texels) {
    for (const auto& texel : texels)
      for (unsigned b = 0; b < Blocks::count; ++b)
        Blocks::store(at(texel.index), b, level.children[std::size_t{texel.child} * Blocks::count + b]);
  };
  set_all(lists_.inner);
  set_all(lists_.border);
}

template <unsigned channels>
float FinestLevel<channels>::relative(const Values& change) const {
  float most = 0;
  for (unsigned b = 0; b < Blocks::count; ++b) {
    const Float4 part = change[b] * inverse_range_[b];
    for (unsigned lane = 0; lane < Blocks::lanes; ++lane) most = std::max(most, part[lane]);
  }
  return most;
}

template <unsigned channels>
float FinestLevel<channels>::correct(const Level& level) {
  Values change{};
  const auto correct_all = [&](const auto& texels) {
    for (const auto& texel : texels) {
      Values moved;  // all blocks before the first is stored, because they may overlap
      for (unsigned b = 0; b < Blocks::count; ++b) {
        const Float4 step = level.children[std::size_t{texel.child} * Blocks::count + b];
        change[b] = greatest(change[b], absolute(step));
        moved[b] = least(greatest(Blocks::load(at(texel.index), b) + step, least_[b]), greatest_[b]);
      }
      for (unsigned b = 0; b < Blocks::count; ++b) Blocks::store(at(texel.index), b, moved[b]);
    }
  };
  correct_all(lists_.inner);
  correct_all(lists_.border);
  return relative(change);
}

template <unsigned channels>
template <bool is_measured>
float FinestLevel<channels>::sweep() {
  Values change{};
  const auto replace = [&](float* texel, unsigned block, Float4 values) {
    if constexpr (is_measured) change[block] = greatest(change[block], absolute(values - Blocks::load(texel, block)));
    Blocks::store(texel, block, values);
  };
  for (const BorderTexel& texel : lists_.border) {
    for (unsigned b = 0; b < Blocks::count; ++b) {
      Float4 sum{};
      const unsigned count = for_neighbours(texel, [&](std::uint32_t i) { sum += Blocks::load(at(i), b); });
      replace(at(texel.index), b, sum / static_cast<float>(count));
    }
  }
  const FinestLevel local = *this;  // no store to a texel can change it, so its members stay in registers
  for (const ListedTexel *texel = lists_.inner.data(), *end = texel + lists_.inner.size(); texel != end; ++texel) {
    float* values = local.at(texel->index);
    for (unsigned b = 0; b < Blocks::count; ++b) replace(values, b, local.sum_around(values, b) * 0.25F);
  }
  return is_measured ? relative(change) : 0;
}

template <unsigned channels>
void FinestLevel<channels>::smooth() {
  sweep<false>();
}

template <unsigned channels>
float FinestLevel<channels>::smooth_and_measure() {
  return sweep<true>();
}

template class FinestLevel<1>;
template class FinestLevel<2>;
template class FinestLevel<3>;
template class FinestLevel<4>;
template class FinestLevel<5>;
template class FinestLevel<6>;
template class FinestLevel<7>;
template class FinestLevel<8>;

}  // namespace glark::maps
