// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/vstree/simplify/collapse.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <numeric>

#include "glark/clients/common/mesh/rounded_places.h"
#include "glark/clients/common/mixed_bits.h"
#include "glark/clients/vstree/simplify/sheets/touching_sheets.h"
#include "glark/clients/vstree/validation.h"
#if GLARK_HAS_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif

namespace glark::vstree {

Method method_for(const Mesh& mesh, const SimplifyOptions& options) {
  if (mesh.triangles.empty()) return Method::cluster;
  if (options.method != Method::automatic) return options.method;
  const bool is_small = mesh.triangles.size() / 3 < least_to_cluster;
  return can_collapse(mesh, options) && (is_small || options.max_error > 0) ? Method::collapse : Method::cluster;
}

bool can_collapse(const Mesh& mesh, const SimplifyOptions& options) {
  const bool has_goal = options.target != 0 || options.max_error > 0;
  return GLARK_HAS_MESHOPTIMIZER != 0 && !mesh.triangles.empty() && has_goal;
}

#if GLARK_HAS_MESHOPTIMIZER
namespace {

constexpr float little = 1e-5F;  // of the longest side
constexpr int most_tries = 8;    // to avoid edges of more than two triangles

// Points that differ only in their normals, or by the rounding of their positions along a seam, are one vertex.
struct Welded {
  std::vector<std::uint32_t> vertex_of;       // [points]; none if no triangle uses the point
  std::vector<float> positions;               // [3 * vertices]
  std::vector<std::uint32_t> begins, points;  // vertex i has points[begins[i]] .. points[begins[i + 1] - 1]
  std::vector<std::uint32_t> triangles;       // without those that have fewer than three vertices

