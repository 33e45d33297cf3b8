// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Applies the stencils. All sums are sums of differences to a near vertex, which single precision holds almost exactly.
// So normals are as exact in a mesh of many small triangles as in a coarse one.
#include <algorithm>

#include "glark/clients/qas/limit_step/limit_step.h"

namespace glark::qas {
namespace {

// Returns the mean normal of the triangles of a ring, for vertices without a tangent plane.
Float4 ring_normal(const Float4* from, Float4 vertex, const std::uint32_t* ring, std::uint32_t count, bool closed) {
  Float4 sum{};
  for (std::uint32_t i = 0; i + (closed ? 0 : 1) < count; ++i)
    sum += cross(from[ring[i]] - vertex, from[ring[(i + 1) % count]] - vertex);
  return unit_or_z(sum);
}

Float4 position(Float4 scaled, float unscale) { return scaled * unscale + Float4{0, 0, 0, 1}; }

}  // namespace

template <bool With_limits>
void LimitStep::run_fan(const Frame& frame, const Fan& fan, std::size_t begin, std::size_t end) const {
  const TangentWeights* const weights = &stencils_.weights[fan.first_weight];
  for (std::size_t i = begin; i < end; ++i) {
    const FanVertex which = stencils_.vertices.fan_vertices[i];
    const std::uint32_t* const ring = &stencils_.rings[fan.first_ring + (i - fan.first) * fan.valence];
    const Float4 vertex = frame.from[which.vertex];
    Float4 sum{}, first{}, second{};
    for (std::uint32_t j = 0; j < fan.valence; ++j) {
      const Float4 spoke = frame.from[ring[j]] - vertex;
      sum += spoke;
      first += weights[j].first * spoke;
      second += weights[j].second * spoke;
    }
    if constexpr (With_limits) {
      frame.shift[which.vertex] = fan.shift * sum;
      store(frame.positions[which.vertex], position(vertex + fan.limit * sum, frame.unscale));
      Float4 normal;
      if (!unit_normal(first, second, normal)) normal = ring_normal(frame.from, vertex, ring, fan.valence, true);
      store(frame.normals[which.sector], normal);
    } else {
      frame.shift[which.vertex] = vertex + fan.shift * sum;
    }
  }
}

// Handles vertices of valence 6. After a step, nearly all vertices have this valence. The Fourier mode of the ring
// needs no table of weights.
template <bool With_limits>
void LimitStep::run_regular_fan(const Frame& frame, const Fan& fan, std::size_t begin, std::size_t end) const {
  for (std::size_t i = begin; i < end; ++i) {
    const FanVertex which = stencils_.vertices.fan_vertices[i];
    const std::uint32_t* const ring = &stencils_.rings[fan.first_ring + (i - fan.first) * 6];
    const Float4 vertex = frame.from[which.vertex];
    const Float4 r0 = frame.from[ring[0]], r1 = frame.from[ring[1]], r2 = frame.from[ring[2]];
    const Float4 r3 = frame.from[ring[3]], r4 = frame.from[ring[4]], r5 = frame.from[ring[5]];
    const Float4 sum =
        ((r0 - vertex) + (r3 - vertex)) + (((r1 - vertex) + (r4 - vertex)) + ((r2 - vertex) + (r5 - vertex)));
    if constexpr (With_limits) {
      frame.shift[which.vertex] = fan.shift * sum;
      store(frame.positions[which.vertex], position(vertex + fan.limit * sum, frame.unscale));
      const Float4 first = (r0 - r3) + 0.5F * ((r1 - r2) + (r5 - r4));
      const Float4 second = (r1 - r4) + (r2 - r5);
      Float4 normal;
      if (!unit_normal(first, second, normal)) normal = ring_normal(frame.from, vertex, ring, 6, true);
      store(frame.normals[which.sector], normal);
    } else {
      frame.shift[which.vertex] = vertex + fan.shift * sum;
    }
  }
}

template <bool With_limits>
void LimitStep::run_fans(const Frame& frame, std::size_t begin, std::size_t end) const {
  for (const Fan& fan : stencils_.vertices.fans) {
    const std::size_t from = std::max<std::size_t>(begin, fan.first);
    const std::size_t to = std::min<std::size_t>(end, std::size_t{fan.first} + fan.count);
    if (from >= to) continue;
    if (fan.valence == 6) {
      run_regular_fan<With_limits>(frame, fan, from, to);
    } else {
      run_fan<With_limits>(frame, fan, from, to);
    }
  }
}

template <bool With_limits>
void LimitStep::run_creases(const Frame& frame, std::size_t begin, std::size_t end) const {
  for (std::size_t i = begin; i < end; ++i) {
    const CreaseVertex& crease = stencils_.vertices.creases[i];
    const Float4 vertex = frame.from[crease.vertex];
    const Float4 sum = (frame.from[crease.before] - vertex) + (frame.from[crease.after] - vertex);
    if constexpr (With_limits) {
      frame.shift[crease.vertex] = sum * 0.125F;
      store(frame.positions[crease.vertex], position(vertex + sum / 6.0F, frame.unscale));
    } else {
      frame.shift[crease.vertex] = vertex + sum * 0.125F;
    }
  }
}

void LimitStep::run_open_sectors(const Frame& frame, std::size_t begin, std::size_t end) const {
  for (std::size_t i = begin; i < end; ++i) {
    const OpenSector& sector = stencils_.vertices.open_sectors[i];
    const std::uint32_t* const ring = &stencils_.rings[sector.first_ring];
    const TangentWeights* const weights = &stencils_.weights[sector.first_weight];
    const Float4 vertex = frame.from[sector.vertex];
    Float4 first{}, second{};
    for (std::uint32_t j = 0; j < sector.count; ++j) {
      const Float4 spoke = frame.from[ring[j]] - vertex;
      first += weights[j].first * spoke;
      second += weights[j].second * spoke;
    }
    Float4 normal;
    const bool found = unit_normal(first, second, normal);
    if (!found || sector.corner) {
      const Float4 coarse = ring_normal(frame.from, vertex, ring, sector.count, sector.closed);
      // A corner of three or more triangles may have no tangent plane. At a reflex corner, the two edges give the
      // opposite normal.
      if (!found || sector.count > 3 || dot(normal, coarse) <= 0) normal = coarse;
    }
    store(frame.normals[sector.sector], normal);
  }
}

void LimitStep::finish_edge(const Frame& frame, const SmoothEdge& edge, Float4 limit, Float4 along,
                            Float4 across) const {
  store(frame.positions[stencils_.counts.vertices + edge.edge], position(limit, frame.unscale));
  Float4 normal;
  if (!unit_normal(along, across, normal)) {
    const Float4 a = frame.from[edge.a], b = frame.from[edge.b] - a;
    normal = unit_or_z(cross(b, frame.from[edge.c] - a) + cross(frame.from[edge.d] - a, b));
  }
  store(frame.normals[stencils_.counts.sectors + edge.edge], normal);
}

// The weights combine the step with the limit mask over the six neighbours that the middle has after the step.
void LimitStep::run_regular_edges(const Frame& frame, std::size_t begin, std::size_t end) const {
  for (std::size_t i = begin; i < end; ++i) {
    const SmoothEdge& edge = stencils_.edges.regular[i];
    const Float4 a = frame.from[edge.a], b = frame.from[edge.b], c = frame.from[edge.c], d = frame.from[edge.d];
    const Float4 ac = frame.from[edge.across[0]], bc = frame.from[edge.across[1]];
    const Float4 ad = frame.from[edge.across[2]], bd = frame.from[edge.across[3]];
    const Float4 shift_a = frame.shift[edge.a], shift_b = frame.shift[edge.b];
    const Float4 offset = (b - a) * (17.0F / 48) + ((c - a) + (d - a)) * 0.125F +
                          (((ac - a) + (bc - a)) + ((ad - a) + (bd - a))) * (1.0F / 96) +
                          (shift_a + shift_b) * (1.0F / 12);
    const Float4 along = (b - a) * 1.25F + (shift_b - shift_a) + ((bc - ac) + (bd - ad)) * 0.0625F;
    const Float4 across = (c - d) * 0.75F + ((ac - ad) + (bc - bd)) * 0.125F;
    finish_edge(frame, edge, a + offset, along, across);
  }
}

void LimitStep::run_general_edges(const Frame& frame, std::size_t begin, std::size_t end) const {
  for (std::size_t i = begin; i < end; ++i) {
    const SmoothEdge& edge = stencils_.edges.general[i];
    const MiddleWeights& weights = stencils_.edges.middle_weights[i];
    const Float4 a = frame.from[edge.a];
    const Float4 b = frame.from[edge.b] - a, c = frame.from[edge.c] - a, d = frame.from[edge.d] - a;
    // The six neighbours of the edge's middle after one step, and the middle itself, relative to a.
    const Float4 ac = weights.ends[0] * c + weights.opposites[0] * (b + (frame.from[edge.across[0]] - a));
    const Float4 bc = weights.ends[1] * (b + c) + weights.opposites[1] * (frame.from[edge.across[1]] - a);
    const Float4 ad = weights.ends[2] * d + weights.opposites[2] * (b + (frame.from[edge.across[2]] - a));
    const Float4 bd = weights.ends[3] * (b + d) + weights.opposites[3] * (frame.from[edge.across[3]] - a);
    const Float4 next_a = frame.shift[edge.a], next_b = b + frame.shift[edge.b];
    const Float4 middle = smooth_end * b + smooth_opposite * (c + d);
    const Float4 sum = (next_a + next_b) + ((ac + bc) + (ad + bd));
    const Float4 along = (next_b - next_a) + 0.5F * ((bc - ac) + (bd - ad));
    finish_edge(frame, edge, a + (0.5F * middle + sum * (1.0F / 12)), along, (ac + bc) - (ad + bd));
  }
}

void LimitStep::run_sharp_edges(const Frame& frame, std::size_t begin, std::size_t end) const {
  for (std::size_t i = begin; i < end; ++i) {
    const SharpEdge& edge = stencils_.edges.sharp[i];
    const Float4 a = frame.from[edge.a], b = frame.from[edge.b];
    const Float4 ends = (a + frame.shift[edge.a]) + (b + frame.shift[edge.b]);
    store(frame.positions[stencils_.counts.vertices + edge.edge],
          position((a + b) / 3.0F + ends / 6.0F, frame.unscale));
  }
}

void LimitStep::run_sharp_sides(const Frame& frame, std::size_t begin, std::size_t end) const {
  for (std::size_t i = begin; i < end; ++i) {
    const SharpSide& side = stencils_.edges.sharp_sides[i];
    const Float4 a = frame.from[side.a];
    const Float4 b = frame.from[side.b] - a, c = frame.from[side.c] - a;
    const Float4 ac = side.ends[0] * c + side.opposites[0] * (b + (frame.from[side.across[0]] - a));
    const Float4 bc = side.ends[1] * (b + c) + side.opposites[1] * (frame.from[side.across[1]] - a);
    const Float4 next_a = frame.shift[side.a], next_b = b + frame.shift[side.b];
    const Float4 inwards = (ac + bc) - 0.5F * (b + (next_a + next_b));
    Float4 normal;
    if (!unit_normal(next_b - next_a, inwards, normal)) normal = unit_or_z(cross(b, c));
    store(frame.normals[side.normal], normal);
  }
}

void LimitStep::run(const Workers& workers, const Frame& frame) const {
  workers.evenly(stencils_.vertices.fan_vertices.size(),
                 [&](auto begin, auto end) { run_fans<true>(frame, begin, end); });
  workers.evenly(stencils_.vertices.creases.size(),
                 [&](auto begin, auto end) { run_creases<true>(frame, begin, end); });
  workers.evenly(stencils_.vertices.open_sectors.size(),
                 [&](auto begin, auto end) { run_open_sectors(frame, begin, end); });
  for (const std::uint32_t vertex : stencils_.vertices.corners) {
    frame.shift[vertex] = Float4{};
    store(frame.positions[vertex], position(frame.from[vertex], frame.unscale));
  }
  workers.evenly(stencils_.edges.regular.size(), [&](auto begin, auto end) { run_regular_edges(frame, begin, end); });
  workers.evenly(stencils_.edges.general.size(), [&](auto begin, auto end) { run_general_edges(frame, begin, end); });
  workers.evenly(stencils_.edges.sharp.size(), [&](auto begin, auto end) { run_sharp_edges(frame, begin, end); });
  workers.evenly(stencils_.edges.sharp_sides.size(), [&](auto begin, auto end) { run_sharp_sides(frame, begin, end); });
  finish(frame);
}

void LimitStep::finish(const Frame& frame) const {
  for (const Reversed& pair : stencils_.reversed) store(frame.normals[pair.to], -load(frame.normals[pair.from]));
  frame.normals[stencils_.no_normal] = {0, 0, 1, 0};
}

void LimitStep::subdivide(const Workers& workers, const Float4* from, Float4* to) const {
  const Frame frame{from, to, nullptr, nullptr, 1};
  workers.evenly(stencils_.vertices.fan_vertices.size(),
                 [&](auto begin, auto end) { run_fans<false>(frame, begin, end); });
  workers.evenly(stencils_.vertices.creases.size(),
                 [&](auto begin, auto end) { run_creases<false>(frame, begin, end); });
  for (const std::uint32_t vertex : stencils_.vertices.corners) to[vertex] = from[vertex];
  Float4* const middles = to + stencils_.counts.vertices;
  const auto smooth = [&](const std::vector<SmoothEdge>& edges) {
    workers.evenly(edges.size(), [&](auto begin, auto end) {
      for (auto i = begin; i < end; ++i) {
        const SmoothEdge& edge = edges[i];
        middles[edge.edge] =
            smooth_end * (from[edge.a] + from[edge.b]) + smooth_opposite * (from[edge.c] + from[edge.d]);
      }
    });
  };
  smooth(stencils_.edges.regular);
  smooth(stencils_.edges.general);
  for (const SharpEdge& edge : stencils_.edges.sharp) middles[edge.edge] = 0.5F * (from[edge.a] + from[edge.b]);
}

}  // namespace glark::qas
