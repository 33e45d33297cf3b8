// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/reconstruct/density/layers.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "glark/clients/common/disjoint_sets.h"
#include "glark/clients/common/points/point_set.h"
#include "glark/clients/reconstruct/density/neighbours.h"

namespace glark::reconstruct {
namespace {

constexpr double cell_samples = 64;  // of the cells in which layers are looked for; their side is 8 spacings
constexpr std::size_t neighbours_each = 8;
constexpr float alike = 0.5F;             // the least cosine of normals that face the same way
constexpr float steep = 0.5F;             // the height of a sample on another layer, relative to its distance
constexpr float far = 1.5F;               // the least distance of two layers, in spacings
constexpr float beside = 3;               // the greatest distance sideways of two layers' middles, relative to that
constexpr std::size_t least_in_cell = 4;  // samples of a layer
constexpr std::size_t least_cells = 4;    // in which two layers meet
constexpr std::size_t least_share = 20;   // and one in so many cells of the smaller one
constexpr std::size_t least_part = 64;    // samples of a part that can be a layer
constexpr double least_layered = 0.1;     // of the cells; with fewer, parts are not looked for
constexpr std::size_t grain = 1 << 12;

using Pair = std::pair<std::uint32_t, std::uint32_t>;

// What a part has in a cell.
struct Piece {
  std::uint32_t part = 0;
  Float4 points{}, normals{};  // sums; the fourth number of the points counts them

  Float4 middle() const { return without_fourth(points / points[3]); }
};

// Returns whether two pieces in one cell are layers: they face the same way, and one lies over the other.
bool are_layers(const Piece& a, const Piece& b, float spacing) {
  const auto least = static_cast<float>(least_in_cell);
  if (a.points[3] < least || b.points[3] < least) return false;
  const Float4 n = unit(a.normals), m = unit(b.normals), way = b.middle() - a.middle();
  if (!(dot(n, m) > alike)) return false;
  const float height = std::min(std::abs(dot(way, n)), std::abs(dot(way, m)));
  return height > far * spacing && dot(way, way) < (1 + beside * beside) * height * height;
}

class Layers {
 public:
  Layers(const PointSet& points, const SortedSamples& sorted, const Workers& workers)
      : points_(points), sorted_(sorted), workers_(workers) {}

  std::vector<std::vector<std::uint32_t>> groups() {
    const Occupancy occupancy = occupancy_of(sorted_.entries);
    const double side = side_for(occupancy, cell_samples);
    spacing_ = static_cast<float>(side / std::sqrt(cell_samples));
    level_ = std::min(static_cast<unsigned>(-std::log2(side)), cell_levels);
    if (share_of_layers(points_, sorted_.cube, sorted_.entries, level_) < least_layered) return {};
    find_parts();
    const std::map<Pair, std::size_t> meetings = meet();
    std::map<std::uint32_t, std::vector<std::uint32_t>> over_or_under;  // the other layers of a part
    for (const auto& [pair, count] : meetings) {
      if (count < least_cells || count * least_share < std::min(cells_[pair.first], cells_[pair.second])) continue;
      over_or_under[pair.first].push_back(pair.second);
      over_or_under[pair.second].push_back(pair.first);
    }
    std::vector<std::uint32_t> group_of(sorted_.entries.size(), none);  // of each large part
    std::uint32_t groups = 1;
    for (const std::uint32_t part : by_size_) {
      std::vector<bool> taken(groups + 1);
      for (const std::uint32_t other : over_or_under[part]) {
        if (group_of[other] != none) taken[group_of[other]] = true;
      }
      const auto free = static_cast<std::uint32_t>(std::find(taken.begin(), taken.end(), false) - taken.begin());
      group_of[part] = free;
      groups = std::max(groups, free + 1);
    }
    std::vector<std::vector<std::uint32_t>> result;
    if (groups == 1) return result;
    result.resize(groups);
    for (std::uint32_t i = 0; i < sorted_.entries.size(); ++i) {
      const std::uint32_t group = group_of[part_of_[i]];
      result[group != none ? group : 0].push_back(sorted_.entries[i].index);
    }
    return result;
  }

