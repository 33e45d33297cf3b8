// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/output/assembly.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace glark::maps {
namespace {

constexpr std::array<std::uint8_t, 3> flat_normal{128, 128, 255};  // of texels that no chart has

std::uint8_t to_byte(float value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * 255));
}

// A normal of the map. It keeps its length if it can be stored: lengths that differ from 1 make both sides of a seam agree
// after filtering, and the shader scales the sum to unit length.
Vector limited(Vector local) {
  if (common::is_zero(local)) return {0, 0, 1};
  return local * (1 / std::max({1.0F, std::abs(local.x), std::abs(local.y), std::abs(local.z)}));
}

class Assembly {
 public:
  Assembly(const Charts& in, Baked& model) : in_(in), model_(model) {}

  void add_mesh() {
    model_.triangles.resize(3 * in_.surface.triangles.size());
    for (std::size_t c = 0; c < in_.charts.size(); ++c) {
      std::unordered_map<std::uint32_t, std::uint32_t> vertex_of;
      for (const std::uint32_t t : in_.charts[c].triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
          const std::uint32_t vertex = in_.surface.triangles[t][k];
          const auto next = static_cast<std::uint32_t>(model_.positions.size() / 3);
          const auto [place, is_new] = vertex_of.emplace(vertex, next);
          if (is_new) add_vertex(c, vertex);
          model_.triangles[3 * t + k] = place->second;
        }
      }
    }
  }

  void set_range_of_heights() {
    float low = std::numeric_limits<float>::max();
    float high = std::numeric_limits<float>::lowest();
    for (const ChartMap& map : in_.maps) {
      for (std::size_t at = 0; at < map.weights.size(); ++at) {
        low = std::min(low, map.values[at * in_.channels + height_channel]);
        high = std::max(high, map.values[at * in_.channels + height_channel]);
      }
    }
    model_.bias = low;
    model_.scale = high - low;
  }

  void clear_maps() {
    model_.width = in_.atlas.width;
    model_.height = in_.atlas.height;
    const std::size_t texels = std::size_t{model_.width} * model_.height;
    model_.normal_map.resize(3 * texels);
    for (std::size_t i = 0; i < model_.normal_map.size(); ++i) model_.normal_map[i] = flat_normal.at(i % 3);
    if (in_.channels == channels_with_colour) model_.colour_map.assign(3 * texels, 128);
    model_.displacement_map.assign(texels, code_of_height(0));
  }

  void add_maps(std::size_t c) {
    const Place& place = in_.atlas.places[c];
    const ChartMap& map = in_.maps[c];
    for (std::size_t y = 0; y < place.height; ++y) {
      for (std::size_t x = 0; x < place.width; ++x) {
        const std::size_t at = y * place.width + x;
        // The first row of a picture is the highest one.
        const std::size_t to = std::size_t{place.y + place.height - 1 - y} * model_.width + place.x + x;
        const float* values = map.values.data() + at * in_.channels;
        const Vector normal = limited({values[0], values[1], values[2]});
        for (std::size_t k = 0; k < 3; ++k) model_.normal_map[3 * to + k] = to_byte(normal[k] / 2 + 0.5F);
        model_.displacement_map[to] = code_of_height(values[height_channel]);
        if (!model_.colour_map.empty())
          for (std::size_t k = 0; k < 3; ++k) model_.colour_map[3 * to + k] = to_byte(values[colour_channel + k]);
      }
    }
  }

 private:
  void add_vertex(std::size_t c, std::uint32_t vertex) {
    const Chart& chart = in_.charts[c];
    const Place& place = in_.atlas.places[c];
    const Vector& p = in_.surface.positions[vertex];
    const Vector& n = in_.surface.normals[vertex];
    const Vector t = tangent_at(chart, vertex);
    const Point2 at = place.texel(chart, chart.project(p));
    model_.positions.insert(model_.positions.end(), {p.x, p.y, p.z});
    model_.normals.insert(model_.normals.end(), {n.x, n.y, n.z});
    model_.tangents.insert(model_.tangents.end(), {t.x, t.y, t.z, 1.0F});
    model_.texcoords.push_back((static_cast<float>(place.x) + at[0]) / static_cast<float>(in_.atlas.width));
    model_.texcoords.push_back((static_cast<float>(place.y + place.height) - at[1]) /
                               static_cast<float>(in_.atlas.height));
  }

  std::uint16_t code_of_height(float height) const {
    if (!(model_.scale > 0)) return 0;
    const double part =
        (static_cast<double>(height) - static_cast<double>(model_.bias)) / static_cast<double>(model_.scale);
    return static_cast<std::uint16_t>(std::lround(std::clamp(part, 0.0, 1.0) * 65535));
  }

  const Charts& in_;
  Baked& model_;
};

}  // namespace

void assemble(const Charts& charts, const common::Workers& workers, Baked& model) {
  Assembly assembly(charts, model);
  assembly.add_mesh();
  assembly.set_range_of_heights();
  assembly.clear_maps();
  workers.each(charts.charts.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) assembly.add_maps(c);
  });
}

}  // namespace glark::maps
