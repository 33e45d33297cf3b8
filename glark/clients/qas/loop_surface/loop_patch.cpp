// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/qas/loop_surface/loop_patch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "glark/clients/qas/limit_step/masks.h"

namespace glark::qas {
namespace {

Point sum(double weight, const Point& a, double other, const Point& b) {
  return {weight * a[0] + other * b[0], weight * a[1] + other * b[1], weight * a[2] + other * b[2]};
}

void add(Point& to, double weight, const Point& point) { to = sum(1, to, weight, point); }

// A basis function and its derivatives by the three barycentric coordinates, times 12.
struct Basis {
  double value;
  std::array<double, 3> by;
};

// Based on: J. Stam, Evaluation of Loop Subdivision Surfaces, 1999, appendix A, by symmetry. The function of corner p:
Basis of_corner(double p, double q, double r) {
  const double q2 = q * q, r2 = r * r, p2 = p * p;
  return {6 * p2 * p2 + 24 * p2 * p * (q + r) + p2 * (24 * q2 + 60 * q * r + 24 * r2) +
              p * (8 * q2 * q + 36 * q2 * r + 36 * q * r2 + 8 * r2 * r) + q2 * q2 + 6 * q2 * q * r + 12 * q2 * r2 +
              6 * q * r2 * r + r2 * r2,
          {24 * p2 * p + 72 * p2 * (q + r) + 2 * p * (24 * q2 + 60 * q * r + 24 * r2) + 8 * q2 * q + 36 * q2 * r +
               36 * q * r2 + 8 * r2 * r,
           24 * p2 * p + p2 * (48 * q + 60 * r) + p * (24 * q2 + 72 * q * r + 36 * r2) + 4 * q2 * q + 18 * q2 * r +
               24 * q * r2 + 6 * r2 * r,
           24 * p2 * p + p2 * (60 * q + 48 * r) + p * (36 * q2 + 72 * q * r + 24 * r2) + 6 * q2 * q + 24 * q2 * r +
               18 * q * r2 + 4 * r2 * r}};
}

// The function of the vertex beyond the edge p q:
Basis beyond_edge(double p, double q, double r) {
  const double q2 = q * q, p2 = p * p;
  return {p2 * p2 + 2 * p2 * p * r + 6 * p2 * p * q + 6 * p2 * q * r + 12 * p2 * q2 + 6 * p * q2 * r + 6 * p * q2 * q +
              2 * q2 * q * r + q2 * q2,
          {4 * p2 * p + 6 * p2 * r + 18 * p2 * q + 12 * p * q * r + 24 * p * q2 + 6 * q2 * r + 6 * q2 * q,
           6 * p2 * p + 6 * p2 * r + 24 * p2 * q + 12 * p * q * r + 18 * p * q2 + 6 * q2 * r + 4 * q2 * q,
           2 * p2 * p + 6 * p2 * q + 6 * p * q2 + 2 * q2 * q}};
}

// The function of an outer vertex. It is a neighbour of p only and lies on the side of q:
Basis outer(double p, double q) { return {p * p * p * (p + 2 * q), {4 * p * p * p + 6 * p * p * q, 2 * p * p * p, 0}}; }

}  // namespace

LoopPatch::LoopPatch(const Neighbourhood& around, const std::vector<Point>& positions) {
  std::vector<std::uint32_t> vertices;
  const auto local = [&](std::uint32_t vertex) {
    const auto found = std::find(vertices.begin(), vertices.end(), vertex);
    const auto index = static_cast<std::uint32_t>(found - vertices.begin());
    if (found == vertices.end()) {
      vertices.push_back(vertex);
      positions_.push_back(positions[vertex]);
    }
    return index;
  };
  Neighbourhood mine;
  for (const std::uint32_t vertex : around.triangles) mine.triangles.push_back(local(vertex));
  for (const std::uint32_t vertex : around.creases) mine.creases.push_back(local(vertex));
  topology_ = analyse({vertices.size(), mine.triangles, mine.creases});
  find_control_points();
}

// Counter-clockwise, the ring of a corner consists of:
// - the next corner and the last corner;
// - the vertex beyond the edge to the last corner;
// - two outer vertices;
// - the vertex beyond the edge to the next corner.
void LoopPatch::find_control_points() {
  regular_ = true;
  for (std::uint32_t i = 0; i < 3 && regular_; ++i) {
    const std::uint32_t vertex = topology_.triangles[i];
    const Sector& sector = topology_.sectors[topology_.sector_of[i]];
    const auto ring = topology_.rings.begin() + sector.first;
    regular_ = topology_.rules[vertex] == Rule::smooth && sector.count == 6;
    for (std::uint32_t j = 0; j < 6 && regular_; ++j) regular_ = ring[j] != ring[(j + 1) % 6];
    if (!regular_) return;
    const auto start = static_cast<std::size_t>(std::find(ring, ring + 6, topology_.triangles[(i + 1) % 3]) - ring);
    control_[4 * i] = vertex;
    for (std::size_t j = 1; j < 4; ++j) control_[4 * i + j] = ring[static_cast<std::ptrdiff_t>((start + 6 - j) % 6)];
  }
  for (const Edge& edge : topology_.edges) {  // a dart has its crease among these edges
    const bool touches = std::any_of(edge.ends.begin(), edge.ends.end(), [&](std::uint32_t vertex) {
      return std::find(topology_.triangles.begin(), topology_.triangles.begin() + 3, vertex) !=
             topology_.triangles.begin() + 3;
    });
    if (touches && !edge.smooth) regular_ = false;
  }
}

Jet LoopPatch::box_spline(const std::array<double, 3>& barycentric) const {
  Jet jet;
  const auto take = [&](std::uint32_t control, const Basis& basis, std::size_t p, std::size_t q, std::size_t r) {
    std::array<double, 3> by{};
    by[p] += basis.by[0];
    by[q] += basis.by[1];
    by[r] += basis.by[2];
    add(jet.position, basis.value / 12, positions_[control]);
    add(jet.tangents[0], by[1] - by[0], positions_[control]);
    add(jet.tangents[1], by[2] - by[0], positions_[control]);
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3, last = (i + 2) % 3;
    const double p = barycentric[i], q = barycentric[next], r = barycentric[last];
    take(control_[4 * i], of_corner(p, q, r), i, next, last);
    take(control_[4 * i + 1], beyond_edge(p, q, r), i, next, last);
    take(control_[4 * i + 2], outer(p, q), i, next, last);
    take(control_[4 * i + 3], outer(p, r), i, last, next);
  }
  return jet;
}

Jet LoopPatch::limit(std::uint32_t corner) const {
  const std::uint32_t vertex = topology_.triangles[corner];
  const Sector& sector = topology_.sectors[topology_.sector_of[corner]];
  const auto ring = [&](std::uint32_t i) { return positions_[topology_.rings[sector.first + i]]; };
  const Point centre = positions_[vertex];
  const std::uint32_t n = sector.count;
  Jet jet{centre, {}};
  if (sector.closed) {
    Point about{};
    for (std::uint32_t i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * i / n;
      add(jet.tangents[0], std::cos(angle), ring(i));
      add(jet.tangents[1], std::sin(angle), ring(i));
      add(about, 1, ring(i));
    }
    const double weight = 1 / (3 / (8 * loop_beta(n)) + n);
    if (topology_.rules[vertex] == Rule::smooth) jet.position = sum(1 - n * weight, centre, weight, about);
    return jet;
  }
  const TangentMask mask = tangent_mask(n, topology_.rules[vertex] == Rule::corner);
  for (std::uint32_t i = 0; i < n; ++i) {
    const Point spoke = sum(1, ring(i), -1, centre);
    add(jet.tangents[0], mask.along(i), spoke);
    add(jet.tangents[1], mask.inwards(i), spoke);
  }
  if (topology_.rules[vertex] == Rule::crease) {
    const auto& ends = topology_.crease_neighbours[vertex];
    jet.position = sum(2.0 / 3, centre, 1.0 / 6, sum(1, positions_[ends[0]], 1, positions_[ends[1]]));
  }
  return jet;
}

std::vector<Point> LoopPatch::subdivided() const {
  std::vector<Point> to = positions_;
  for (const Sector& sector : topology_.sectors) {
    if (topology_.rules[sector.vertex] != Rule::smooth) continue;
    const double beta = loop_beta(sector.count);
    Point& point = to[sector.vertex];
    point = sum(1 - beta * sector.count, point, 0, point);
    for (std::uint32_t i = 0; i < sector.count; ++i) add(point, beta, positions_[topology_.rings[sector.first + i]]);
  }
  for (std::uint32_t v = 0; v < topology_.vertex_count; ++v) {
    if (topology_.rules[v] != Rule::crease) continue;
    const auto& ends = topology_.crease_neighbours[v];
    to[v] = sum(0.75, positions_[v], 0.125, sum(1, positions_[ends[0]], 1, positions_[ends[1]]));
  }
  for (const Edge& edge : topology_.edges) {
    const Point ends = sum(1, positions_[edge.ends[0]], 1, positions_[edge.ends[1]]);
    if (edge.smooth) {
      const Point opposites = sum(1, positions_[topology_.opposite(topology_.sides[edge.first_side])], 1,
                                  positions_[topology_.opposite(topology_.sides[edge.first_side + 1])]);
      to.push_back(sum(0.375, ends, 0.125, opposites));
    } else {
      to.push_back(sum(0.5, ends, 0, ends));
    }
  }
  return to;
}

LoopPatch LoopPatch::child(std::uint32_t which) const {
  const auto middle = [&](std::uint32_t half_edge) { return topology_.vertex_count + topology_.edge_of[half_edge]; };
  std::vector<std::array<std::uint32_t, 3>> all;
  for (std::uint32_t h = 0; h < topology_.triangles.size(); h += 3) {
    const std::array<std::uint32_t, 3> corners = {topology_.corner(h), topology_.corner(h + 1),
                                                  topology_.corner(h + 2)};
    const std::array<std::uint32_t, 3> middles = {middle(h), middle(h + 1), middle(h + 2)};
    all.push_back({corners[0], middles[0], middles[2]});
    all.push_back({middles[0], corners[1], middles[1]});
    all.push_back({middles[2], middles[1], corners[2]});
    all.push_back(middles);
  }
  const std::array<std::uint32_t, 3> centre = all[which];
  std::swap(all[0], all[which]);
  Neighbourhood around;
  for (const auto& triangle : all) {
    const bool touches =
        std::find_first_of(triangle.begin(), triangle.end(), centre.begin(), centre.end()) != triangle.end();
    if (touches) around.triangles.insert(around.triangles.end(), triangle.begin(), triangle.end());
  }
  const auto in_centre = [&](std::uint32_t vertex) {
    return std::find(centre.begin(), centre.end(), vertex) != centre.end();
  };
  for (std::uint32_t e = 0; e < topology_.edges.size(); ++e) {
    const Edge& edge = topology_.edges[e];
    if (!edge.marked) continue;
    for (const std::uint32_t end : edge.ends) {
      if (in_centre(end) || in_centre(topology_.vertex_count + e))
        around.creases.insert(around.creases.end(), {end, topology_.vertex_count + e});
    }
  }
  return LoopPatch(around, subdivided());
}

}  // namespace glark::qas
