// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/project/shell.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace glark::maps {
namespace {

constexpr double most_cells = 1 << 22;
constexpr double cells_for_edge = 1.5;  // cells in the length of a mean edge

// A foot that lies beyond an edge by less than this weight counts, because neighbours may both miss it by rounding. The
// foot is moved onto the triangle.
constexpr float rounding = 1e-3F;
// Near a boundary or a fold, no triangle has the foot. Then the triangle counts that misses it by the least weight, up to
// this one.
constexpr float most_beyond = 0.15F;

// At a crease, two triangles have feet of the same height: to this part of the reach. Their normals differ from that of the point
// by angles whose cosines differ by more than this.
constexpr float equal_heights = 1e-4F, other_cosine = 0.1F;

constexpr float least_rise = 0.05F;  // of a normal over the triangle's plane; others have no foot there

// The greatest change of a weight along a normal, for each unit of height.
float slope_of(const std::array<Vector, 3>& n) {
  float slope = 0;
  for (const Vector& corner : n) {
    const float rise = std::max(corner.z, least_rise);
    slope = std::max(slope, std::max({std::abs(corner.x), std::abs(corner.y), std::abs(corner.x + corner.y)}) / rise);
  }
  return slope;
}

Vector mix(const std::array<Vector, 3>& n, const Weights& w) { return n[0] * w[0] + n[1] * w[1] + n[2] * w[2]; }

}  // namespace

Shell::Shell(const Surface& surface, double reach) : surface_(surface), reach_(static_cast<float>(reach)) {
  prisms_.reserve(surface.triangles.size());
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) add_prism(t);
  fill_cells();
}

void Shell::add_prism(std::uint32_t triangle) {
  const auto& corners = surface_.triangles[triangle];
  Prism prism;
  prism.corner = surface_.positions[corners[0]];
  prism.plane = surface_.triangle_normals[triangle];
  const Vector first = surface_.positions[corners[1]] - prism.corner;
  const Vector second = surface_.positions[corners[2]] - prism.corner;
  const Vector normal = common::cross(first, second);
  const float squared = common::dot(normal, normal);
  if (squared > 0) {
    prism.to_first = common::cross(second, normal) * (1 / squared);
    prism.to_second = common::cross(normal, first) * (1 / squared);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector& n = surface_.normals[corners[k]];
    prism.n[k] = {common::dot(prism.to_first, n), common::dot(prism.to_second, n), common::dot(prism.plane, n)};
  }
  prism.slope = slope_of(prism.n);
  prisms_.push_back(prism);
}

void Shell::fill_cells() {
  Vector high = surface_.positions.front();
  low_ = high;
  for (const Vector& p : surface_.positions) {
    low_ = common::least(low_, p);
    high = common::greatest(high, p);
  }
  const Vector border{reach_, reach_, reach_};
  low_ = low_ - border;
  const Vector size = high + border - low_;
  double side = surface_.mean_edge / cells_for_edge;
  const auto cells_along = [&](float length) { return std::floor(static_cast<double>(length) / side) + 1; };
  while (cells_along(size.x) * cells_along(size.y) * cells_along(size.z) > most_cells) side *= 1.25;
  cells_for_unit_ = static_cast<float>(1 / side);
  for (std::size_t axis = 0; axis < 3; ++axis) cells_[axis] = static_cast<std::uint32_t>(cells_along(size[axis])) + 1;

  const auto visit = [&](const auto& add) {
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t) {
      if (common::is_zero(surface_.triangle_normals[t])) continue;
      Vector from = surface_.positions[surface_.triangles[t][0]];
      Vector to = from;
      for (const std::uint32_t vertex : surface_.triangles[t]) {
        for (const float height : {-reach_, reach_}) {
          const Vector p = surface_.positions[vertex] + surface_.normals[vertex] * height;
          from = common::least(from, p);
          to = common::greatest(to, p);
        }
      }
      std::array<std::uint32_t, 3> first{}, last{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto cell = [&](float x) {
          const float at = std::floor((x - low_[axis]) * cells_for_unit_);
          return static_cast<std::uint32_t>(std::clamp(at, 0.0F, static_cast<float>(cells_[axis] - 1)));
        };
        first[axis] = cell(from[axis]);
        last[axis] = cell(to[axis]);
      }
      for (std::uint32_t z = first[2]; z <= last[2]; ++z)
        for (std::uint32_t y = first[1]; y <= last[1]; ++y)
          for (std::uint32_t x = first[0]; x <= last[0]; ++x) add((std::size_t{z} * cells_[1] + y) * cells_[0] + x, t);
    }
  };
  first_.assign(std::size_t{cells_[0]} * cells_[1] * cells_[2] + 1, 0);
  visit([&](std::size_t cell, std::uint32_t) { ++first_[cell + 1]; });
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  triangles_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  visit([&](std::size_t cell, std::uint32_t t) { triangles_[next[cell]++] = t; });
}

