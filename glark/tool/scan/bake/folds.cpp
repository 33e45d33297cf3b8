// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/scan/bake/folds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "glark/clients/common/vector.h"

namespace glark::tool {
namespace {

using Vector = common::Vector3d;
using Corners = std::array<std::uint32_t, 3>;

constexpr int most_rounds = 10;

class Unfolder {
 public:
  explicit Unfolder(geometry::Geometry& mesh) : mesh_(mesh) {
    for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) add_edges(t);
  }

  // Returns the number of flips.
  std::size_t flip_all() {
    std::size_t flips = 0;
    for (std::uint32_t t = 0; t < mesh_.triangle_count(); ++t) flips += is_folded(t) && flip_best(t) ? 1 : 0;
    return flips;
  }

  // Moves vertices of folded triangles. Returns the number of moves.
  std::size_t relax_all() {
    find_movable();
    std::size_t moves = 0;
    for (std::uint32_t t = 0; t < mesh_.triangle_count(); ++t) {
      const Corners c = corners_of(t);
      for (std::size_t k = 0; k < 3 && is_folded(t); ++k) moves += is_movable_[c[k]] && relax(c[k]) ? 1 : 0;
    }
    return moves;
  }

  std::size_t folded() const {
    std::size_t count = 0;
    for (std::uint32_t t = 0; t < mesh_.triangle_count(); ++t) count += is_folded(t) ? 1 : 0;
    return count;
  }

 private:
  using Edge = std::pair<std::uint32_t, std::uint32_t>;  // from the first vertex to the second, as the triangle turns

  Corners corners_of(std::uint32_t t) const {
    return {mesh_.triangles[3 * t], mesh_.triangles[3 * t + 1], mesh_.triangles[3 * t + 2]};
  }
  static Vector vector_at(const std::vector<float>& values, std::uint32_t i) {
    return {static_cast<double>(values[3 * i]), static_cast<double>(values[3 * i + 1]),
            static_cast<double>(values[3 * i + 2])};
  }

  // The cosine between a triangle's normal and the mean normal of its vertices; 1 for a triangle without area.
  double facing(const Corners& c) const {
    const Vector a = vector_at(mesh_.positions, c[0]);
    const Vector normal =
        common::unit(common::cross(vector_at(mesh_.positions, c[1]) - a, vector_at(mesh_.positions, c[2]) - a));
    if (common::is_zero(normal)) return 1;
    Vector mean;
    for (const std::uint32_t vertex : c) mean += common::unit(vector_at(mesh_.normals, vertex));
    return common::dot(normal, common::unit(mean));
  }
  bool is_folded(std::uint32_t t) const { return facing(corners_of(t)) < 0; }

  void add_edges(std::uint32_t t) {
    const Corners c = corners_of(t);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [at, is_new] = triangle_of_.emplace(Edge{c[k], c[(k + 1) % 3]}, t);
      if (!is_new) at->second = shared;
    }
  }
  void remove_edges(std::uint32_t t) {
    const Corners c = corners_of(t);
    for (std::size_t k = 0; k < 3; ++k) triangle_of_.erase({c[k], c[(k + 1) % 3]});
  }
  void replace(std::uint32_t t, const Corners& corners) {
    for (std::size_t k = 0; k < 3; ++k) mesh_.triangles[3 * t + k] = corners[k];
    add_edges(t);
  }

  std::uint32_t neighbour_across(const Edge& edge) const {
    const auto found = triangle_of_.find({edge.second, edge.first});
    return found != triangle_of_.end() ? found->second : shared;
  }
  bool exists(std::uint32_t a, std::uint32_t b) const {
    return triangle_of_.contains({a, b}) || triangle_of_.contains({b, a});
  }
  bool has_shared_edge(std::uint32_t t) const {
    const Corners c = corners_of(t);
    for (std::size_t k = 0; k < 3; ++k)
      if (triangle_of_.at({c[k], c[(k + 1) % 3]}) == shared) return true;
    return false;
  }

