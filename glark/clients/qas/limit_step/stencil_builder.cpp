// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Builds the tables of stencils from the topology.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "glark/clients/qas/limit_step/masks.h"
#include "glark/clients/qas/limit_step/stencils.h"

namespace glark::qas {
namespace {

struct Across {
  std::uint32_t vertex;
  bool smooth;
};

// Returns the vertex on the other side of an edge. For a sharp edge, it is one of the ends, with the weight 0.
Across across(const Topology& topology, std::uint32_t half_edge) {
  const std::uint32_t twin = topology.twin(half_edge);
  if (twin == none) return {topology.corner(half_edge), false};
  return {topology.opposite(twin), true};
}

class StencilBuilder {
 public:
  explicit StencilBuilder(const Topology& topology) : topology_(topology) {
    result_.counts = {topology.vertex_count, topology.edges.size(), topology.sectors.size(),
                      topology.sectors.size() + topology.edges.size()};
  }

  Stencils build() {
    add_fans();
    add_open_sectors();
    add_edges();
    add_patches();
    return std::move(result_);
  }

 private:
  void add_fans();
  void add_to_fan(const FanVertex& vertex, std::uint32_t valence);
  void add_closed_tangents(std::uint32_t valence);
  void add_ring(const Sector& sector, std::uint32_t count);
  void add_open_sectors();
  void add_edges();
  void add_smooth_edge(std::uint32_t edge);
  void add_sharp_edge(std::uint32_t edge, std::uint32_t& extra_normal);
  void add_patches();
  Patch copied_patch(std::uint32_t triangle);

  const Topology& topology_;
  Stencils result_;
  std::vector<std::uint32_t> normal_of_;  // the normal of each half-edge
};

}  // namespace

// Adds the vertices inside closed fans, sorted by valence.
void StencilBuilder::add_fans() {
  std::vector<FanVertex> closed;
  for (std::uint32_t s = 0; s < topology_.sectors.size(); ++s) {
    if (topology_.sectors[s].closed) closed.push_back({topology_.sectors[s].vertex, s});
  }
  const auto valence_of = [&](const FanVertex& v) { return topology_.sectors[v.sector].count; };
  std::stable_sort(closed.begin(), closed.end(), [&](const FanVertex& a, const FanVertex& b) {
    return valence_of(a) != valence_of(b) ? valence_of(a) < valence_of(b) : a.vertex < b.vertex;
  });
  for (const FanVertex& one : closed) {
    const Sector& sector = topology_.sectors[one.sector];
    if (topology_.rules[one.vertex] == Rule::smooth) {
      add_to_fan(one, sector.count);
      continue;
    }
    // If several fans meet, the vertex stays where it is, and each fan has its own normal.
    result_.vertices.open_sectors.push_back(
        {one.sector, one.vertex, sector.count, result_.rings.size(), result_.weights.size(), false, true});
    add_closed_tangents(sector.count);
    add_ring(sector, sector.count);
  }
  for (Fan& fan : result_.vertices.fans) {
    fan.first_ring = result_.rings.size();
    for (std::uint32_t i = fan.first; i < fan.first + fan.count; ++i)
      add_ring(topology_.sectors[result_.vertices.fan_vertices[i].sector], fan.valence);
  }
}

void StencilBuilder::add_to_fan(const FanVertex& vertex, std::uint32_t valence) {
  if (result_.vertices.fans.empty() || result_.vertices.fans.back().valence != valence) {
    const double beta = loop_beta(valence);
    result_.vertices.fans.push_back({valence, static_cast<std::uint32_t>(result_.vertices.fan_vertices.size()), 0, 0,
                                     result_.weights.size(), static_cast<float>(beta),
                                     static_cast<float>(1 / (3 / (8 * beta) + valence))});
    add_closed_tangents(valence);
  }
  ++result_.vertices.fans.back().count;
  result_.vertices.fan_vertices.push_back(vertex);
}

// The tangents of the smooth rule are the first Fourier mode of the ring.
void StencilBuilder::add_closed_tangents(std::uint32_t valence) {
  for (std::uint32_t i = 0; i < valence; ++i) {
    const double angle = 2 * std::numbers::pi * i / valence;
    result_.weights.push_back({static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))});
  }
}

void StencilBuilder::add_ring(const Sector& sector, std::uint32_t count) {
  const auto ring = topology_.rings.begin() + sector.first;
  result_.rings.insert(result_.rings.end(), ring, ring + count);
}

void StencilBuilder::add_open_sectors() {
  for (std::uint32_t v = 0; v < topology_.vertex_count; ++v) {
    if (topology_.rules[v] == Rule::corner) result_.vertices.corners.push_back(v);
    if (topology_.rules[v] != Rule::crease) continue;
    result_.vertices.creases.push_back({v, topology_.crease_neighbours[v][0], topology_.crease_neighbours[v][1]});
  }
  for (std::uint32_t s = 0; s < topology_.sectors.size(); ++s) {
    const Sector& sector = topology_.sectors[s];
    if (sector.closed) continue;
    const bool corner = topology_.rules[sector.vertex] == Rule::corner;
    result_.vertices.open_sectors.push_back(
        {s, sector.vertex, sector.count, result_.rings.size(), result_.weights.size(), corner, false});
    const auto ring = topology_.rings.begin() + sector.first;
    result_.rings.insert(result_.rings.end(), ring, ring + sector.count);
    const TangentMask mask = tangent_mask(sector.count, corner);
    for (std::uint32_t i = 0; i < sector.count; ++i)
      result_.weights.push_back({static_cast<float>(mask.along(i)), static_cast<float>(mask.inwards(i))});
  }
}

