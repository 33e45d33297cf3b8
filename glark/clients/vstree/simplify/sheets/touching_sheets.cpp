// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/vstree/simplify/sheets/touching_sheets.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "glark/clients/common/mesh/cut_sheets.h"
#include "glark/clients/common/mesh/half_edges.h"
#include "glark/clients/common/mesh/reindex.h"
#include "glark/clients/vstree/simplify/sheets/components.h"

namespace glark::vstree {
namespace {

constexpr float apart = 0.02F;      // relative to the middle of a vertex's triangles
constexpr double most_lost = 0.02;  // of the area

using Place = std::array<float, 3>;

Place place_of(std::span<const float> positions, std::uint32_t i) {
  return {positions[3 * std::size_t{i}] + 0.0F, positions[3 * std::size_t{i} + 1] + 0.0F,
          positions[3 * std::size_t{i} + 2] + 0.0F};
}

// A mesh whose vertices are the places of the points.
struct Places {
  std::vector<std::uint32_t> triangles;
  std::size_t count = 0;

  Places(std::span<const float> positions, std::span<const std::uint32_t> of) {
    std::vector<float> places(positions.begin(), positions.end());
    for (float& number : places) number += 0.0F;  // -0 becomes 0; bytes are compared
    const std::size_t points = positions.size() / 3;
    std::vector<std::uint32_t> place(points);
    count = meshopt_generateVertexRemap(place.data(), of.data(), of.size(), places.data(), points, 3 * sizeof(float));
    triangles.reserve(of.size());
    for (const std::uint32_t i : of) triangles.push_back(place[i]);
  }

  std::vector<Edge> crowded_edges() const { return vstree::crowded_edges(triangles, count); }
};

double area_of(const Surface& surface, const Simplified& result, std::size_t triangle) {
  Float4 corners[3];
  for (std::size_t k = 0; k < 3; ++k)
    corners[k] = surface.cube.inside(&result.positions[3 * std::size_t{result.triangles[3 * triangle + k]}]);
  const Float4 across = without_fourth(cross(corners[1] - corners[0], corners[2] - corners[0]));
  return std::sqrt(static_cast<double>(dot(across, across))) / 2;
}

// Which triangles have the same corners as another one, in the opposite order. They come in pairs.
std::vector<bool> paired(const Places& places) {
  std::map<std::array<std::uint32_t, 3>, std::vector<std::uint32_t>> found;  // the least corner first
  std::vector<bool> result(places.triangles.size() / 3);
  for (std::uint32_t t = 0; t < result.size(); ++t) {
    std::array<std::uint32_t, 3> corners{places.triangles[3 * t], places.triangles[3 * t + 1],
                                         places.triangles[3 * t + 2]};
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    const auto opposite = found.find({corners[0], corners[2], corners[1]});
    if (opposite != found.end() && !opposite->second.empty()) {
      result[t] = result[opposite->second.back()] = true;
      opposite->second.pop_back();
    } else {
      found[corners].push_back(t);
    }
  }
  return result;
}

// Whether pairs are more than a small part of the surface. Then they are plates whose sides have met, and the surface
// would have holes without them.
bool are_plates(const Surface& surface, const Simplified& result, const std::vector<bool>& is_paired) {
  double area = 0, area_of_pairs = 0;
  for (std::size_t t = 0; t < is_paired.size(); ++t) {
    const double size = area_of(surface, result, t);
    area += size;
    area_of_pairs += is_paired[t] ? size : 0;
  }
  return area_of_pairs > most_lost * area;
}

// Returns whether there were any to remove.
bool remove(const std::vector<bool>& gone, std::vector<std::uint32_t>& triangles) {
  std::size_t kept = 0;
  for (std::size_t t = 0; t < gone.size(); ++t) {
    if (gone[t]) continue;
    std::copy_n(&triangles[3 * t], 3, &triangles[3 * kept++]);
  }
  const bool any = 3 * kept < triangles.size();
  triangles.resize(3 * kept);
  return any;
}

class Parting {
 public:
  Parting(const Surface& surface, Simplified& result) : surface_(surface), result_(result) {}

  void run(const Places& places, const std::vector<Edge>& edges, float most_moved) {
    find_places(places);
    std::vector<std::uint8_t> is_cut(places.count);
    const std::set<Place> given = given_places();
    for (const auto& [a, b] : edges) {
      const bool is_given[2] = {given.count(place_[a]) > 0, given.count(place_[b]) > 0};
      if (is_given[0] && is_given[1]) continue;
      for (const std::uint32_t end : {a, b}) is_cut[end] = 1;
    }
    std::vector<std::uint32_t> triangles = places.triangles;
    const std::vector<std::uint32_t> originals = common::cut_sheets(triangles, points_, is_cut);
    for (std::size_t i = points_.size(); i < originals.size(); ++i) points_.push_back(Float4(points_[originals[i]]));
    std::vector<Float4> moved = points_;
    common::move_apart(moved, triangles, originals, apart);
    for (std::size_t i = 0; i < moved.size(); ++i) {
      const Float4 way = moved[i] - points_[i];
      const float length = std::sqrt(dot(way, way));
      if (length > most_moved) moved[i] = points_[i] + way * (most_moved / length);
    }
    for (std::size_t i = 0; i < triangles.size(); ++i) give(i, triangles[i], moved[triangles[i]]);
  }

