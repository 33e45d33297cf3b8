// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/seam_list.h"

#include "glark/clients/maps/charts/segmentation.h"
#include "glark/clients/maps/seams/seams.h"

namespace glark::maps {
namespace {

struct SeamList {
  std::vector<Seam> seams;
  std::vector<SeamFrames> frames;  // [seams]
};

// The edges between charts.
class Collector {
 public:
  Collector(const Surface& surface, const std::vector<Chart>& charts, const Atlas& atlas)
      : surface_(surface), charts_(charts), atlas_(atlas), chart_of_(chart_of_triangles(charts, surface)) {}

  SeamList list() const {
    SeamList list;
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t other = surface_.neighbours[t][k];
        if (other == none || other < t || chart_of_[other] == chart_of_[t]) continue;
        const Ends ends{surface_.triangles[t][k], surface_.triangles[t][(k + 1) % 3]};
        list.seams.push_back({side(chart_of_[t], ends), side(chart_of_[other], ends)});
        list.frames.push_back({{surface_.normals[ends[0]], surface_.normals[ends[1]]},
                               {tangents(chart_of_[t], ends), tangents(chart_of_[other], ends)}});
      }
    }
    return list;
  }

 private:
  using Ends = std::array<std::uint32_t, 2>;

  SeamSide side(std::uint32_t c, const Ends& ends) const {
    const auto texel = [&](std::uint32_t vertex) {
      return atlas_.places[c].texel(charts_[c], charts_[c].project(surface_.positions[vertex]));
    };
    return {.chart = c, .from = texel(ends[0]), .to = texel(ends[1])};
  }
  std::array<Vector, 2> tangents(std::uint32_t c, const Ends& ends) const {
    return {tangent_at(charts_[c], ends[0]), tangent_at(charts_[c], ends[1])};
  }

  const Surface& surface_;
  const std::vector<Chart>& charts_;
  const Atlas& atlas_;
  std::vector<std::uint32_t> chart_of_;
};

}  // namespace

void equalise_seams(const Surface& surface, const std::vector<Chart>& charts, const Atlas& atlas, unsigned channels,
                    std::vector<ChartMap>& maps) {
  std::vector<ChartImage> images;
  for (ChartMap& map : maps) images.push_back({map.width, map.height, map.values});
  const SeamList list = Collector(surface, charts, atlas).list();
  equalise(images, channels, list.seams, {.levels = kept_levels, .first_level_channel = height_channel}, list.frames);
}

}  // namespace glark::maps