 private:
  // Connects each sample with its neighbours, unless they face the same way from another height.
  void find_parts() {
    const Neighbours neighbours(points_, sorted_.cube, sorted_.entries);
    const std::size_t count = sorted_.entries.size();
    std::vector<std::vector<Pair>> found((count + grain - 1) / grain);
    workers_.in_pieces(count, grain, [&](std::size_t begin, std::size_t end) {
      std::vector<Neighbours::Near> near;
      for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i) {
        neighbours.find(i, neighbours_each, near);
        const Float4 point = neighbours.point(i), normal = neighbours.normal(i);
        for (const Neighbours::Near& other : near) {
          if (is_connected(neighbours.point(other.entry) - point, normal, neighbours.normal(other.entry)))
            found[begin / grain].emplace_back(i, other.entry);
        }
      }
    });
    common::DisjointSets sets(count);
    for (const std::vector<Pair>& pairs : found) {
      for (const auto& [a, b] : pairs) sets.join(a, b);
    }
    part_of_.resize(count);
    std::vector<std::uint32_t> sizes(count);
    for (std::uint32_t i = 0; i < count; ++i) ++sizes[part_of_[i] = sets.find(i)];
    for (std::uint32_t part = 0; part < count; ++part) {
      if (sizes[part] >= least_part) by_size_.push_back(part);
    }
    std::ranges::stable_sort(by_size_, std::greater{}, [&](std::uint32_t part) { return sizes[part]; });
  }

  static bool is_connected(Float4 way, Float4 normal, Float4 other) {
    if (dot(normal, other) < alike) return true;  // an edge, or the other side of a thin sheet
    const float most = steep * std::sqrt(dot(way, way));
    return std::abs(dot(way, normal)) < most || std::abs(dot(way, other)) < most;
  }

  // Counts the cells in which each two parts are layers. Small parts are left out.
  std::map<Pair, std::size_t> meet() {
    std::map<Pair, std::size_t> meetings;
    cells_.resize(sorted_.entries.size());
    const Level level = finest_level(sorted_.entries, level_);
    std::vector<Piece> pieces;
    for (std::size_t cell = 0; cell + 1 < level.begins.size(); ++cell) {
      pieces.clear();
      for (std::uint32_t i = level.begins[cell]; i < level.begins[cell + 1]; ++i) add(i, pieces);
      for (std::size_t a = 0; a < pieces.size(); ++a) {
        ++cells_[pieces[a].part];
        for (std::size_t b = a + 1; b < pieces.size(); ++b) {
          if (are_layers(pieces[a], pieces[b], spacing_)) ++meetings[std::minmax(pieces[a].part, pieces[b].part)];
        }
      }
    }
    return meetings;
  }

  void add(std::uint32_t entry, std::vector<Piece>& pieces) const {
    auto piece = std::ranges::find(pieces, part_of_[entry], &Piece::part);
    if (piece == pieces.end()) piece = pieces.insert(pieces.end(), Piece{.part = part_of_[entry]});
    const std::size_t index = 3 * std::size_t{sorted_.entries[entry].index};
    piece->points += without_fourth(sorted_.cube.inside(&points_.positions[index])) + Float4{0, 0, 0, 1};
    piece->normals += without_fourth(unit_normal(&points_.normals[index]));
  }

  const PointSet& points_;
  const SortedSamples& sorted_;
  const Workers& workers_;
  float spacing_ = 0;
  unsigned level_ = 0;
  std::vector<std::uint32_t> part_of_;  // of each entry
  std::vector<std::uint32_t> by_size_;  // the large parts, the largest first
  std::vector<std::uint32_t> cells_;    // the number of each part
};

}  // namespace

std::vector<std::vector<std::uint32_t>> layers_of(const PointSet& points, const SortedSamples& sorted,
                                                  const Workers& workers) {
  return Layers(points, sorted, workers).groups();
}

}  // namespace glark::reconstruct
