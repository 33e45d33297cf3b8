// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "glark/clients/maps/atlas/atlas.h"

namespace glark::maps {
namespace {

constexpr unsigned least_side = 64;
constexpr double least_part = 0.5;  // of the wanted texels

// How the texture covers the surface.
struct Measures {
  double area = 0, texture_area = 0;  // of the surface and of the texture, which has the area 1
  double along_s = 0, along_t = 0;  // the mean squares of the lengths on the surface along a texture from side to side
};

void add(const Surface& surface, std::uint32_t t, Measures& measures) {
  const auto& corners = surface.triangles[t];
  const auto& [a, b, c] = surface.texcoords[t];
  const Vector first = surface.positions[corners[1]] - surface.positions[corners[0]];
  const Vector second = surface.positions[corners[2]] - surface.positions[corners[0]];
  const auto area = static_cast<double>(common::length(common::cross(first, second))) / 2;
  const auto signed_area = static_cast<double>((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]));
  if (signed_area == 0) return;
  const auto squared = [&](Vector along) {
    const double length = static_cast<double>(common::length(along)) / signed_area;
    return length * length;
  };
  const double part = std::abs(signed_area) / 2;
  measures.area += area;
  measures.texture_area += part;
  // A sliver in the texture may have any stretch. So it counts by its area there.
  measures.along_s += part * squared(first * (c[1] - a[1]) - second * (b[1] - a[1]));
  measures.along_t += part * squared(second * (b[0] - a[0]) - first * (c[0] - a[0]));
}

struct Size {
  unsigned width = least_side, height = least_side;
  double texels() const { return static_cast<double>(width) * height; }
};

// Textures need not be square: a texel is about as wide as it is high on the surface.
Size least_size(const Measures& measures, unsigned most_side) {
  constexpr long most_doublings = 4;
  Size size;
  if (!(measures.along_s > 0 && measures.along_t > 0)) return size;
  const double ratio = std::sqrt(measures.along_s / measures.along_t);
  const long doublings = std::clamp(std::lround(std::log2(ratio)), -most_doublings, most_doublings);
  for (long i = 0; i < std::abs(doublings); ++i) {
    unsigned& side = doublings > 0 ? size.width : size.height;
    if (2 * side <= most_side) side *= 2;
  }
  return size;
}

// The texels of the place, with a gutter within the maps, on one axis: the first and the end.
std::array<unsigned, 2> range(float low, float length, unsigned size) {
  const double texels = size;
  const auto at = [&](double texel) { return static_cast<unsigned>(std::clamp(texel, 0.0, texels)); };
  const double first = std::floor(static_cast<double>(low) * texels);
  const double end = std::ceil(static_cast<double>(low + length) * texels);
  return {at(std::min(first, texels - 1) - island_gutter), at(std::max(end, 1.0) + island_gutter)};
}

Place place_of(const Chart& island, const Size& size) {
  const auto [left, right] = range(island.low[0], island.size[0], size.width);
  const auto [bottom, top] = range(island.low[1], island.size[1], size.height);
  Place place{.x = left, .y = size.height - top, .width = right - left, .height = top - bottom};
  place.density = {static_cast<float>(size.width), static_cast<float>(size.height)};
  place.border = {island.low[0] * place.density[0] - static_cast<float>(left),
                  island.low[1] * place.density[1] - static_cast<float>(bottom)};
  return place;
}

}  // namespace

Atlas keep_places(const std::vector<Chart>& islands, const Surface& surface, double wanted, const AtlasLimits& limits) {
  Measures measures;
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) add(surface, t, measures);
  if (limits.most_density > 0) wanted = std::min(wanted, limits.most_density * limits.most_density * measures.area);
  Size size = least_size(measures, limits.most_side);
  if (limits.width > 0) size = {limits.width, limits.height};
  const auto has_enough = [&](double part) { return size.texels() * measures.texture_area >= part * wanted; };
  while (limits.width == 0 && !has_enough(least_part)) {
    if (4 * size.texels() > static_cast<double>(limits.most_texels) ||
        2 * std::max(size.width, size.height) > limits.most_side)
      break;
    size = {2 * size.width, 2 * size.height};
  }
  Atlas atlas{.width = size.width, .height = size.height, .places = {}, .scale = 1};
  if (!has_enough(least_part))
    atlas.scale = static_cast<float>(std::sqrt(size.texels() * measures.texture_area / wanted));
  for (const Chart& island : islands) atlas.places.push_back(place_of(island, size));
  return atlas;
}

}  // namespace glark::maps
