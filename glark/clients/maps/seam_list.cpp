// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/seam_list.h"

#include <algorithm>
#include <array>
#include <map>

#include "glark/clients/maps/charts/chart_edges.h"
#include "glark/clients/maps/charts/hard_edges.h"
#include "glark/clients/maps/fill/diffusion.h"
#include "glark/clients/maps/seams/equaliser.h"
#include "glark/clients/maps/seams/samples.h"
#include "glark/clients/maps/seams/seams.h"

namespace glark::maps {
namespace {

struct SeamList {
  std::vector<Seam> seams;
  std::vector<SeamFrames> frames;                            // [seams]
  std::vector<std::pair<std::uint32_t, std::size_t>> edges;  // [seams] a triangle and its edge there
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
        list.frames.push_back({.normals = {surface_.normals[ends[0]], surface_.normals[ends[1]]},
                               .tangents = {tangents(t, corners), tangents(other, others)},
                               .is_hard = is_hard(surface_, t, k)});
        list.edges.emplace_back(t, k);
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

// Edges are no longer hard where the normals of both sides differ little.
void soften(const std::vector<ChartImage>& images, unsigned channels, SeamList& list, Surface& surface) {
  for (std::size_t i = 0; i < list.seams.size(); ++i) {
    SeamFrames& frames = list.frames[i];
    if (!frames.is_hard) continue;
    const Seam& seam = list.seams[i];
    float cosines = 0, count = 0;
    for_samples(images, seam, 1, [&](float t, const BilinearSample& a, const BilinearSample& b) {
      const auto normal = [&](const ChartImage& image, const BilinearSample& sample,
                              const std::array<Vector, 2>& ends) {
        const Vector local{value_of(image, sample, channels, 0), value_of(image, sample, channels, 1),
                           value_of(image, sample, channels, 2)};
        return common::unit(
            TangentFrame::of(frames.normals[0] * (1 - t) + frames.normals[1] * t, ends[0] * (1 - t) + ends[1] * t)
                .to_world(local));
      };
      cosines += common::dot(normal(images[seam.a.chart], a, frames.tangents[0]),
                             normal(images[seam.b.chart], b, frames.tangents[1]));
      count += 1;
    });
    frames.is_hard = cosines < count * cosine_of_crease;
    if (!frames.is_hard) set_soft(list.edges[i].first, list.edges[i].second, surface);
  }
}

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

void equalise_seams(Surface& surface, const std::vector<Chart>& charts, const Atlas& atlas, unsigned channels,
                    std::vector<ChartMap>& maps) {
  const std::vector<ChartImage> images = images_of(maps);
  SeamList list = Collector(surface, charts, atlas).list();
  soften(images, channels, list, surface);
  equalise(images, channels, list.seams, {.levels = kept_levels, .first_level_channel = height_channel}, list.frames);
}

void equalise_seams(Surface& surface, const std::vector<Chart>& islands, const Atlas& atlas, unsigned channels,
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
  const std::vector<ChartImage> images{{whole.map.width, whole.map.height, whole.map.values}};
  soften(images, channels, list, surface);
  equalise(images, channels, list.seams, {.levels = kept_levels, .first_level_channel = height_channel}, list.frames);
}

}  // namespace glark::maps