 private:
  void find_places(const Places& places) {
    place_.resize(places.count);
    points_.resize(places.count);
    for (std::size_t i = 0; i < places.triangles.size(); ++i) {
      const std::uint32_t place = places.triangles[i];
      place_[place] = place_of(result_.positions, result_.triangles[i]);
      points_[place] = surface_.cube.inside(place_[place].data());
    }
  }

  // The places where the surface itself has edges of more than two triangles.
  std::set<Place> given_places() const {
    const Places places(surface_.points.positions, surface_.triangles);
    std::vector<std::uint8_t> is_end(places.count);
    for (const auto& [a, b] : places.crowded_edges()) is_end[a] = is_end[b] = 1;
    std::set<Place> result;
    for (std::size_t i = 0; i < places.triangles.size(); ++i) {
      if (is_end[places.triangles[i]] != 0) result.insert(place_of(surface_.points.positions, surface_.triangles[i]));
    }
    return result;
  }

  // Gives a corner a vertex at the moved point. Corners of one sheet that had one vertex have one afterwards. The first
  // sheet keeps the vertex.
  void give(std::size_t corner, std::uint32_t sheet, Float4 moved) {
    const Float4 from = points_[sheet];
    if (moved[0] == from[0] && moved[1] == from[1] && moved[2] == from[2]) return;
    const std::uint32_t old = result_.triangles[corner];
    const bool is_first = given_.lower_bound({old, 0}) == given_.lower_bound({old + 1, 0});
    const auto fresh = static_cast<std::uint32_t>(result_.positions.size() / 3);
    const auto [at, is_new] = given_.try_emplace({old, sheet}, is_first ? old : fresh);
    result_.triangles[corner] = at->second;
    if (!is_new) return;
    const Float4 point = surface_.cube.low + moved * surface_.cube.side;
    if (!is_first) result_.positions.resize(result_.positions.size() + 3);
    for (std::size_t k = 0; k < 3; ++k) result_.positions[3 * std::size_t{at->second} + k] = point[static_cast<int>(k)];
    if (is_first) return;
    const auto copy = [old](auto& array, std::size_t size) {
      for (std::size_t k = 0; k < size && !array.empty(); ++k) {
        const auto value = array[size * old + k];
        array.push_back(value);
      }
    };
    copy(result_.normals, 3);
    copy(result_.colours, 3);
    copy(result_.texcoords, 2);
  }

  const Surface& surface_;
  Simplified& result_;
  std::vector<Place> place_;             // of each place
  std::vector<Float4> points_;           // the same in the unit cube, then the copies
  std::map<Edge, std::uint32_t> given_;  // for a vertex and a sheet: the new vertex
};

}  // namespace

// Skips edges between regular vertices: both ends of an edge of more than two triangles are irregular.
std::vector<Edge> crowded_edges(const std::vector<std::uint32_t>& triangles, std::size_t count) {
  const std::vector<std::uint8_t> irregular = common::irregular_vertices(triangles, count);
  std::vector<Edge> edges, result;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const std::uint32_t a = triangles[i], b = triangles[common::next_corner(i)];
    const std::uint32_t c = triangles[common::next_corner(common::next_corner(i))];
    if (a == b || b == c || c == a) continue;  // a triangle without area
    if ((irregular[a] & irregular[b]) != 0) edges.emplace_back(std::minmax(a, b));
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 2; i < edges.size(); ++i) {
    if (edges[i] == edges[i - 2] && (result.empty() || result.back() != edges[i])) result.push_back(edges[i]);
  }
  return result;
}

std::size_t crowded_edge_count(std::span<const float> positions, std::span<const std::uint32_t> triangles) {
  return Places(positions, triangles).crowded_edges().size();
}

void part_touching_sheets(const Surface& surface, float most_moved, Simplified& result) {
  Places places(result.positions, result.triangles);
  std::vector<Edge> edges = places.crowded_edges();
  if (edges.empty()) return;
  const std::vector<bool> is_paired = paired(places);
  if (are_plates(surface, result, is_paired)) return;  // parted, each pair would be a tile of its own
  if (remove(is_paired, result.triangles)) {
    places = Places(result.positions, result.triangles);
    edges = places.crowded_edges();
  }
  if (!edges.empty()) Parting(surface, result).run(places, edges, most_moved * surface.cube.diagonal);
  drop_pinched_off(surface, result);
  drop_unused_vertices(result);
}

}  // namespace glark::vstree