  // Flips the edge after which the worse of both triangles faces its vertices best.
  bool flip_best(std::uint32_t t) {
    const Corners c = corners_of(t);
    double best = 0;
    std::uint32_t other = shared;
    Corners first{}, second{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = c[k], b = c[(k + 1) % 3], p = c[(k + 2) % 3];
      const std::uint32_t neighbour = neighbour_across({a, b});
      if (neighbour == shared || has_shared_edge(t) || has_shared_edge(neighbour)) continue;
      const Corners n = corners_of(neighbour);
      const std::uint32_t q = n[0] != a && n[0] != b ? n[0] : n[1] != a && n[1] != b ? n[1] : n[2];
      if (q == p || exists(p, q)) continue;
      const double worse = std::min(facing({p, a, q}), facing({q, b, p}));
      if (worse <= best) continue;
      best = worse;
      other = neighbour;
      first = {p, a, q};
      second = {q, b, p};
    }
    if (other == shared) return false;
    remove_edges(t);
    remove_edges(other);
    replace(t, first);
    replace(other, second);
    return true;
  }

  // Vertices that have their place alone, and triangles all around them.
  void find_movable() {
    std::map<std::array<float, 3>, std::uint32_t> vertex_at;
    is_movable_.assign(mesh_.point_count(), true);
    triangles_at_.assign(mesh_.point_count(), {});
    for (std::uint32_t t = 0; t < mesh_.triangle_count(); ++t) {
      const Corners c = corners_of(t);
      for (std::size_t k = 0; k < 3; ++k) {
        triangles_at_[c[k]].push_back(t);
        if (neighbour_across({c[k], c[(k + 1) % 3]}) == shared) is_movable_[c[k]] = is_movable_[c[(k + 1) % 3]] = false;
      }
    }
    for (std::uint32_t v = 0; v < mesh_.point_count(); ++v) {
      const float* p = &mesh_.positions[3 * std::size_t{v}];
      const auto [at, is_new] = vertex_at.try_emplace({p[0], p[1], p[2]}, v);
      if (!is_new) is_movable_[v] = is_movable_[at->second] = false;
    }
  }

  double worst_facing(std::uint32_t vertex) const {
    double worst = 1;
    for (const std::uint32_t t : triangles_at_[vertex]) worst = std::min(worst, facing(corners_of(t)));
    return worst;
  }

  void move(std::uint32_t vertex, Vector to) {
    for (std::size_t k = 0; k < 3; ++k) mesh_.positions[3 * std::size_t{vertex} + k] = static_cast<float>(to[k]);
  }

  // Moves a vertex towards the middle of its neighbours if all triangles around it then face their vertices better than the
  // worst one does now.
  bool relax(std::uint32_t vertex) {
    const Vector before = vector_at(mesh_.positions, vertex);
    Vector middle;
    for (const std::uint32_t t : triangles_at_[vertex])
      for (const std::uint32_t corner : corners_of(t))
        if (corner != vertex) middle += vector_at(mesh_.positions, corner);
    middle = middle * (0.5 / static_cast<double>(triangles_at_[vertex].size()));
    double best = worst_facing(vertex);
    Vector place = before;
    for (const double part : {0.25, 0.5, 0.75, 1.0}) {
      const Vector candidate = before + (middle - before) * part;
      move(vertex, candidate);
      const double facing = worst_facing(vertex);
      if (facing <= best) continue;
      best = facing;
      place = candidate;
    }
    move(vertex, place);
    return !(place == before);
  }

  static constexpr std::uint32_t shared = 0xFFFFFFFF;  // no triangle, or several that turn the same way

  geometry::Geometry& mesh_;
  std::map<Edge, std::uint32_t> triangle_of_;
  std::vector<bool> is_movable_;                          // of the vertices
  std::vector<std::vector<std::uint32_t>> triangles_at_;  // at each vertex
};

}  // namespace

std::size_t unfold(geometry::Geometry& mesh) {
  Unfolder unfolder(mesh);
  for (int round = 0; round < most_rounds; ++round)
    if (unfolder.flip_all() + unfolder.relax_all() == 0) break;
  return unfolder.folded();
}

}  // namespace glark::tool