std::size_t Shell::cell_of(Vector position) const {
  std::array<std::uint32_t, 3> cell{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float at = (position[axis] - low_[axis]) * cells_for_unit_;
    if (!(at >= 0 && at < static_cast<float>(cells_[axis]))) return first_.size();
    cell[axis] = static_cast<std::uint32_t>(at);
  }
  return (std::size_t{cell[2]} * cells_[1] + cell[1]) * cells_[0] + cell[0];
}

// The foot solves foot + t * normal(foot) = position. Each step takes the normal at the foot before.
bool Shell::find(const Prism& prism, const OverPlane& over, Foot& foot) {
  constexpr int steps = 3;
  Weights w{1 - over.first - over.second, over.first, over.second};
  float t = 0;
  for (int step = 0; step < steps; ++step) {
    // Outside the triangle, normals are extrapolated and may lie in its plane.
    const Weights within{std::clamp(w[0], 0.0F, 1.0F), std::clamp(w[1], 0.0F, 1.0F), std::clamp(w[2], 0.0F, 1.0F)};
    const float sum = within[0] + within[1] + within[2];
    const Vector n = mix(prism.n, {within[0] / sum, within[1] / sum, within[2] / sum});
    if (n.z < least_rise) return false;
    t = over.height / n.z;
    w[1] = over.first - t * n.x;
    w[2] = over.second - t * n.y;
    w[0] = 1 - w[1] - w[2];
  }
  foot.weights = w;
  foot.height = t;
  return true;
}

std::optional<Foot> Shell::foot_of(Vector position, Vector normal) const {
  const std::size_t cell = cell_of(position);
  if (cell + 1 >= first_.size()) return std::nullopt;
  Foot best, nearest;
  float best_height = reach_, best_cosine = -1;
  float least_beyond = most_beyond;
  for (std::uint32_t i = first_[cell]; i < first_[cell + 1]; ++i) {
    const std::uint32_t t = triangles_[i];
    const Prism& prism = prisms_[t];
    const float cosine = common::dot(normal, prism.plane);
    if (cosine < 0) continue;
    const Vector d = position - prism.corner;
    const OverPlane over{common::dot(prism.plane, d), common::dot(prism.to_first, d), common::dot(prism.to_second, d)};
    const float height = std::abs(over.height);
    const float least = std::min({over.first, over.second, 1 - over.first - over.second});
    if (height > reach_ || least < -most_beyond - height * prism.slope) continue;
    Foot foot;
    if (!find(prism, over, foot)) continue;
    foot.triangle = t;
    const float beyond = -std::min({foot.weights[0], foot.weights[1], foot.weights[2]});
    const float higher = std::abs(foot.height) - best_height;
    const bool is_at_crease = best.triangle != none && std::abs(higher) <= equal_heights * reach_ &&
                              std::abs(cosine - best_cosine) > other_cosine;
    if (beyond <= rounding && (is_at_crease ? cosine > best_cosine : higher <= 0)) {
      best_height = std::abs(foot.height);
      best_cosine = cosine;
      best = foot;
    } else if (beyond < least_beyond && std::abs(foot.height) <= reach_) {
      least_beyond = beyond;
      nearest = foot;
    }
  }
  if (best.triangle == none) best = nearest;
  if (best.triangle == none) return std::nullopt;
  float sum = 0;
  for (float& w : best.weights) {
    w = std::max(w, 0.0F);
    sum += w;
  }
  for (float& w : best.weights) w /= sum;
  const auto& corners = surface_.triangles[best.triangle];
  const Vector n =
      mix({surface_.normals[corners[0]], surface_.normals[corners[1]], surface_.normals[corners[2]]}, best.weights);
  best.height *= common::length(n);
  return best;
}

}  // namespace glark::maps