void StencilBuilder::add_edges() {
  normal_of_.assign(topology_.triangles.size(), none);
  auto extra_normal = static_cast<std::uint32_t>(result_.counts.normals);
  for (std::uint32_t e = 0; e < topology_.edges.size(); ++e) {
    if (topology_.edges[e].smooth) {
      add_smooth_edge(e);
    } else {
      add_sharp_edge(e, extra_normal);
    }
  }
  result_.counts.normals = extra_normal;
}

void StencilBuilder::add_smooth_edge(std::uint32_t e) {
  const std::uint32_t left = topology_.sides[topology_.edges[e].first_side];
  const std::uint32_t right = topology_.sides[topology_.edges[e].first_side + 1];
  const std::uint32_t a = topology_.corner(left), b = topology_.corner(right);
  SmoothEdge edge{a, b, topology_.opposite(left), topology_.opposite(right), {}, e};
  const std::array<std::uint32_t, 4> around = {Topology::before(left), Topology::after(left), Topology::after(right),
                                               Topology::before(right)};
  MiddleWeights weights{};
  bool regular = true;
  for (std::size_t i = 0; i < 4; ++i) {
    const Across found = across(topology_, around[i]);
    edge.across[i] = found.vertex;
    weights.ends[i] = found.smooth ? smooth_end : sharp_end;
    weights.opposites[i] = found.smooth ? smooth_opposite : sharp_opposite;
    regular = regular && found.smooth;
  }
  (regular ? result_.edges.regular : result_.edges.general).push_back(edge);
  if (!regular) result_.edges.middle_weights.push_back(weights);
  normal_of_[left] = normal_of_[right] = static_cast<std::uint32_t>(result_.counts.sectors) + e;
}

void StencilBuilder::add_sharp_edge(std::uint32_t e, std::uint32_t& extra_normal) {
  const Edge& edge = topology_.edges[e];
  result_.edges.sharp.push_back({edge.ends[0], edge.ends[1], e});
  for (std::uint32_t i = 0; i < edge.side_count; ++i) {
    const std::uint32_t half_edge = topology_.sides[edge.first_side + i];
    const std::uint32_t after = Topology::after(half_edge), before = Topology::before(half_edge);
    const Across beyond_a = across(topology_, before), beyond_b = across(topology_, after);
    const auto normal = i == 0 ? static_cast<std::uint32_t>(result_.counts.sectors) + e : extra_normal++;
    normal_of_[half_edge] = normal;
    result_.edges.sharp_sides.push_back(
        {topology_.corner(half_edge),
         topology_.corner(after),
         topology_.corner(before),
         {beyond_a.vertex, beyond_b.vertex},
         {beyond_a.smooth ? smooth_end : sharp_end, beyond_b.smooth ? smooth_end : sharp_end},
         {beyond_a.smooth ? smooth_opposite : sharp_opposite, beyond_b.smooth ? smooth_opposite : sharp_opposite},
         normal});
  }
}

void StencilBuilder::add_patches() {
  result_.no_normal = result_.counts.normals++;
  result_.patches.resize(topology_.same_as.size());
  for (std::uint32_t t = 0; t < topology_.same_as.size(); ++t) {
    Patch& patch = result_.patches[t];
    if (topology_.same_as[t] == none) {
      patch.positions.fill(topology_.triangles[3 * std::size_t{t}]);
      patch.normals.fill(static_cast<std::uint32_t>(result_.no_normal));
    } else if (topology_.same_as[t] != t) {
      patch = copied_patch(t);
    } else {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const std::uint32_t h = 3 * t + i;
        patch.positions[i] = topology_.corner(h);
        patch.positions[3 + i] = topology_.vertex_count + topology_.edge_of[h];
        patch.normals[i] = topology_.sector_of[h];
        patch.normals[3 + i] = normal_of_[h];
      }
    }
  }
}

// Returns the patch of the original triangle, with its points in the order of the copy.
Patch StencilBuilder::copied_patch(std::uint32_t triangle) {
  const Patch& source = result_.patches[topology_.same_as[triangle]];
  const std::uint32_t* const vertices = &topology_.triangles[3 * std::size_t{triangle}];
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
      result_.reversed.push_back({normal, static_cast<std::uint32_t>(result_.counts.normals)});
      normal = static_cast<std::uint32_t>(result_.counts.normals++);
    }
  }
  return patch;
}

Stencils make_stencils(const Topology& topology) { return StencilBuilder(topology).build(); }

}  // namespace glark::qas
