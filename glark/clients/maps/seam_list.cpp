// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/seam_list.h"

#include <algorithm>
#include <array>
#include <map>

#include "glark/clients/maps/charts/chart_edges.h"
#include "glark/clients/maps/fill/diffusion.h"
#include "glark/clients/maps/seams/samples.h"
#include "glark/clients/maps/seams/seams.h"

namespace glark::maps {
namespace {

struct SeamList {
  std::vector<Seam> seams;
  std::vector<SeamFrames> frames;  // [seams]
};

// The edges between charts, and those where two parts of one chart meet.
class Collector {
 public:
  Collector(const Surface& surface, const std::vector<Chart>& charts, const Atlas& atlas)
      : surface_(surface), charts_(charts), atlas_(atlas), edges_(surface, charts) {}

  SeamList list() const {
    SeamList list;
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t other = surface_.neighbours[t][k];
        if (other == none || other < t || !edges_.is_seam(t, k)) continue;
        const auto& vertices = surface_.triangles[t];
        const std::array<std::uint32_t, 2> ends{vertices[k], vertices[(k + 1) % 3]};
        const Corners corners{k, (k + 1) % 3};
        const Corners others{corner_at(surface_, other, ends[0]), corner_at(surface_, other, ends[1])};
        list.seams.push_back({side(t, corners), side(other, others)});
        list.frames.push_back(
            {{surface_.normals[ends[0]], surface_.normals[ends[1]]}, {tangents(t, corners), tangents(other, others)}});
      }
    }
    return list;
  }

 private:
  using Corners = std::array<std::size_t, 2>;  // of a triangle, at the ends of the edge

  SeamSide side(std::uint32_t t, const Corners& corners) const {
    const std::uint32_t c = edges_.chart_of(t);
    const auto texel = [&](std::size_t corner) {
      return atlas_.places[c].texel(charts_[c], charts_[c].point(surface_, t, corner));
    };
    return {.chart = c, .from = texel(corners[0]), .to = texel(corners[1])};
  }
  std::array<Vector, 2> tangents(std::uint32_t t, const Corners& corners) const {
    const Chart& chart = charts_[edges_.chart_of(t)];
    return {tangent_at(chart, t, corners[0]), tangent_at(chart, t, corners[1])};
  }

  const Surface& surface_;
  const std::vector<Chart>& charts_;
  const Atlas& atlas_;
  ChartEdges edges_;
};

constexpr unsigned colours = 3;

std::vector<ChartImage> images_of(std::vector<ChartMap>& maps) {
  std::vector<ChartImage> images;
  for (ChartMap& map : maps) images.push_back({map.width, map.height, map.values});
  return images;
}

// Adds the colours of one side of the seam to the map of the other side.
void add_colours(const std::vector<ChartImage>& images, const Seam& seam, ChartMap& to) {
  constexpr float samples_per_texel = 2;
  for_samples(images, seam, samples_per_texel, [&](float t, const BilinearSample& from, const BilinearSample&) {
    std::array<float, colours> colour{};
    for (std::size_t i = 0; i < 4; ++i)
      for (unsigned k = 0; k < colours; ++k)
        colour[k] +=
            from.weights[i] * images[seam.a.chart].values[from.texels[i] * channels_with_colour + colour_channel + k];
    to.add({seam.b.from[0] + (seam.b.to[0] - seam.b.from[0]) * t, seam.b.from[1] + (seam.b.to[1] - seam.b.from[1]) * t},
           colour);
  });
}

}  // namespace

void spread_colours(const Surface& surface, const std::vector<Chart>& charts, const Atlas& atlas,
                    std::vector<ChartMap>& maps, std::vector<bool>& is_empty) {
  const SeamList list = Collector(surface, charts, atlas).list();
  const std::vector<ChartImage> images = images_of(maps);
  Diffuser diffuser;
  std::map<std::uint32_t, ChartMap> found;
  do {
    found.clear();
    for (const Seam& seam : list.seams) {
      if (is_empty[seam.a.chart] == is_empty[seam.b.chart]) continue;
      const Seam inwards = is_empty[seam.a.chart] ? Seam{seam.b, seam.a} : seam;
      ChartMap& map = found[inwards.b.chart];
      if (map.weights.empty()) map.resize(atlas.places[inwards.b.chart], colours);
      add_colours(images, inwards, map);
    }
    for (auto& [c, map] : found) {
      map.divide(colours);
      if (diffuser.fill({map.width, map.height, colours, map.values, map.weights}).filled == map.weights.size())
        continue;  // no sample had enough weight
      for (std::size_t at = 0; at < map.weights.size(); ++at)
        std::copy_n(&map.values[at * colours], colours, &maps[c].values[at * channels_with_colour + colour_channel]);
    }
    for (const auto& [c, map] : found) is_empty[c] = false;
  } while (!found.empty());
}

void equalise_seams(const Surface& surface, const std::vector<Chart>& charts, const Atlas& atlas, unsigned channels,
                    std::vector<ChartMap>& maps) {
  const std::vector<ChartImage> images = images_of(maps);
  const SeamList list = Collector(surface, charts, atlas).list();
  equalise(images, channels, list.seams, {.levels = kept_levels, .first_level_channel = height_channel}, list.frames);
}

void equalise_seams(const Surface& surface, const std::vector<Chart>& islands, const Atlas& atlas, unsigned channels,
                    WholeMap& whole) {
  SeamList list = Collector(surface, islands, atlas).list();
  for (Seam& seam : list.seams) {
    for (SeamSide* side : {&seam.a, &seam.b}) {
      const Place& place = atlas.places[side->chart];
      for (Point2* end : {&side->from, &side->to})
        *end = {(*end)[0] + static_cast<float>(place.x), (*end)[1] + static_cast<float>(bottom_of(place, atlas))};
      side->least_side =
          std::max(std::min(place.width, place.height), 2 * island_gutter) - 2 * (island_gutter - gutter);
      side->chart = 0;
    }
  }
  const ChartImage image{whole.map.width, whole.map.height, whole.map.values};
  equalise({&image, 1}, channels, list.seams, {.levels = kept_levels, .first_level_channel = height_channel},
           list.frames);
}

}  // namespace glark::maps
