// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/qas/limit_step/butterfly_step.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "glark/clients/qas/limit_step/masks.h"

namespace glark::qas {
namespace {

constexpr double sixth = std::numbers::pi / 3;

// Returns the closed fan around the vertex where the half-edge starts. Returns null if a crease meets the vertex.
const Sector* fan_of(const Topology& topology, std::uint32_t half_edge) {
  const Sector& sector = topology.sectors[topology.sector_of[half_edge]];
  return topology.rules[sector.vertex] == Rule::smooth ? &sector : nullptr;
}

bool extraordinary(const Sector* fan) { return fan != nullptr && fan->count != 6; }

// Returns the weight of neighbour i of a vertex of valence n. Neighbour 0 is the other end of the edge. The vertex
// itself has the weight 3/4.
double spoke_weight(std::uint32_t i, std::uint32_t n) {
  if (n == 3) return i == 0 ? 5.0 / 12 : -1.0 / 12;
  if (n == 4) return i == 0 ? 3.0 / 8 : (i == 2 ? -1.0 / 8 : 0);
  const double angle = 2 * std::numbers::pi * i / n;
  return (0.25 + std::cos(angle) + 0.5 * std::cos(2 * angle)) / n;
}

}  // namespace

ButterflyStep::ButterflyStep(const Topology& topology, const LimitStep& numbering)
    : vertex_count_(topology.vertex_count), numbering_(numbering), triangles_(topology.triangles) {
  for (std::uint32_t e = 0; e < topology.edges.size(); ++e) {
    first_term_.push_back(terms_.size());
    add_edge(topology, e);
  }
  first_term_.push_back(terms_.size());
  std::vector<std::uint32_t> corner_in(topology.sectors.size(), none);
  for (std::uint32_t h = 0; h < topology.triangles.size(); ++h) {
    if (topology.edge_of[h] == none || corner_in[topology.sector_of[h]] != none) continue;
    corner_in[topology.sector_of[h]] = h;
    add_vertex_normal(topology, h);
  }
  for (std::uint32_t e = 0; e < topology.edges.size(); ++e) add_edge_normals(topology, e);
  for (std::size_t i = 0; i < normals_.size(); ++i)
    normals_[i].last = i + 1 < normals_.size() ? normals_[i + 1].first : tangent_terms_.size();
}

void ButterflyStep::add_term(std::uint32_t vertex, double weight) {
  terms_.push_back({vertex, static_cast<float>(weight)});
}

void ButterflyStep::add_edge(const Topology& topology, std::uint32_t e) {
  const Edge& edge = topology.edges[e];
  if (!edge.smooth) {
    add_crease(topology, edge);
    return;
  }
  const std::array<std::uint32_t, 2> sides = {topology.sides[edge.first_side], topology.sides[edge.first_side + 1]};
  const bool first = extraordinary(fan_of(topology, sides[0])), second = extraordinary(fan_of(topology, sides[1]));
  for (std::size_t i = 0; i < 2; ++i) {
    if (!first && !second) {
      add_wing(topology, sides[i]);
    } else if (i == 0 ? first : second) {
      add_spokes(topology, sides[i], first && second ? 0.5 : 1);
    }
  }
}

// Adds four points along the crease. Where the crease ends, the far end is mirrored.
void ButterflyStep::add_crease(const Topology& topology, const Edge& edge) {
  for (std::size_t i = 0; i < 2; ++i) {
    const std::uint32_t a = edge.ends[i], b = edge.ends[1 - i];
    if (topology.rules[a] == Rule::crease) {
      const auto& along = topology.crease_neighbours[a];
      add_term(a, 9.0 / 16);
      add_term(along[0] == b ? along[1] : along[0], -1.0 / 16);
    } else {
      add_term(a, 7.0 / 16);
      add_term(b, 1.0 / 16);
    }
  }
}

// Adds the rule of the extraordinary vertex where the half-edge starts.
void ButterflyStep::add_spokes(const Topology& topology, std::uint32_t half_edge, double share) {
  const Sector& fan = *fan_of(topology, half_edge);
  const auto ring = topology.rings.begin() + fan.first;
  const auto start =
      static_cast<std::uint32_t>(std::find(ring, ring + fan.count, topology.corner(Topology::after(half_edge))) - ring);
  add_term(fan.vertex, 0.75 * share);
  for (std::uint32_t i = 0; i < fan.count; ++i)
    add_term(ring[static_cast<std::ptrdiff_t>((start + i) % fan.count)], share * spoke_weight(i, fan.count));
}

// Adds one side of the regular stencil, with the vertex where the half-edge starts.
void ButterflyStep::add_wing(const Topology& topology, std::uint32_t half_edge) {
  add_term(topology.corner(half_edge), 0.5);
  add_term(topology.opposite(half_edge), 1.0 / 8);
  for (const std::uint32_t beside : {Topology::after(half_edge), Topology::before(half_edge)}) {
    const std::uint32_t twin = topology.twin(beside);
    if (twin != none) {
      add_term(topology.opposite(twin), -1.0 / 16);
      continue;
    }
    add_term(topology.corner(beside), -1.0 / 16);
    add_term(topology.corner(Topology::after(beside)), -1.0 / 16);
    add_term(topology.opposite(beside), 1.0 / 16);
  }
}

void ButterflyStep::begin_normal(std::uint32_t centre, std::uint32_t normal, std::uint32_t half_edge) {
  normals_.push_back({centre, normal, tangent_terms_.size(), 0, half_edge / 3});
}

void ButterflyStep::add_tangent(std::uint32_t point, double weight, double angle) {
  tangent_terms_.push_back(
      {point, static_cast<float>(weight * std::cos(angle)), static_cast<float>(weight * std::sin(angle))});
}

// Adds the first Fourier mode of the ring after the step. At a regular vertex, the left eigenvector also includes the
// second ring.
void ButterflyStep::add_vertex_normal(const Topology& topology, std::uint32_t half_edge) {
  const Sector& sector = topology.sectors[topology.sector_of[half_edge]];
  const auto middle = [&](std::uint32_t h) { return topology.vertex_count + topology.edge_of[h]; };
  begin_normal(sector.vertex, topology.sector_of[half_edge], half_edge);
  std::vector<std::uint32_t> corners;  // the corners of the sector's triangles, in the order of the ring
  std::uint32_t h = half_edge;
  while (topology.corner(Topology::after(h)) != topology.rings[sector.first]) h = Topology::after(topology.twin(h));
  const std::uint32_t triangles = sector.count - (sector.closed ? 0 : 1);
  while (corners.size() < triangles) {
    corners.push_back(h);
    h = topology.twin(Topology::before(h));  // none after the last of an open fan
  }
  if (!sector.closed) {
    const TangentMask mask = tangent_mask(sector.count, topology.rules[sector.vertex] == Rule::corner);
    for (std::uint32_t i = 0; i < sector.count; ++i) {
      const std::uint32_t point = i < corners.size() ? middle(corners[i]) : middle(Topology::before(corners.back()));
      tangent_terms_.push_back({point, static_cast<float>(mask.along(i)), static_cast<float>(mask.inwards(i))});
    }
    return;
  }
  for (std::uint32_t i = 0; i < corners.size(); ++i) {
    const double angle = 2 * std::numbers::pi * i / sector.count;
    add_tangent(middle(corners[i]), 1, angle);
    if (sector.count != 6) continue;
    add_tangent(topology.corner(Topology::after(corners[i])), 1.0 / 16, angle);
    add_tangent(middle(Topology::after(corners[i])), -std::sqrt(3.0) / 6, angle + sixth / 2);
  }
}

void ButterflyStep::add_edge_normals(const Topology& topology, std::uint32_t e) {
  const Edge& edge = topology.edges[e];
  if (edge.smooth) {
    add_smooth_edge_normal(topology, e);
    return;
  }
  const auto middle = [&](std::uint32_t h) { return topology.vertex_count + topology.edge_of[h]; };
  for (std::uint32_t i = 0; i < edge.side_count; ++i) {
    const std::uint32_t h = topology.sides[edge.first_side + i];
    begin_normal(middle(h), numbering_.patches()[h / 3].normals[3 + h % 3], h);
    const TangentMask mask = tangent_mask(4, false);
    const std::array<std::uint32_t, 4> ring = {topology.corner(Topology::after(h)), middle(Topology::after(h)),
                                               middle(Topology::before(h)), topology.corner(h)};
    for (std::uint32_t k = 0; k < 4; ++k)
      tangent_terms_.push_back({ring[k], static_cast<float>(mask.along(k)), static_cast<float>(mask.inwards(k))});
  }
}

// The middle of an edge has valence 6 after the step. At creases and beyond the ends of the edge, its second ring lacks
// vertices. The first ring at twice the distance replaces these vertices. Their weight in the mask is 1/16.
void ButterflyStep::add_smooth_edge_normal(const Topology& topology, std::uint32_t e) {
  const std::uint32_t left = topology.sides[topology.edges[e].first_side];
  const std::uint32_t right = topology.sides[topology.edges[e].first_side + 1];
  const auto middle = [&](std::uint32_t h) { return topology.vertex_count + topology.edge_of[h]; };
  begin_normal(topology.vertex_count + e, numbering_.patches()[left / 3].normals[3 + left % 3], left);
  const auto half = [&](std::uint32_t h, double start) {  // from the edge's second end to its first
    const std::uint32_t after = Topology::after(h), before = Topology::before(h);
    const std::uint32_t beyond_after = topology.twin(after), beyond_before = topology.twin(before);
    add_tangent(topology.corner(after), 1 + 2.0 / 16, start);
    add_tangent(middle(after), 1, start + sixth);
    add_tangent(middle(before), 1, start + 2 * sixth);
    const double diagonal = -std::sqrt(3.0) / 6;
    add_tangent(topology.opposite(h), diagonal, start + 1.5 * sixth);
    if (beyond_after != none) {
      add_tangent(middle(Topology::after(beyond_after)), diagonal, start + 0.5 * sixth);
      add_tangent(middle(Topology::before(beyond_after)), 1.0 / 16, start + sixth);
    } else {  // the mirror image: the sum of the two neighbours in the ring
      add_tangent(topology.corner(after), diagonal, start + 0.5 * sixth);
      add_tangent(middle(after), diagonal, start + 0.5 * sixth);
      add_tangent(middle(after), 2.0 / 16, start + sixth);
    }
    if (beyond_before != none) {
      add_tangent(middle(Topology::before(beyond_before)), diagonal, start + 2.5 * sixth);
      add_tangent(middle(Topology::after(beyond_before)), 1.0 / 16, start + 2 * sixth);
    } else {
      add_tangent(middle(before), diagonal, start + 2.5 * sixth);
      add_tangent(topology.corner(h), diagonal, start + 2.5 * sixth);
      add_tangent(middle(before), 2.0 / 16, start + 2 * sixth);
    }
  };
  half(left, 0);
  half(right, std::numbers::pi);
}

void ButterflyStep::subdivide(const Workers& workers, const Float4* from, Float4* to) const {
  std::copy_n(from, vertex_count_, to);
  workers.evenly(first_term_.size() - 1, [&](auto begin, auto end) {
    for (auto e = begin; e < end; ++e) {
      const Float4 near = from[terms_[first_term_[e]].point];
      Float4 sum{};
      for (std::size_t i = first_term_[e]; i < first_term_[e + 1]; ++i)
        sum += terms_[i].weight * (from[terms_[i].point] - near);
      to[vertex_count_ + e] = near + sum;
    }
  });
}

void ButterflyStep::run(const Workers& workers, const LimitStep::Frame& frame, Float4* points) const {
  subdivide(workers, frame.from, points);
  workers.evenly(numbering_.position_count(), [&](auto begin, auto end) {
    for (auto i = begin; i < end; ++i) store(frame.positions[i], points[i] * frame.unscale + Float4{0, 0, 0, 1});
  });
  workers.evenly(normals_.size(), [&](auto begin, auto end) {
    for (auto i = begin; i < end; ++i) {
      const Normal& which = normals_[i];
      Float4 first{}, second{}, normal;
      for (std::size_t k = which.first; k < which.last; ++k) {
        const TangentTerm& term = tangent_terms_[k];
        const Float4 spoke = points[term.point] - points[which.centre];
        first += term.first * spoke;
        second += term.second * spoke;
      }
      if (!unit_normal(first, second, normal)) {
        const std::uint32_t* const v = &triangles_[3 * std::size_t{which.coarse}];
        normal = unit_or_z(cross(frame.from[v[1]] - frame.from[v[0]], frame.from[v[2]] - frame.from[v[0]]));
      }
      store(frame.normals[which.normal], normal);
    }
  });
  numbering_.finish(frame);
}

}  // namespace glark::qas
