// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "tests/bench/subject/mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "glark/core/pattern/expand.h"
#include "glark/core/pattern/pool.h"

namespace glark::bench {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

Vertex sphere_vertex(float polar, float azimuth) {
  const float x = std::sin(polar) * std::cos(azimuth);
  const float y = std::cos(polar);
  const float z = std::sin(polar) * std::sin(azimuth);
  return {{x, y, z}, {x, y, z}, {azimuth / (2 * pi), polar / pi}};
}

// Returns the numbers of vertices of the rings, in proportion to their lengths. The sum is `total`.
std::vector<int> ring_sizes(int total) {
  const int rings = std::max(2, static_cast<int>(std::lround(std::sqrt(pi * static_cast<float>(total)) / 2)));
  std::vector<float> weights;
  float sum = 0;
  for (int i = 0; i < rings; ++i) {
    weights.push_back(std::sin(pi * static_cast<float>(i + 1) / static_cast<float>(rings + 1)));
    sum += weights.back();
  }
  std::vector<int> sizes;
  float wanted = 0;
  int given = 0;
  for (const float weight : weights) {
    wanted += weight;
    const int until = static_cast<int>(std::lround(static_cast<float>(total) * wanted / sum));
    sizes.push_back(until - given);
    given = until;
  }
  return sizes;
}

struct Ring {
  std::uint32_t first;
  int size;
  std::uint32_t at(int i) const { return first + static_cast<std::uint32_t>(i % size); }
};

// Makes the triangles between two rings. Each step advances on the ring whose next vertex comes first.
void join_rings(const Ring& upper, const Ring& lower, std::vector<std::uint32_t>& indices) {
  int i = 0;
  int j = 0;
  while (i < upper.size || j < lower.size) {
    const bool advance_upper =
        j == lower.size || (i < upper.size && (2 * i + 1) * lower.size <= (2 * j + 1) * upper.size);
    if (advance_upper) {
      indices.insert(indices.end(), {upper.at(i), upper.at(i + 1), lower.at(j)});
      ++i;
    } else {
      indices.insert(indices.end(), {lower.at(j), upper.at(i), lower.at(j + 1)});
      ++j;
    }
  }
}

void join_pole(std::uint32_t pole, const Ring& ring, bool top, std::vector<std::uint32_t>& indices) {
  for (int i = 0; i < ring.size; ++i) {
    indices.insert(indices.end(), {pole, ring.at(top ? i + 1 : i), ring.at(top ? i : i + 1)});
  }
}

float mix(float a, float b, float c, float u, float v) { return ((1 - u - v) * a + u * b) + v * c; }

Vertex mix(const Vertex* corners[3], float u, float v) {
  Vertex result{};
  for (int k = 0; k < 3; ++k) {
    result.position[k] = mix(corners[0]->position[k], corners[1]->position[k], corners[2]->position[k], u, v);
    result.normal[k] = mix(corners[0]->normal[k], corners[1]->normal[k], corners[2]->normal[k], u, v);
  }
  for (int k = 0; k < 2; ++k) result.uv[k] = mix(corners[0]->uv[k], corners[1]->uv[k], corners[2]->uv[k], u, v);
  return result;
}

void append_tile(const pattern::Pool& pool, const pattern::Instance& tile, const Vertex* corners[3], Mesh& fine) {
  const pattern::Piece& piece = pool.pieces[static_cast<std::size_t>(tile.piece)];
  const auto base = static_cast<std::uint32_t>(fine.vertices.size());
  for (std::uint32_t i = 0; i < piece.vertex_count; ++i) {
    const pattern::LatticeVertex lattice = pool.vertices[piece.base_vertex + i];
    constexpr float unit = 1.0F / static_cast<float>(pattern::lattice_one);
    const float u = static_cast<float>(lattice.u) * unit;
    const float v = static_cast<float>(lattice.v) * unit;
    fine.vertices.push_back(mix(corners, tile.ou + tile.s * u, tile.ov + tile.s * v));
  }
  for (std::uint32_t i = 0; i < piece.index_count; ++i)
    fine.indices.push_back(base + pool.indices[piece.first_index + i]);
}

}  // namespace

Mesh make_sphere(int triangles) {
  Mesh mesh;
  std::vector<Ring> rings;
  const std::vector<int> sizes = ring_sizes(triangles / 2);
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    const float polar = pi * static_cast<float>(k + 1) / static_cast<float>(sizes.size() + 1);
    rings.push_back({static_cast<std::uint32_t>(mesh.vertices.size()), sizes[k]});
    for (int i = 0; i < sizes[k]; ++i) {
      mesh.vertices.push_back(sphere_vertex(polar, 2 * pi * static_cast<float>(i) / static_cast<float>(sizes[k])));
    }
  }
  const auto poles = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.push_back(sphere_vertex(0, 0));
  mesh.vertices.push_back(sphere_vertex(pi, 0));
  join_pole(poles, rings.front(), true, mesh.indices);
  for (std::size_t k = 0; k + 1 < rings.size(); ++k) join_rings(rings[k], rings[k + 1], mesh.indices);
  join_pole(poles + 1, rings.back(), false, mesh.indices);
  return mesh;
}

Mesh make_plane(int cells, float half) {
  Mesh mesh;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      const float s = static_cast<float>(i) / static_cast<float>(cells);
      const float t = static_cast<float>(j) / static_cast<float>(cells);
      mesh.vertices.push_back({{half * (2 * s - 1), 0, half * (2 * t - 1)}, {0, 1, 0}, {s, t}});
    }
  }
  const auto at = [cells](int i, int j) { return static_cast<std::uint32_t>(j * (cells + 1) + i); };
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      mesh.indices.insert(mesh.indices.end(),
                          {at(i, j), at(i, j + 1), at(i + 1, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)});
    }
  }
  return mesh;
}

Mesh first_triangles(const Mesh& mesh, std::size_t triangles) {
  Mesh result{mesh.vertices, mesh.indices};
  result.indices.resize(3 * std::min(triangles, mesh.triangles()));
  return result;
}

Mesh refine(const Mesh& coarse, unsigned level) {
  const pattern::Pool pool = pattern::build_pool(level);
  const int depth = static_cast<int>(level);
  const std::vector<pattern::Instance> tiles =
      level <= pattern::deepest_uniform ? std::vector<pattern::Instance>{{pattern::uniform_piece(depth), 0, 0, 1, 0}}
                                        : pattern::expand(depth, depth, depth, pattern::Interior::minimum);
  Mesh fine;
  for (std::size_t t = 0; t < coarse.triangles(); ++t) {
    const Vertex* corners[3];
    for (std::size_t k = 0; k < 3; ++k) corners[k] = &coarse.vertices[coarse.indices[3 * t + k]];
    for (const pattern::Instance& tile : tiles) append_tile(pool, tile, corners, fine);
  }
  return fine;
}

Mesh separate(const Mesh& mesh) {
  Mesh result;
  result.vertices.reserve(mesh.indices.size());
  for (const std::uint32_t index : mesh.indices) result.vertices.push_back(mesh.vertices[index]);
  return result;
}

}  // namespace glark::bench
