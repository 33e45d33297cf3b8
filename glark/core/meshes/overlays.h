// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Which meshes have lines of other draws on them. Viewers draw the edges or wires of a mesh over it, as
// lines or as thin quads, from a buffer of their own. Their ends are vertices of the mesh. A curved mesh bulges between
// its vertices, and would hide them. So it stays flat. Points are no overlay: they stay on the vertices. No GL.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "glark/core/meshes/mesh_key.h"

namespace glark::core {

using Point = std::array<float, 3>;

// The different points among these, each as a number.
std::vector<std::uint64_t> distinct_points(std::span<const Point> points);
// Both are results of distinct_points. Half of the overlay's points, or a quarter of the mesh's, are points of both; and
// at least three.
bool lies_on(const std::vector<std::uint64_t>& overlay, const std::vector<std::uint64_t>& mesh);

class Overlays {
 public:
  // Returns whether the points of this source are wanted: they were not given yet.
  bool wants_overlay(const MeshKey& key) const { return has_room(overlays_.size()) && !overlays_.contains(key); }
  bool wants_mesh(const MeshKey& key) const {
    return has_room(meshes_.size()) && !overlays_.empty() && !meshes_.contains(key);
  }
  void add_overlay(const MeshKey& key, std::span<const Point> points);
  void add_mesh(const MeshKey& key, std::span<const Point> points);
  bool covers(const MeshKey& mesh) const;

  // Later sources are not looked at. A program may make a new buffer for its lines in each frame.
  static constexpr std::size_t most_points = std::size_t{1} << 22U;  // of all sources
  static constexpr std::size_t most_sources = 1024;                  // of each kind

 private:
  bool has_room(std::size_t sources) const { return points_ < most_points && sources < most_sources; }
  struct Mesh {
    std::vector<std::uint64_t> points;
    bool covered = false;
  };
  std::unordered_map<MeshKey, std::vector<std::uint64_t>, MeshKeyHash> overlays_;
  std::unordered_map<MeshKey, Mesh, MeshKeyHash> meshes_;
  std::size_t points_ = 0;
};

}  // namespace glark::core
