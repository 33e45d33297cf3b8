// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <map>
#include <utility>

#include "glark/clients/maps/output/assembly.h"
#include "glark/clients/maps/output/texel_codes.h"

namespace glark::maps {
namespace {

// The mesh with its own vertices.
class OwnMesh {
 public:
  OwnMesh(const Surface& surface, std::span<const float> texcoords, Baked& model)
      : surface_(surface), texcoords_(texcoords), model_(model), is_set_(surface.welded.size()) {
    for (std::uint32_t i = 0; i < surface.welded.size(); ++i) add_vertex(i, {1, 0, 0}, 1);
  }

  void add(const Chart& island) {
    const float turn = island.is_mirrored ? -1 : 1;
    for (std::size_t i = 0; i < island.triangles.size(); ++i) {
      const std::uint32_t t = island.triangles[i];
      for (std::size_t k = 0; k < 3; ++k)
        model_.triangles[3 * std::size_t{t} + k] =
            vertex_with(surface_.sources[t][k], island.tangents[island.wedges[i][k]], turn);
    }
  }

 private:
  void add_vertex(std::uint32_t source, Vector tangent, float turn) {
    const Vector& p = surface_.positions[surface_.welded[source]];
    const Vector& n = surface_.normals[surface_.welded[source]];
    model_.positions.insert(model_.positions.end(), {p.x, p.y, p.z});
    model_.normals.insert(model_.normals.end(), {n.x, n.y, n.z});
    model_.tangents.insert(model_.tangents.end(), {tangent.x, tangent.y, tangent.z, turn});
    model_.texcoords.push_back(texcoords_[2 * std::size_t{source}]);
    model_.texcoords.push_back(1 - texcoords_[2 * std::size_t{source} + 1]);  // the first row is the highest one
  }

  bool has(std::uint32_t vertex, Vector tangent, float turn) const {
    const float* const values = &model_.tangents[4 * std::size_t{vertex}];
    return values[0] == tangent.x && values[1] == tangent.y && values[2] == tangent.z && values[3] == turn;
  }

  // The vertex of the mesh, or a copy of it that has this tangent.
  std::uint32_t vertex_with(std::uint32_t source, Vector tangent, float turn) {
    if (!is_set_[source]) {
      is_set_[source] = true;
      const std::array<float, 4> values{tangent.x, tangent.y, tangent.z, turn};
      std::copy(values.begin(), values.end(), &model_.tangents[4 * std::size_t{source}]);
    }
    if (has(source, tangent, turn)) return source;
    const auto [first, end] = copies_.equal_range(source);
    for (auto copy = first; copy != end; ++copy)
      if (has(copy->second, tangent, turn)) return copy->second;
    const auto next = static_cast<std::uint32_t>(model_.positions.size() / 3);
    add_vertex(source, tangent, turn);
    copies_.emplace(source, next);
    return next;
  }

  const Surface& surface_;
  std::span<const float> texcoords_;
  Baked& model_;
  std::vector<bool> is_set_;                            // the vertices of the mesh that have their tangent
  std::multimap<std::uint32_t, std::uint32_t> copies_;  // of the vertices of the mesh
};

void set_maps(const std::vector<Chart>& islands, const WholeMap& whole, unsigned channels, Baked& model) {
  const ChartMap& map = whole.map;
  Heights heights;
  for (std::size_t at = 0; at < whole.owners.size(); ++at)
    if (whole.owners[at] != none) heights.add(map.values[at * channels + height_channel]);
  clear_maps(map.width, map.height, channels == channels_with_colour, heights, model);
  for (std::size_t y = 0; y < map.height; ++y) {
    for (std::size_t x = 0; x < map.width; ++x) {
      const std::size_t at = y * map.width + x, to = (map.height - 1 - y) * map.width + x;
      const std::uint32_t owner = whole.owners[at];
      const float y_factor = owner != none && islands[owner].is_mirrored ? -1.0F : 1.0F;
      set_texel(map.values.data() + at * channels, y_factor, heights, to, model);
    }
  }
}

}  // namespace

void assemble(const Surface& surface, std::span<const float> texcoords, const std::vector<Chart>& islands,
              const WholeMap& whole, unsigned channels, Baked& model) {
  model.triangles.resize(3 * surface.triangles.size());
  OwnMesh mesh(surface, texcoords, model);
  for (const Chart& island : islands) mesh.add(island);
  set_maps(islands, whole, channels, model);
}

}  // namespace glark::maps