  explicit Welded(const Surface& surface);
  std::size_t size() const { return positions.size() / 3; }
};

Welded::Welded(const Surface& surface) : vertex_of(surface.size()) {
  const PointSet& from = surface.points;
  std::vector<float> places(from.positions.begin(), from.positions.end());
  common::join_rounded_places(places, surface.triangles);
  for (float& number : places) number += 0.0F;  // -0 becomes 0; bytes are compared
  std::vector<meshopt_Stream> streams{{places.data(), 3 * sizeof(float), 3 * sizeof(float)}};
  if (!from.colours.empty()) streams.push_back({from.colours.data(), 3, 3});
  if (!from.texcoords.empty()) streams.push_back({from.texcoords.data(), 2 * sizeof(float), 2 * sizeof(float)});
  const std::size_t count =
      meshopt_generateVertexRemapMulti(vertex_of.data(), surface.triangles.data(), surface.triangles.size(),
                                       surface.size(), streams.data(), streams.size());
  positions.resize(3 * count);
  begins.resize(count + 1);
  for (const std::uint32_t vertex : vertex_of) {
    if (vertex != none) ++begins[vertex + 1];
  }
  for (std::size_t i = 0; i < count; ++i) begins[i + 1] += begins[i];
  points.resize(begins.back());
  std::vector<std::uint32_t> next(begins.begin(), begins.end() - 1);
  for (std::uint32_t i = 0; i < vertex_of.size(); ++i) {
    if (vertex_of[i] == none) continue;
    points[next[vertex_of[i]]++] = i;
    std::copy_n(&places[3 * std::size_t{i}], 3, &positions[3 * std::size_t{vertex_of[i]}]);
  }
  triangles.reserve(surface.triangles.size());
  for (std::size_t t = 0; t < surface.triangles.size(); t += 3) {
    const std::uint32_t a = vertex_of[surface.triangles[t]], b = vertex_of[surface.triangles[t + 1]];
    const std::uint32_t c = vertex_of[surface.triangles[t + 2]];
    if (a != b && b != c && c != a) triangles.insert(triangles.end(), {a, b, c});
  }
}

// Returns the positions, each moved by less than `most` on each axis. Equal positions move alike. In flat faces, collapses
// cost nothing and make triangles without area, after which meshoptimizer 0.18 does not see that a triangle turns over.
// Among moved points, three are hardly ever on a line.
std::vector<float> moved_a_little(const std::vector<float>& positions, float most) {
  std::vector<float> moved(positions.size());
  for (std::size_t i = 0; i + 2 < positions.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = common::mixed_bits(bits ^ std::bit_cast<std::uint32_t>(positions[i + k]));
    for (std::size_t k = 0; k < 3; ++k) {
      bits = common::mixed_bits(bits + 1);
      const float share = static_cast<float>(bits >> 8) / static_cast<float>(1U << 23) - 1;  // -1 to 1
      moved[i + k] = positions[i + k] + most * share;
    }
  }
  return moved;
}

// Replaces each vertex by one of its points: the first whose normal is nearest to the normal of the triangle.
void choose_points(const Surface& surface, const Welded& welded, std::vector<std::uint32_t>& triangles) {
  for (std::size_t t = 0; t < triangles.size(); t += 3) {
    Float4 corners[3];
    for (std::size_t k = 0; k < 3; ++k) corners[k] = surface.point(welded.points[welded.begins[triangles[t + k]]]);
    const Float4 normal = without_fourth(cross(corners[1] - corners[0], corners[2] - corners[0]));
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t vertex = triangles[t + k];
      float most = -std::numeric_limits<float>::infinity();
      triangles[t + k] = welded.points[welded.begins[vertex]];
      for (std::uint32_t i = welded.begins[vertex]; i < welded.begins[vertex + 1]; ++i) {
        const std::uint32_t point = welded.points[i];
        const float along = dot(without_fourth(unit_normal(&surface.points.normals[3 * std::size_t{point}])), normal);
        if (along <= most) continue;
        most = along;
        triangles[t + k] = point;
      }
    }
  }
}

template <typename Number>
std::vector<Number> chosen(std::span<const Number> all, std::span<const std::uint32_t> points, std::size_t size) {
  std::vector<Number> result;
  if (all.empty()) return result;
  result.reserve(size * points.size());
  for (const std::uint32_t point : points) result.insert(result.end(), &all[size * point], &all[size * point] + size);
  return result;
}

// Keeps the points of the surface that the triangles use, in their order.
Simplified with_used_points(const Surface& surface, std::vector<std::uint32_t> triangles) {
  Simplified result;
  result.representatives.assign(surface.size(), none);
  for (const std::uint32_t i : triangles) result.representatives[i] = 0;
  std::vector<std::uint32_t> kept;
  for (std::uint32_t i = 0; i < surface.size(); ++i) {
    if (result.representatives[i] == none) continue;
    result.representatives[i] = static_cast<std::uint32_t>(kept.size());
    kept.push_back(i);
  }
  for (std::uint32_t& i : triangles) i = result.representatives[i];
  result.triangles = std::move(triangles);
  result.positions = chosen(surface.points.positions, kept, 3);
  result.normals.reserve(3 * kept.size());
  for (const std::uint32_t i : kept) {
    const Float4 normal = unit_normal(&surface.points.normals[3 * std::size_t{i}]);
    result.normals.insert(result.normals.end(), {normal[0], normal[1], normal[2]});
  }
  result.colours = chosen(surface.points.colours, kept, 3);
  result.texcoords = chosen(surface.points.texcoords, kept, 2);
  return result;
}

Simplified whole(const Surface& surface) {
  std::vector<std::uint32_t> all(surface.size());
  std::iota(all.begin(), all.end(), 0U);
  Simplified result = with_used_points(surface, std::move(all));
  result.triangles.assign(surface.triangles.begin(), surface.triangles.end());
  result.method = Method::collapse;
  return result;
}

// Collapses the edges of a surface. Vertices can be locked for a further try.
class Collapser {
 public:
  Collapser(const Surface& surface, const SimplifyOptions& options)
      : surface_(surface), options_(options), welded_(surface) {
    // meshoptimizer's errors are relative to the longest side of the bounding box.
    const float side = meshopt_simplifyScale(welded_.positions.data(), welded_.size(), 3 * sizeof(float));
    to_diagonal_ = side / (surface.cube.diagonal * surface.cube.side);
    positions_ = moved_a_little(welded_.positions, little * side);
  }

  Simplified run() {
    const bool has_limit = options_.max_error > 0 || options_.target == 0;
    const float most_error = options_.max_error > 0 || options_.target > 0 ? options_.max_error : options_.threshold;
    const std::size_t target = std::min(3 * options_.target, welded_.triangles.size());
    triangles_.resize(welded_.triangles.size());
    float error = 0;
    triangles_.resize(meshopt_simplify(triangles_.data(), welded_.triangles.data(), welded_.triangles.size(),
                                       positions_.data(), positions_.size() / 3, 3 * sizeof(float), target,
                                       has_limit ? most_error / to_diagonal_ : 1e9F, 0, &error));
    std::vector<std::uint32_t> triangles = triangles_;
    choose_points(surface_, welded_, triangles);
    Simplified result = with_used_points(surface_, std::move(triangles));
    result.method = Method::collapse;
    result.error = error * to_diagonal_;
    part_touching_sheets(surface_, has_limit ? most_error : 1, result);
    return result;
  }

