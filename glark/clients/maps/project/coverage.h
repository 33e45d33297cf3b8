// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The triangle under each texel of a chart.
#pragma once

#include <vector>

#include "glark/clients/maps/atlas/atlas.h"

namespace glark::maps {

struct Coverage {
  std::vector<std::uint32_t> triangles;  // [width * height] of the place; `none` beyond the chart and its guests
  std::vector<Weights> weights;          // where the texel's centre lies in its triangle
};

// A chart's own triangles come first where its guests overlap them.
Coverage cover(const Chart& chart, const Place& place, const Surface& surface);

// The nearest place of the chart's own triangles, for texels up to two texels beyond them. Where a seam is filtered, the
// shader has the tangents and normals of these places.
Coverage nearest_places(const Chart& chart, const Place& place, const Surface& surface);

// Replaces the normals of a chart by those of the coarse mesh. values: as in ChartMap.
void set_coarse_normals(const Chart& chart, const Surface& surface, const Coverage& coverage, unsigned channels,
                        std::vector<float>& values);

// Replaces the normals of a chart by those of its displaced surface. values: as in ChartMap, with all heights.
void set_normals_from_heights(const Chart& chart, const Place& place, const Surface& surface, const Coverage& coverage,
                              unsigned channels, std::vector<float>& values);

// Turns the normals of a chart into its tangent space, as the shader will turn them back. values: as in ChartMap.
void to_tangent_space(const Chart& chart, const Place& place, const Surface& surface, unsigned channels,
                      std::vector<float>& values);

}  // namespace glark::maps
