// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/project/whole_map.h"

#include <algorithm>
#include <cmath>

#include "glark/clients/maps/fill/diffusion.h"

namespace glark::maps {
namespace {

// Finds the nearest island of each texel.
class Ownership {
 public:
  explicit Ownership(const Atlas& atlas)
      : width_(atlas.width),
        height_(atlas.height),
        owners_(std::size_t{width_} * height_, none),
        distances_(owners_.size(), static_cast<float>(island_gutter * island_gutter)) {}

  // The corners are in texels of the whole map.
  void add(const Triangle2& triangle, std::uint32_t island) {
    const auto [first_x, end_x] = range(triangle, 0, width_);
    const auto [first_y, end_y] = range(triangle, 1, height_);
    const bool has_area = triangle.doubled_area() != 0;
    for (int y = first_y; y < end_y; ++y) {
      for (int x = first_x; x < end_x; ++x) {
        const std::size_t at = static_cast<std::size_t>(y) * width_ + static_cast<std::size_t>(x);
        if (!(distances_[at] > 0)) continue;
        const Point2 centre{static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F};
        const float distance =
            has_area && contains(triangle, centre) ? 0 : nearest_on_boundary(triangle, centre).second;
        if (distance >= distances_[at]) continue;
        distances_[at] = distance;
        owners_[at] = island;
      }
    }
  }

  std::vector<std::uint32_t> take() { return std::move(owners_); }

 private:
  static std::array<int, 2> range(const Triangle2& triangle, std::size_t axis, unsigned size) {
    const auto& c = triangle.corners;
    const auto [low, high] = std::minmax({c[0][axis], c[1][axis], c[2][axis]});
    const int reach = island_gutter;
    return {std::max(static_cast<int>(std::floor(low)) - reach, 0),
            std::min(static_cast<int>(std::ceil(high)) + reach, static_cast<int>(size))};
  }
  static bool contains(const Triangle2& triangle, Point2 p) {
    const Weights w = triangle.weights_of(p);
    return w[0] >= 0 && w[1] >= 0 && w[2] >= 0;
  }

  unsigned width_, height_;
  std::vector<std::uint32_t> owners_;
  std::vector<float> distances_;  // squared, to the owner's triangles
};

Triangle2 moved(Triangle2 triangle, float x, float y) {
  for (Point2& corner : triangle.corners) corner = {corner[0] + x, corner[1] + y};
  return triangle;
}

std::vector<std::uint32_t> find_owners(const std::vector<Chart>& islands, const Surface& surface, const Atlas& atlas) {
  Ownership ownership(atlas);
  for (std::uint32_t c = 0; c < islands.size(); ++c) {
    const Place& place = atlas.places[c];
    for (const std::uint32_t t : islands[c].triangles)
      ownership.add(moved(triangle_in(islands[c], place, surface, t), static_cast<float>(place.x),
                          static_cast<float>(bottom_of(place, atlas))),
                    c);
  }
  return ownership.take();
}

void fill_gaps(unsigned channels, WholeMap& whole) {
  ChartMap& map = whole.map;
  for (std::size_t at = 0; at < map.weights.size(); ++at)
    if (!(map.weights[at] > 0)) map.values[at * channels + normal_channel + 2] = 1;
  if (channels != channels_with_colour) return;
  constexpr unsigned colours = 3;
  std::vector<float> values;
  for (std::size_t at = 0; at < map.weights.size(); ++at) {
    const float* const colour = &map.values[at * channels + colour_channel];
    values.insert(values.end(), colour, colour + colours);
  }
  diffuse({map.width, map.height, colours, values, map.weights});
  for (std::size_t at = 0; at < map.weights.size(); ++at)
    std::copy_n(&values[at * colours], colours, &map.values[at * channels + colour_channel]);
}

}  // namespace

WholeMap join_maps(const std::vector<Chart>& islands, const Surface& surface, const Atlas& atlas, unsigned channels,
                   std::vector<ChartMap>& maps) {
  WholeMap whole;
  whole.owners = find_owners(islands, surface, atlas);
  whole.map.resize({.width = atlas.width, .height = atlas.height}, channels);
  for (std::uint32_t c = 0; c < islands.size(); ++c) {
    const Place& place = atlas.places[c];
    for (std::size_t y = 0; y < place.height; ++y) {
      for (std::size_t x = 0; x < place.width; ++x) {
        const std::size_t to = (bottom_of(place, atlas) + y) * atlas.width + place.x + x;
        if (whole.owners[to] != c) continue;
        whole.map.weights[to] = 1;
        std::copy_n(&maps[c].values[(y * place.width + x) * channels], channels, &whole.map.values[to * channels]);
      }
    }
    maps[c] = {};
  }
  fill_gaps(channels, whole);
  return whole;
}

}  // namespace glark::maps
