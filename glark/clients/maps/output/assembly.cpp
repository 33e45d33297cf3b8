// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/output/assembly.h"

#include <unordered_map>

#include "glark/clients/maps/output/texel_codes.h"

namespace glark::maps {
namespace {

class Assembly {
 public:
  Assembly(const Charts& in, Baked& model) : in_(in), model_(model) {}

  void add_mesh() {
    model_.triangles.resize(3 * in_.surface.triangles.size());
    for (std::size_t c = 0; c < in_.charts.size(); ++c) {
      std::unordered_map<std::uint32_t, std::uint32_t> vertex_of;
      for (const std::uint32_t t : in_.charts[c].triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
          const auto next = static_cast<std::uint32_t>(model_.positions.size() / 3);
          const auto [place, is_new] = vertex_of.emplace(in_.surface.triangles[t][k], next);
          if (is_new) add_vertex(c, t, k);
          model_.triangles[3 * t + k] = place->second;
        }
      }
    }
  }

  void clear() {
    for (const ChartMap& map : in_.maps)
      for (std::size_t at = 0; at < map.weights.size(); ++at)
        heights_.add(map.values[at * in_.channels + height_channel]);
    clear_maps(in_.atlas.width, in_.atlas.height, in_.channels == channels_with_colour, heights_, model_);
  }

  void add_maps(std::size_t c) {
    const Place& place = in_.atlas.places[c];
    const ChartMap& map = in_.maps[c];
    for (std::size_t y = 0; y < place.height; ++y) {
      for (std::size_t x = 0; x < place.width; ++x) {
        const std::size_t at = y * place.width + x;
        // The first row of a picture is the highest one.
        const std::size_t to = std::size_t{place.y + place.height - 1 - y} * model_.width + place.x + x;
        set_texel(map.values.data() + at * in_.channels, 1, heights_, to, model_);
      }
    }
  }

 private:
  void add_vertex(std::size_t c, std::uint32_t t, std::size_t corner) {
    const Chart& chart = in_.charts[c];
    const Place& place = in_.atlas.places[c];
    const std::uint32_t vertex = in_.surface.triangles[t][corner];
    const Vector& p = in_.surface.positions[vertex];
    const Vector& n = in_.surface.normals[vertex];
    const Vector tangent = tangent_at(chart, t, corner);
    const Point2 at = place.texel(chart, chart.point(in_.surface, t, corner));
    model_.positions.insert(model_.positions.end(), {p.x, p.y, p.z});
    model_.normals.insert(model_.normals.end(), {n.x, n.y, n.z});
    model_.tangents.insert(model_.tangents.end(), {tangent.x, tangent.y, tangent.z, 1.0F});
    model_.texcoords.push_back((static_cast<float>(place.x) + at[0]) / static_cast<float>(in_.atlas.width));
    model_.texcoords.push_back((static_cast<float>(place.y + place.height) - at[1]) /
                               static_cast<float>(in_.atlas.height));
  }

  const Charts& in_;
  Baked& model_;
  Heights heights_;
};

}  // namespace

void assemble(const Charts& charts, const common::Workers& workers, Baked& model) {
  Assembly assembly(charts, model);
  assembly.add_mesh();
  assembly.clear();
  workers.each(charts.charts.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) assembly.add_maps(c);
  });
}

}  // namespace glark::maps
