// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/fill/gradients.h"

#include <algorithm>
#include <array>
#include <limits>

#include "glark/clients/maps/fill/diffusion.h"

namespace glark::maps {
namespace {

using common::Float4;

constexpr std::size_t most_steps = 10000;
constexpr std::size_t enough_steps = 500;                // a step carries values one texel farther
constexpr std::size_t most_work = std::size_t{4} << 30;  // texels times steps beyond which so many are enough
constexpr unsigned calm_steps = 4;  // so many in a row change little, because a single one may do so by chance

using Sums = std::array<double, 4>;  // of each channel

void add_product(Sums& sums, Float4 a, Float4 b) {
  const Float4 product = a * b;
  for (std::size_t lane = 0; lane < 4; ++lane) sums[lane] += static_cast<double>(product[lane]);
}

// 0 where a channel is solved.
Float4 quotient(const Sums& a, const Sums& b) {
  Float4 result{};
  for (std::size_t lane = 0; lane < 4; ++lane) result[lane] = b[lane] > 0 ? static_cast<float>(a[lane] / b[lane]) : 0;
  return result;
}

float greatest_of(Float4 values) { return std::max({values[0], values[1], values[2], values[3]}); }

}  // namespace

Float4 Gradients::around(const std::vector<Float4>& values, std::uint32_t texel, float& count) const {
  const std::uint32_t x = texel % width_;
  Float4 sum{};
  count = 0;
  const auto add = [&](bool is_there, std::uint32_t neighbour) {
    if (!is_there) return;
    sum += values[neighbour];
    ++count;
  };
  add(x > 0, texel - 1);
  add(x + 1 < width_, texel + 1);
  add(texel >= width_, texel - width_);
  add(texel + width_ < values.size(), texel + width_);
  return sum;
}

void Gradients::load(const Raster& raster, unsigned first, const TexelLists& lists) {
  width_ = raster.width;
  channels_ = std::min(raster.channels - first, 4U);
  const std::size_t size = raster.weights.size();
  values_.assign(size, Float4{});
  direction_.assign(size, Float4{});
  constexpr float infinity = std::numeric_limits<float>::infinity();
  least_ = Float4{infinity, infinity, infinity, infinity};
  greatest_ = -least_;
  for (std::size_t i = 0; i < size; ++i) {
    for (unsigned c = 0; c < channels_; ++c) values_[i][c] = raster.values[i * raster.channels + first + c];
    if (!(raster.weights[i] > 0)) continue;
    least_ = common::least(least_, values_[i]);
    greatest_ = common::greatest(greatest_, values_[i]);
  }
  texels_.clear();
  for (const ListedTexel& texel : lists.inner) texels_.push_back(texel.index);
  for (const BorderTexel& texel : lists.border) texels_.push_back(texel.index);
  std::sort(texels_.begin(), texels_.end());
  residual_.resize(texels_.size());
  image_.resize(texels_.size());
}

void Gradients::store(const Raster& raster, unsigned first) const {
  for (const std::uint32_t i : texels_) {
    const Float4 value = common::least(common::greatest(values_[i], least_), greatest_);
    for (unsigned c = 0; c < channels_; ++c) raster.values[i * raster.channels + first + c] = value[c];
  }
}

unsigned Gradients::improve(const Raster& raster, unsigned first, const TexelLists& lists, float tolerance) {
  load(raster, first, lists);
  Float4 inverse_range{};
  for (unsigned c = 0; c < channels_; ++c)
    inverse_range[c] = greatest_[c] > least_[c] ? 1 / (greatest_[c] - least_[c]) : 0;
  Sums squares{};
  float count = 0;
  for (std::size_t k = 0; k < texels_.size(); ++k) {
    const Float4 sum = around(values_, texels_[k], count);
    residual_[k] = direction_[texels_[k]] = sum - values_[texels_[k]] * count;
    add_product(squares, residual_[k], residual_[k]);
  }
  const auto last =
      static_cast<unsigned>(std::clamp(most_work / std::max<std::size_t>(1, texels_.size()), enough_steps, most_steps));
  unsigned step = 0;
  for (unsigned calm = 0; step < last && calm < calm_steps; ++step) {
    Sums energy{};
    for (std::size_t k = 0; k < texels_.size(); ++k) {
      const Float4 sum = around(direction_, texels_[k], count);
      image_[k] = direction_[texels_[k]] * count - sum;
      add_product(energy, image_[k], direction_[texels_[k]]);
    }
    const Float4 length = quotient(squares, energy);
    Float4 most{};
    Sums next{};
    for (std::size_t k = 0; k < texels_.size(); ++k) {
      const Float4 change = direction_[texels_[k]] * length;
      values_[texels_[k]] += change;
      most = common::greatest(most, common::greatest(change, -change));
      residual_[k] -= image_[k] * length;
      add_product(next, residual_[k], residual_[k]);
    }
    const Float4 part = quotient(next, squares);
    for (std::size_t k = 0; k < texels_.size(); ++k)
      direction_[texels_[k]] = residual_[k] + direction_[texels_[k]] * part;
    squares = next;
    calm = greatest_of(most * inverse_range) <= tolerance ? calm + 1 : 0;
  }
  store(raster, first);
  return step;
}

}  // namespace glark::maps