  // Locks the vertices around the edges that had more than two triangles in the last run, but not in the surface. So the
  // triangles there stay those of the surface. Returns whether there was any to lock.
  bool lock_crowded_edges() {
    if (places_.empty()) find_places();
    const std::vector<Edge> edges = crowded_edges(at_places(triangles_), welded_.size());
    std::vector<std::uint8_t> is_end(welded_.size());
    for (const Edge& edge : edges) {
      if (std::binary_search(given_.begin(), given_.end(), edge)) continue;
      is_end[edge.first] = is_end[edge.second] = 1;
    }
    std::vector<std::uint8_t> is_near(welded_.size());
    for (std::size_t t = 0; t < given_triangles_.size(); t += 3) {
      const std::uint32_t* const corners = &given_triangles_[t];
      if ((is_end[corners[0]] | is_end[corners[1]] | is_end[corners[2]]) == 0) continue;
      for (std::size_t k = 0; k < 3; ++k) is_near[corners[k]] = 1;
    }
    bool any = false;
    for (std::uint32_t i = 0; i < is_near.size(); ++i) {
      if (is_near[i] == 0 || is_locked_[i] != 0) continue;
      any = true;
      lock(i);
    }
    return any;
  }

 private:
  void find_places() {
    places_.resize(welded_.size());
    meshopt_generateVertexRemap(places_.data(), nullptr, welded_.size(), welded_.positions.data(), welded_.size(),
                                3 * sizeof(float));
    is_locked_.resize(welded_.size());
    at_place_.resize(welded_.size());
    for (std::uint32_t i = 0; i < welded_.size(); ++i) at_place_[places_[i]] = i;
    given_triangles_ = at_places(welded_.triangles);
    given_ = crowded_edges(given_triangles_, welded_.size());
  }

  std::vector<std::uint32_t> at_places(const std::vector<std::uint32_t>& triangles) const {
    std::vector<std::uint32_t> result;
    result.reserve(triangles.size());
    for (const std::uint32_t i : triangles) result.push_back(places_[i]);
    return result;
  }

  // meshoptimizer 0.18 has no other way to lock a vertex: one with three or more copies does not move.
  void lock(std::uint32_t place) {
    is_locked_[place] = 1;
    std::array<float, 3> position{};
    std::copy_n(&positions_[3 * std::size_t{at_place_[place]}], 3, position.begin());
    for (int copy = 0; copy < 2; ++copy) positions_.insert(positions_.end(), position.begin(), position.end());
  }

  const Surface& surface_;
  const SimplifyOptions& options_;
  Welded welded_;
  float to_diagonal_ = 1;
  std::vector<float> positions_;                // moved a little, then copies of those that are locked
  std::vector<std::uint32_t> triangles_;        // of the last run
  std::vector<std::uint32_t> places_;           // [vertices]: vertices at one position have one place
  std::vector<std::uint32_t> at_place_;         // a vertex of each place
  std::vector<std::uint8_t> is_locked_;         // [places]
  std::vector<std::uint32_t> given_triangles_;  // of the surface, between places
  std::vector<Edge> given_;                     // its edges of more than two triangles
};

}  // namespace

// Some edges of more than two triangles cannot be parted. Then the vertices around them are locked, and the surface is
// collapsed again, unless that leaves too many triangles.
Simplified collapse(const Surface& surface, const SimplifyOptions& options) {
  if (options.max_error == 0 && options.target >= surface.triangles.size() / 3) return whole(surface);
  Collapser collapser(surface, options);
  Simplified best = collapser.run();
  std::size_t least = crowded_edge_count(best.positions, best.triangles);
  if (least == 0) return best;
  const std::size_t given = crowded_edge_count(surface.points.positions, surface.triangles);
  const std::size_t most = std::max(options.target, best.triangles.size() / 3);
  for (int tries = 0; tries < most_tries && least > given && collapser.lock_crowded_edges(); ++tries) {
    Simplified other = collapser.run();
    const std::size_t edges = crowded_edge_count(other.positions, other.triangles);
    if (options.target > 0 && other.triangles.size() / 3 > most) break;  // further locks leave still more
    if (edges >= least || other.triangles.empty()) continue;
    least = edges;
    best = std::move(other);
  }
  return best;
}

#else

Simplified collapse(const Surface&, const SimplifyOptions&) {
  throw Error(
      Element::option, 0,
      "method is collapse, but this build has no meshoptimizer; use cluster, or build with libmeshoptimizer-dev");
}

#endif

}  // namespace glark::vstree
