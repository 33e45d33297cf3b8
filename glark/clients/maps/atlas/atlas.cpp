// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/atlas/atlas.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#define STB_RECT_PACK_IMPLEMENTATION
#define STBRP_STATIC
#include <stb/stb_rect_pack.h>

namespace glark::maps {
namespace {

constexpr unsigned least_side = 64;

// The density of a chart differs from the median by this factor at most. A few outliers would need most texels otherwise.
constexpr double most_contrast = 4;

double area_in_plane(const Chart& chart, const Surface& surface) {
  double area = 0;
  for (const std::uint32_t t : chart.triangles) {
    Triangle2 triangle;
    for (std::size_t k = 0; k < 3; ++k) triangle.corners[k] = chart.point(surface, t, k);
    area += std::abs(static_cast<double>(triangle.doubled_area())) / 2;
  }
  return area;
}

// Texels for each unit of length.
std::vector<double> densities_of(const std::vector<Chart>& charts, const Surface& surface,
                                 std::span<const double> wanted) {
  std::vector<double> densities(charts.size());
  std::vector<double> known;
  for (std::size_t i = 0; i < charts.size(); ++i) {
    const double area = area_in_plane(charts[i], surface);
    if (!(area > 0) || !(wanted[i] > 0)) continue;
    densities[i] = std::sqrt(wanted[i] / area);
    known.push_back(densities[i]);
  }
  if (known.empty()) return std::vector<double>(charts.size(), 0.0);
  std::nth_element(known.begin(), known.begin() + static_cast<std::ptrdiff_t>(known.size() / 2), known.end());
  const double median = known[known.size() / 2];
  for (double& density : densities) density = std::clamp(density, median / most_contrast, median * most_contrast);
  return densities;
}

unsigned side_of(float size, double density) {
  const double texels = std::ceil(static_cast<double>(size) * density) + 1 + 2 * gutter;
  const double most = 1U << 20U;  // such a chart fits nowhere
  return (static_cast<unsigned>(std::min(texels, most)) + gutter - 1) / gutter * gutter;
}

std::optional<Atlas> try_to_pack(const std::vector<Chart>& charts, const std::vector<double>& densities, double scale,
                                 unsigned width, unsigned height) {
  Atlas atlas{.width = width, .height = height, .places = {}, .scale = static_cast<float>(scale)};
  std::vector<stbrp_rect> rectangles(charts.size());
  std::uint64_t texels = 0;
  for (std::size_t i = 0; i < charts.size(); ++i) {
    Place& place = atlas.places.emplace_back();
    const auto density = static_cast<float>(densities[i] * scale);
    place.density = {density, density};
    place.width = side_of(charts[i].size[0], densities[i] * scale);
    place.height = side_of(charts[i].size[1], densities[i] * scale);
    if (place.width > width || place.height > height) return std::nullopt;
    texels += std::uint64_t{place.width} * place.height;
    // In units of the gutter, all coordinates are multiples of it.
    rectangles[i].id = static_cast<int>(i);
    rectangles[i].w = static_cast<stbrp_coord>(place.width / gutter);
    rectangles[i].h = static_cast<stbrp_coord>(place.height / gutter);
  }
  if (texels > std::uint64_t{width} * height) return std::nullopt;
  std::vector<stbrp_node> nodes(width / gutter);
  stbrp_context context{};
  stbrp_init_target(&context, static_cast<int>(width / gutter), static_cast<int>(height / gutter), nodes.data(),
                    static_cast<int>(nodes.size()));
  if (stbrp_pack_rects(&context, rectangles.data(), static_cast<int>(rectangles.size())) == 0) return std::nullopt;
  for (const stbrp_rect& rectangle : rectangles) {
    Place& place = atlas.places[static_cast<std::size_t>(rectangle.id)];
    place.x = static_cast<unsigned>(rectangle.x) * gutter;
    place.y = static_cast<unsigned>(rectangle.y) * gutter;
  }
  return atlas;
}

// The greatest densities that fit into the maps. most_scale: such densities do not fit.
Atlas reduce(const std::vector<Chart>& charts, const std::vector<double>& densities, unsigned width, unsigned height,
             double most_scale, const AtlasLimits& limits) {
  std::optional<Atlas> best = try_to_pack(charts, densities, 0, width, height);
  if (!best)
    throw Error(
        Element::option, 0,
        fmt::format("the maps may have {} texels, but the coarse mesh has {} charts, which need more; give more "
                    "texture_memory or a larger size, or a mesh of fewer triangles",
                    limits.most_texels, charts.size()));
  double low = 0, high = most_scale;
  for (int step = 0; step < 12; ++step) {
    const double middle = (low + high) / 2;
    if (auto atlas = try_to_pack(charts, densities, middle, width, height)) {
      best = std::move(atlas);
      low = middle;
    } else {
      high = middle;
    }
  }
  return std::move(*best);
}

// Fills maps of a given size.
Atlas fit(const std::vector<Chart>& charts, const std::vector<double>& densities, const Surface& surface,
          const AtlasLimits& limits) {
  double texels = 0;
  for (std::size_t i = 0; i < charts.size(); ++i)
    texels += area_in_plane(charts[i], surface) * densities[i] * densities[i];
  const double all = static_cast<double>(limits.width) * limits.height;
  Atlas atlas =
      reduce(charts, densities, limits.width, limits.height, texels > 0 ? std::sqrt(all / texels) : 1, limits);
  atlas.scale = std::min(atlas.scale, 1.0F);
  return atlas;
}

}  // namespace

Atlas pack(const std::vector<Chart>& charts, const Surface& surface, std::span<const double> wanted,
           const AtlasLimits& limits) {
  std::vector<double> densities = densities_of(charts, surface, wanted);
  if (limits.most_density > 0)
    for (double& density : densities) density = std::min(density, limits.most_density);
  if (limits.width > 0) return fit(charts, densities, surface, limits);
  unsigned width = least_side, height = least_side;
  while (true) {
    if (auto atlas = try_to_pack(charts, densities, 1, width, height)) return std::move(*atlas);
    unsigned& next = width > height ? height : width;
    if (2 * next > limits.most_side || 2 * std::uint64_t{width} * height > limits.most_texels) break;
    next *= 2;
  }
  return reduce(charts, densities, width, height, 1, limits);
}

Triangle2 triangle_in(const Chart& chart, const Place& place, const Surface& surface, std::uint32_t triangle) {
  Triangle2 result;
  for (std::size_t k = 0; k < 3; ++k) result.corners[k] = place.texel(chart, chart.point(surface, triangle, k));
  return result;
}

}  // namespace glark::maps
