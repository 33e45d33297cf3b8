// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The resolution of each chart, and its place in the maps.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/maps/charts/chart.h"
#include "glark/clients/maps/charts/triangle2.h"

namespace glark::maps {

// A chart has this many texels around its rectangle. Places begin at multiples of it, so that one texel around each
// chart is left in the second mipmap level.
inline constexpr unsigned gutter = 4;
// An island of the mesh's own texture coordinates does not lie so. Its gutter reaches as far as the filter of the last kept
// level.
inline constexpr unsigned island_gutter = 8;
inline constexpr unsigned kept_levels = 3;  // the first mipmap levels, in which no texel belongs to two charts

struct Place {
  unsigned x = 0, y = 0;           // the first texel of the place in the maps
  unsigned width = 0, height = 0;  // with the gutter
  Point2 density{};                // texels for each unit of the chart's plane
  Point2 border{gutter, gutter};   // texels from the place's lower left corner to that of the chart's rectangle

  // Returns a point of the chart's plane in texels of the place. Texel (i, j) has its centre at (i + 0.5, j + 0.5).
  Point2 texel(const Chart& chart, Point2 plane) const {
    return {(plane[0] - chart.low[0]) * density[0] + border[0], (plane[1] - chart.low[1]) * density[1] + border[1]};
  }
};

struct Atlas {
  unsigned width = 0, height = 0;  // powers of two
  std::vector<Place> places;       // of the charts
  float scale = 1;                 // of the densities; below 1 if the texture memory is too small for the points
};

struct AtlasLimits {
  unsigned width = 0, height = 0;  // of the maps; 0: as small as possible, within these limits
  std::uint64_t most_texels = 0;
  unsigned most_side = 0;
  double most_density = 0;  // texels for each unit of length; 0: no limit
};

// wanted: the number of texels that each chart's triangles shall cover. Source: Boubekeur 2007, ch. 6.2.3; the aspect
// ratio there must be its square root.
// Errors: Error if the charts do not fit, even with one texel each.
Atlas pack(const std::vector<Chart>& charts, const Surface& surface, std::span<const double> wanted,
           const AtlasLimits& limits);

// Keeps each island of the mesh's own texture coordinates in its place in the texture. The size of the texture is chosen so
// that all islands together have the wanted number of texels, within the limits. Places may overlap.
Atlas keep_places(const std::vector<Chart>& islands, const Surface& surface, double wanted, const AtlasLimits& limits);

// The triangle of a chart in texels of its place.
Triangle2 triangle_in(const Chart& chart, const Place& place, const Surface& surface, std::uint32_t triangle);

}  // namespace glark::maps
