// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/seam_list.h"

#include <cmath>

#include "glark/clients/maps/charts/segmentation.h"
#include "glark/clients/maps/seams/seams.h"

namespace glark::maps {
namespace {

std::vector<Seam> seams_of(const Surface& surface, const std::vector<Chart>& charts, const Atlas& atlas) {
  const std::vector<std::uint32_t> chart_of = chart_of_triangles(charts, surface);
  const auto side = [&](std::uint32_t t, std::uint32_t from, std::uint32_t to) {
    const std::uint32_t c = chart_of[t];
    const auto texel = [&](std::uint32_t vertex) {
      return atlas.places[c].texel(charts[c], charts[c].project(surface.positions[vertex]));
    };
    return SeamSide{.chart = c, .from = texel(from), .to = texel(to)};
  };
  std::vector<Seam> seams;
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t neighbour = surface.neighbours[t][k];
      if (neighbour == none || neighbour < t || chart_of[neighbour] == chart_of[t]) continue;
      const std::uint32_t from = surface.triangles[t][k];
      const std::uint32_t to = surface.triangles[t][(k + 1) % 3];
      seams.push_back({side(t, from, to), side(neighbour, from, to)});
    }
  }
  return seams;
}

// Eight bits tell the direction of a short normal badly.
void limit_normals(ChartMap& map, unsigned channels) {
  constexpr float least = 0.5F, most = 1.2F;
  for (std::size_t at = 0; at < map.weights.size(); ++at) {
    float* n = map.values.data() + at * channels + normal_channel;
    const float length = std::hypot(n[0], n[1], n[2]);
    if (!(length > 0) || (length >= least && length <= most)) continue;
    for (std::size_t k = 0; k < 3; ++k) n[k] /= length;
  }
}

}  // namespace

void equalise_seams(const Surface& surface, const std::vector<Chart>& charts, const Atlas& atlas, unsigned channels,
                    std::vector<ChartMap>& maps) {
  std::vector<ChartImage> images;
  for (ChartMap& map : maps) images.push_back({map.width, map.height, map.values});
  equalise(images, channels, seams_of(surface, charts, atlas), {});
  for (ChartMap& map : maps) limit_normals(map, channels);
}

}  // namespace glark::maps
