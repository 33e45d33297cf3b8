// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/common/points/moments.h"

#include <algorithm>

namespace glark::common {

Moments Moments::of(std::span<const Record> records) {
  constexpr Float4 one{0, 0, 0, 1};
  const Float4 first = records.front().point();
  Float4 sum_x{}, sum_y{}, sum_z{};
  Moments moments;
  for (const Record& record : records) {
    const Float4 p = record.point() - first;
    const Float4 with_one = p + one;
    sum_x += splat<0>(p) * with_one;
    sum_y += splat<1>(p) * with_one;
    sum_z += splat<2>(p) * with_one;
    moments.normals += record.normal;
  }
  const auto count = static_cast<float>(records.size());
  const Float4 shift = Float4{sum_x[3], sum_y[3], sum_z[3], 0} / count;
  moments.mean = first + shift;
  moments.mean[3] = count;
  moments.products[0] = sum_x - splat<0>(shift) * shift * count;
  moments.products[1] = sum_y - splat<1>(shift) * shift * count;
  moments.products[2] = sum_z - splat<2>(shift) * shift * count;
  return moments;
}

void Moments::add(const Moments& other) {
  const float total = count() + other.count();
  const Float4 apart = without_fourth(other.mean - mean);
  const Float4 weighted = apart * (count() * other.count() / total);
  products[0] += other.products[0] + splat<0>(apart) * weighted;
  products[1] += other.products[1] + splat<1>(apart) * weighted;
  products[2] += other.products[2] + splat<2>(apart) * weighted;
  mean += apart * (other.count() / total);
  mean[3] = total;
  normals += other.normals;
}

float Moments::plane_error() const {
  const Float4 n = normal();
  float sum = products[0][0] + products[1][1] + products[2][2];
  if (dot(n, n) > 0) sum = dot(n, splat<0>(n) * products[0] + splat<1>(n) * products[1] + splat<2>(n) * products[2]);
  return std::max(sum, 0.0F) / count();
}

float Moments::normal_error() const {
  if (!(normals[3] > 0)) return 0;
  return std::max(0.0F, 2 - 2 * std::sqrt(dot(normals, normals)) / normals[3]);
}

}  // namespace glark::common
