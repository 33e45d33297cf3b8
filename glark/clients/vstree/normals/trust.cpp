// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/vstree/normals/trust.h"

#include <algorithm>
#include <cmath>

namespace glark::vstree {
namespace {

constexpr std::size_t grain = 4096;
constexpr float in_plane = 0.06F;  // the squared sine of the slope up to which a neighbour lies in a sample's plane
constexpr float on_plane = 0.01F;  // the same, for a doubtful sample and the plane of a trusted neighbour
constexpr float doubtful = 0.8F;
constexpr float trusted = 0.9F;
constexpr float agreeing = 0.9F;   // the cosine of the normals of trusted neighbours that agree
constexpr int least_agreeing = 4;  // neighbours

bool lies_in(Float4 way, Float4 normal, float slope) {
  const float along = dot(way, normal);
  return along * along <= slope * dot(way, way);
}

}  // namespace

std::vector<float> trust_in(std::span<const Float4> normals, std::span<const Float4> points,
                            std::span<const std::uint32_t> neighbours, std::size_t each, const Workers& workers) {
  std::vector<float> trust(points.size());
  workers.each(points.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      float sum = 0;
      int count = 0;
      for (const std::uint32_t k : neighbours.subspan(i * each, each)) {
        if (k == i || !lies_in(points[k] - points[i], normals[i], in_plane)) continue;
        sum += std::abs(dot(normals[i], normals[k]));
        ++count;
      }
      trust[i] = count > 0 ? std::min(1.0F, sum / static_cast<float>(count)) : 0;
    }
  });
  return trust;
}

void mend_doubtful(std::span<Float4> normals, std::span<const Float4> points, std::span<const std::uint32_t> neighbours,
                   std::size_t each, std::span<const float> trust, const std::vector<bool>& given,
                   const Workers& workers) {
  // Only trusted normals are read, and only doubtful ones are written. So no thread reads what another one writes.
  workers.each(points.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (given[i] || trust[i] > doubtful) continue;
      Float4 sum{};
      int count = 0;
      for (const std::uint32_t k : neighbours.subspan(i * each, each)) {
        if (trust[k] < trusted || !lies_in(points[k] - points[i], normals[k], on_plane)) continue;
        if (count > 0 && dot(normals[k], sum) < agreeing * static_cast<float>(count)) continue;
        sum += normals[k];
        ++count;
      }
      if (count >= least_agreeing) normals[i] = unit(sum);
    }
  });
}

}  // namespace glark::vstree
