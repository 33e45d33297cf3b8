// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Builds the tables of stencils from the topology.
#include "glark/clients/qas/limit_step/limit_step.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "glark/clients/qas/limit_step/masks.h"

namespace glark::qas {
namespace {

struct Across {
  std::uint32_t vertex;
  bool smooth;
};

// The vertex on the other side of an edge. For a sharp edge it is one of the ends, with the weight 0.
Across across(const Topology& topology, std::uint32_t half_edge) {
  const std::uint32_t twin = topology.twin(half_edge);
  if (twin == none) return {topology.corner(half_edge), false};
  return {topology.opposite(twin), true};
}

}  // namespace

LimitStep::LimitStep(const Topology& topology)
    : vertex_count_(topology.vertex_count),
      edge_count_(topology.edges.size()),
      sector_count_(topology.sectors.size()),
      normal_count_(topology.sectors.size() + topology.edges.size()) {
  add_fans(topology);
  add_open_sectors(topology);
  add_edges(topology);
  add_patches(topology);
  normal_of_ = {};
}

// Adds the vertices inside closed fans, sorted by valence.
void LimitStep::add_fans(const Topology& topology) {
  std::vector<FanVertex> closed;
  for (std::uint32_t s = 0; s < topology.sectors.size(); ++s) {
    if (topology.sectors[s].closed) closed.push_back({topology.sectors[s].vertex, s});
  }
  const auto valence_of = [&](const FanVertex& v) { return topology.sectors[v.sector].count; };
  std::stable_sort(closed.begin(), closed.end(), [&](const FanVertex& a, const FanVertex& b) {
    return valence_of(a) != valence_of(b) ? valence_of(a) < valence_of(b) : a.vertex < b.vertex;
  });
  for (const FanVertex& one : closed) {
    const Sector& sector = topology.sectors[one.sector];
    if (topology.rules[one.vertex] == Rule::smooth) {
      add_to_fan(one, sector.count);
      continue;
    }
    // Several fans meet: the vertex stays where it is, and each fan has its own normal.
    open_sectors_.push_back({one.sector, one.vertex, sector.count, rings_.size(), weights_.size(), false, true});
    add_closed_tangents(sector.count);
    add_ring(topology, sector, sector.count);
  }
  for (Fan& fan : fans_) {
    fan.first_ring = rings_.size();
    for (std::uint32_t i = fan.first; i < fan.first + fan.count; ++i)
      add_ring(topology, topology.sectors[fan_vertices_[i].sector], fan.valence);
  }
}

void LimitStep::add_to_fan(const FanVertex& vertex, std::uint32_t valence) {
  if (fans_.empty() || fans_.back().valence != valence) {
    const double beta = loop_beta(valence);
    fans_.push_back({valence, static_cast<std::uint32_t>(fan_vertices_.size()), 0, 0, weights_.size(),
                     static_cast<float>(beta), static_cast<float>(1 / (3 / (8 * beta) + valence))});
    add_closed_tangents(valence);
  }
  ++fans_.back().count;
  fan_vertices_.push_back(vertex);
}

// Tangents of the smooth rule are the first Fourier mode of the ring.
void LimitStep::add_closed_tangents(std::uint32_t valence) {
  for (std::uint32_t i = 0; i < valence; ++i) {
    const double angle = 2 * std::numbers::pi * i / valence;
    weights_.push_back({static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))});
  }
}

void LimitStep::add_ring(const Topology& topology, const Sector& sector, std::uint32_t count) {
  const auto ring = topology.rings.begin() + sector.first;
  rings_.insert(rings_.end(), ring, ring + count);
}

void LimitStep::add_open_sectors(const Topology& topology) {
  for (std::uint32_t v = 0; v < topology.vertex_count; ++v) {
    if (topology.rules[v] == Rule::corner) corners_.push_back(v);
    if (topology.rules[v] != Rule::crease) continue;
    creases_.push_back({v, topology.crease_neighbours[v][0], topology.crease_neighbours[v][1]});
  }
  for (std::uint32_t s = 0; s < topology.sectors.size(); ++s) {
    const Sector& sector = topology.sectors[s];
    if (sector.closed) continue;
    const bool corner = topology.rules[sector.vertex] == Rule::corner;
    open_sectors_.push_back({s, sector.vertex, sector.count, rings_.size(), weights_.size(), corner, false});
    const auto ring = topology.rings.begin() + sector.first;
    rings_.insert(rings_.end(), ring, ring + sector.count);
    const TangentMask mask = tangent_mask(sector.count, corner);
    for (std::uint32_t i = 0; i < sector.count; ++i)
      weights_.push_back({static_cast<float>(mask.along(i)), static_cast<float>(mask.inwards(i))});
  }
}

