// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Based on: J. Canny, A Computational Approach to Edge Detection, 1986, section 5: strong edges, and weak ones that
// continue them.
#include "glark/clients/maps/charts/hard_edges.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glark::maps {
namespace {

constexpr float least_angle = 0.52F;  // 30 degrees

// The spreads of both triangles, as a part of the angle in which they meet. On a smooth surface, normals turn by this angle
// from the middle of one triangle to that of the other: so half of them differ from their triangle by a quarter of it or more,
// and the sum is a half or more.
constexpr float most_of_strong = 0.3F, most_of_weak = 0.6F;

class Finder {
 public:
  Finder(std::span<const float> spreads, Surface& surface) : spreads_(spreads), surface_(surface) {}

  void find() {
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k)
        if (part_of(t, k) <= most_of_strong) mark(t, k);
    while (!open_.empty()) {
      const std::uint32_t vertex = open_.back();
      open_.pop_back();
      continue_at(vertex);
    }
  }

 private:
  // The spreads as a part of the angle; infinite where the angle is small.
  float part_of(std::uint32_t t, std::size_t edge) const {
    const std::uint32_t other = surface_.neighbours[t][edge];
    if (other == none) return std::numeric_limits<float>::infinity();
    const float cosine = common::dot(surface_.triangle_normals[t], surface_.triangle_normals[other]);
    const float angle = std::acos(std::clamp(cosine, -1.0F, 1.0F));
    return angle >= least_angle ? (spreads_[t] + spreads_[other]) / angle : std::numeric_limits<float>::infinity();
  }

  void mark(std::uint32_t t, std::size_t edge) {
    if (surface_.hard[t][edge]) return;
    const std::uint32_t other = surface_.neighbours[t][edge];
    surface_.hard[t][edge] = true;
    for (std::size_t k = 0; k < 3; ++k)
      if (surface_.neighbours[other][k] == t) surface_.hard[other][k] = true;
    const auto& corners = surface_.triangles[t];
    open_.insert(open_.end(), {corners[edge], corners[(edge + 1) % 3]});
  }

  void continue_at(std::uint32_t vertex) {
    for (std::uint32_t i = surface_.first_of_vertex[vertex]; i < surface_.first_of_vertex[vertex + 1]; ++i) {
      const std::uint32_t t = surface_.of_vertex[i];
      for (std::size_t k = 0; k < 3; ++k) {
        const auto& corners = surface_.triangles[t];
        const bool is_here = corners[k] == vertex || corners[(k + 1) % 3] == vertex;
        if (is_here && part_of(t, k) <= most_of_weak) mark(t, k);
      }
    }
  }

  std::span<const float> spreads_;
  Surface& surface_;
  std::vector<std::uint32_t> open_;  // ends of hard edges, which weak ones may continue
};

}  // namespace

void find_hard_edges(std::span<const float> spreads, Surface& surface) {
  surface.hard.assign(surface.triangles.size(), {});
  Finder(spreads, surface).find();
  if (count_hard_edges(surface) == 0) surface.hard.clear();
}

void set_soft(std::uint32_t triangle, std::size_t edge, Surface& surface) {
  const std::uint32_t other = surface.neighbours[triangle][edge];
  surface.hard[triangle][edge] = false;
  for (std::size_t k = 0; k < 3; ++k)
    if (surface.neighbours[other][k] == triangle) surface.hard[other][k] = false;
}

std::size_t count_hard_edges(const Surface& surface) {
  std::size_t sides = 0;
  for (const auto& edges : surface.hard)
    sides += static_cast<std::size_t>(std::count(edges.begin(), edges.end(), true));
  return sides / 2;
}

}  // namespace glark::maps
