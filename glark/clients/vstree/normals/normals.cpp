// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "glark/clients/common/counting_sort.h"
#include "glark/clients/common/points/point_set.h"
#include "glark/clients/vstree/normals/neighbours.h"
#include "glark/clients/vstree/normals/orientation.h"
#include "glark/clients/vstree/normals/plane_fit.h"
#include "glark/clients/vstree/normals/trust.h"
#include "glark/clients/vstree/tree/cells.h"

namespace glark::vstree {
namespace {

// With millions of points on a surface, each cell has a few hundred points.
constexpr unsigned grid_levels = 6;

std::uint32_t grid_cell(Float4 point) { return cube_key(octree_cell(point), octree_levels - grid_levels); }

// Returns the points sorted by the cells of a grid, so that near points have near indices. The fourth float holds the
// bits of the original index.
std::vector<Float4> sorted(const PointSet& points, const Cube& cube, const Workers& workers) {
  std::vector<Float4> result(points.positions.size() / 3);
  const auto key = [&](std::size_t begin, std::size_t end, std::uint32_t* keys) {
    for (std::size_t i = begin; i < end; ++i) *keys++ = grid_cell(cube.inside(&points.positions[3 * i]));
  };
  const auto move = [&](std::size_t begin, std::size_t end, const std::uint32_t* slots) {
    for (std::size_t i = begin; i < end; ++i) {
      Float4 point = cube.inside(&points.positions[3 * i]);
      point[3] = std::bit_cast<float>(static_cast<std::uint32_t>(i));
      result[*slots++] = point;
    }
  };
  sort_by_key(result.size(), std::size_t{1} << (3 * grid_levels), key, move, workers);
  return result;
}

// The distinct positions of the points. A thousand points at one position would all be neighbours of each other. A
// million such points would take a million million steps.
struct Places {
  std::vector<Float4> positions, normals;  // the first given normal at each position, or zero
  std::vector<bool> given;
  std::vector<std::uint32_t> of;  // the index of each point's position
};

std::uint32_t hash(Float4 point) {
  std::uint32_t result = 0;
  for (int axis = 0; axis < 3; ++axis)
    result = (result ^ std::bit_cast<std::uint32_t>(static_cast<float>(point[axis]))) * 0x9E3779B1U;
  return result ^ result >> 15U;
}

bool same_place(Float4 a, Float4 b) { return a[0] == b[0] && a[1] == b[1] && a[2] == b[2]; }

// The points must have the order of sorted(). Then equal points are in one cell, and the hash table of a cell stays in
// the cache.
Places places_of(std::span<const Float4> points) {
  constexpr std::uint32_t nothing = 0xFFFFFFFF;
  Places places;
  places.positions.reserve(points.size());
  places.of.resize(points.size());
  std::vector<std::uint32_t> table;
  for (std::size_t begin = 0, end = 0; begin < points.size(); begin = end) {
    const std::uint32_t cell = grid_cell(points[begin]);
    while (end < points.size() && grid_cell(points[end]) == cell) ++end;
    table.assign(std::bit_ceil(2 * (end - begin)), nothing);
    for (std::size_t i = begin; i < end; ++i) {
      std::size_t slot = hash(points[i]) & (table.size() - 1);
      while (table[slot] != nothing && !same_place(places.positions[table[slot]], points[i]))
        slot = (slot + 1) & (table.size() - 1);
      if (table[slot] == nothing) {
        table[slot] = static_cast<std::uint32_t>(places.positions.size());
        places.positions.push_back(without_fourth(points[i]));
      }
      places.of[i] = table[slot];
    }
  }
  places.normals.resize(places.positions.size());
  places.given.resize(places.positions.size());
  return places;
}

void face(Float4 scanner, Places& places) {
  for (std::size_t i = 0; i < places.positions.size(); ++i) {
    if (!places.given[i] && dot(places.normals[i], scanner - places.positions[i]) < 0)
      places.normals[i] = -places.normals[i];
  }
}

void estimate(Places& places, const Cube& cube, const NormalOptions& options, const Workers& workers) {
  const std::size_t count = places.positions.size();
  const std::size_t each = std::min<std::size_t>(options.neighbours, count);
  const std::vector<std::uint32_t> neighbours = nearest(places.positions, each, workers);
  const float noise = median_noise(places.positions, neighbours, each);
  workers.each(count, 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (!places.given[i])
        places.normals[i] = fit_normal(places.positions, std::span(neighbours).subspan(i * each, each), noise);
    }
  });
  const std::vector<float> trust = trust_in(places.normals, places.positions, neighbours, each, workers);
  if (options.scanner == nullptr) {
    orient(places.positions, places.normals, neighbours, each, trust, places.given, workers);
  } else {
    face(cube.inside(options.scanner->data()), places);
  }
  mend_doubtful(places.normals, places.positions, neighbours, each, trust, places.given, workers);
}

}  // namespace

std::vector<float> estimate_normals(const PointSet& points, const NormalOptions& options) {
  const Workers workers(options.threads);
  check(points, workers);
  if (options.neighbours < 3 || options.neighbours > most_neighbours) {
    throw Error(Element::option, 0,
                fmt::format("neighbours is {}; 3 to {} are possible", options.neighbours, most_neighbours));
  }
  if (options.scanner != nullptr && !std::ranges::all_of(*options.scanner, [](float x) { return std::isfinite(x); })) {
    throw Error(Element::option, 0, "scanner is not finite; give its position in the space of the points");
  }
  const Cube cube = bounding_cube(points.positions, workers);
  const std::size_t count = points.positions.size() / 3;
  std::vector<float> result(3 * count);
  if (count == 0) return result;
  const std::vector<Float4> positions = sorted(points, cube, workers);
  Places places = places_of(positions);
  const auto index = [&](std::size_t i) {
    return std::size_t{std::bit_cast<std::uint32_t>(static_cast<float>(positions[i][3]))};
  };
  const auto given_normal = [&](std::size_t i) {
    return points.normals.empty() ? Float4{} : unit_normal(&points.normals[3 * index(i)]);
  };
  for (std::size_t i = 0; i < count; ++i) {
    const Float4 normal = given_normal(i);
    if (!(normal[3] > 0) || places.given[places.of[i]]) continue;
    places.given[places.of[i]] = true;
    places.normals[places.of[i]] = without_fourth(normal);
  }
  estimate(places, cube, options, workers);
  for (std::size_t i = 0; i < count; ++i) {
    Float4 normal = given_normal(i);
    if (!(normal[3] > 0)) normal = places.normals[places.of[i]];
    for (std::size_t k = 0; k < 3; ++k) result[3 * index(i) + k] = normal[static_cast<int>(k)];
  }
  return result;
}

}  // namespace glark::vstree