void LimitStep::add_edges(const Topology& topology) {
  normal_of_.assign(topology.triangles.size(), none);
  auto extra_normal = static_cast<std::uint32_t>(normal_count_);
  for (std::uint32_t e = 0; e < topology.edges.size(); ++e) {
    if (topology.edges[e].smooth) {
      add_smooth_edge(topology, e);
    } else {
      add_sharp_edge(topology, e, extra_normal);
    }
  }
  normal_count_ = extra_normal;
}

void LimitStep::add_smooth_edge(const Topology& topology, std::uint32_t e) {
  const std::uint32_t left = topology.sides[topology.edges[e].first_side];
  const std::uint32_t right = topology.sides[topology.edges[e].first_side + 1];
  const std::uint32_t a = topology.corner(left), b = topology.corner(right);
  SmoothEdge edge{a, b, topology.opposite(left), topology.opposite(right), {}, e};
  const std::array<std::uint32_t, 4> around = {Topology::before(left), Topology::after(left), Topology::after(right),
                                               Topology::before(right)};
  MiddleWeights weights{};
  bool regular = true;
  for (std::size_t i = 0; i < 4; ++i) {
    const Across found = across(topology, around[i]);
    edge.across[i] = found.vertex;
    weights.ends[i] = found.smooth ? smooth_end : sharp_end;
    weights.opposites[i] = found.smooth ? smooth_opposite : sharp_opposite;
    regular = regular && found.smooth;
  }
  (regular ? regular_edges_ : general_edges_).push_back(edge);
  if (!regular) middle_weights_.push_back(weights);
  normal_of_[left] = normal_of_[right] = static_cast<std::uint32_t>(sector_count_) + e;
}

void LimitStep::add_sharp_edge(const Topology& topology, std::uint32_t e, std::uint32_t& extra_normal) {
  const Edge& edge = topology.edges[e];
  sharp_edges_.push_back({edge.ends[0], edge.ends[1], e});
  for (std::uint32_t i = 0; i < edge.side_count; ++i) {
    const std::uint32_t half_edge = topology.sides[edge.first_side + i];
    const std::uint32_t after = Topology::after(half_edge), before = Topology::before(half_edge);
    const Across beyond_a = across(topology, before), beyond_b = across(topology, after);
    const auto normal = i == 0 ? static_cast<std::uint32_t>(sector_count_) + e : extra_normal++;
    normal_of_[half_edge] = normal;
    sharp_sides_.push_back(
        {topology.corner(half_edge),
         topology.corner(after),
         topology.corner(before),
         {beyond_a.vertex, beyond_b.vertex},
         {beyond_a.smooth ? smooth_end : sharp_end, beyond_b.smooth ? smooth_end : sharp_end},
         {beyond_a.smooth ? smooth_opposite : sharp_opposite, beyond_b.smooth ? smooth_opposite : sharp_opposite},
         normal});
  }
}

void LimitStep::add_patches(const Topology& topology) {
  no_normal_ = normal_count_++;
  patches_.resize(topology.same_as.size());
  for (std::uint32_t t = 0; t < topology.same_as.size(); ++t) {
    Patch& patch = patches_[t];
    if (topology.same_as[t] == none) {
      patch.positions.fill(topology.triangles[3 * std::size_t{t}]);
      patch.normals.fill(static_cast<std::uint32_t>(no_normal_));
    } else if (topology.same_as[t] != t) {
      patch = copied_patch(topology, t);
    } else {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const std::uint32_t h = 3 * t + i;
        patch.positions[i] = topology.corner(h);
        patch.positions[3 + i] = topology.vertex_count + topology.edge_of[h];
        patch.normals[i] = topology.sector_of[h];
        patch.normals[3 + i] = normal_of_[h];
      }
    }
  }
}

// The patch of the original triangle, with its points in the order of the copy.
Patch LimitStep::copied_patch(const Topology& topology, std::uint32_t triangle) {
  const Patch& source = patches_[topology.same_as[triangle]];
  const std::uint32_t* const vertices = &topology.triangles[3 * std::size_t{triangle}];
  const auto place = [&](std::uint32_t vertex) {
    return static_cast<std::size_t>(std::find(source.positions.begin(), source.positions.begin() + 2, vertex) -
                                    source.positions.begin());
  };
  const bool reversed = (place(vertices[0]) + 1) % 3 != place(vertices[1]);
  Patch patch{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t from = place(vertices[i]);
    const std::size_t edge = 3 + (reversed ? (from + 2) % 3 : from);
    patch.positions[i] = source.positions[from];
    patch.positions[3 + i] = source.positions[edge];
    patch.normals[i] = source.normals[from];
    patch.normals[3 + i] = source.normals[edge];
  }
  if (reversed) {
    for (std::uint32_t& normal : patch.normals) {
      reversed_.push_back({normal, static_cast<std::uint32_t>(normal_count_)});
      normal = static_cast<std::uint32_t>(normal_count_++);
    }
  }
  return patch;
}

}  // namespace glark::qas
