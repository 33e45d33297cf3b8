// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// From each triangle that is left, a strip begins in the one of three directions that reaches the most triangles.
#include "glark/clients/maps/output/triangle_strips.h"

#include <unordered_map>
#include <utility>

namespace glark::maps {
namespace {

class StripBuilder {
 public:
  explicit StripBuilder(std::span<const std::uint32_t> triangles)
      : triangles_(triangles), is_used_(triangles.size() / 3), seen_(triangles.size() / 3) {
    corner_of_.reserve(triangles.size());
    for (std::uint32_t corner = 0; corner < triangles.size(); ++corner)
      corner_of_.emplace(edge(triangles[corner], triangles[next(corner)]), corner);
  }

  TriangleStrips build() {
    TriangleStrips strips;
    for (std::uint32_t t = 0; t < is_used_.size(); ++t) {
      if (is_used_[t] || is_degenerate(t)) continue;
      Strip longest;
      for (std::uint32_t k = 0; k < 3; ++k)
        if (Strip strip = strip_from(3 * t + k); strip.vertices.size() > longest.vertices.size())
          longest = std::move(strip);
      strips.sizes.push_back(static_cast<std::uint32_t>(longest.vertices.size()));
      strips.vertices.insert(strips.vertices.end(), longest.vertices.begin(), longest.vertices.end());
      for (const std::uint32_t triangle : longest.triangles) is_used_[triangle] = true;
    }
    return strips;
  }

 private:
  struct Strip {
    std::vector<std::uint32_t> vertices, triangles;
  };

  static std::uint32_t next(std::uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
  static std::uint64_t edge(std::uint32_t from, std::uint32_t to) { return (std::uint64_t{from} << 32U) | to; }

  bool is_degenerate(std::uint32_t t) const {
    const auto corners = triangles_.subspan(3 * std::size_t{t}, 3);
    return corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];
  }

  // The corner where a triangle with this directed edge has its first end, or none.
  std::uint32_t corner_at(std::uint32_t from, std::uint32_t to) const {
    const auto found = corner_of_.find(edge(from, to));
    return found == corner_of_.end() || is_degenerate(found->second / 3) ? none : found->second;
  }

  // Triangle i of a strip is its vertices i, i + 1, i + 2; every second one is turned.
  Strip strip_from(std::uint32_t corner) {
    ++round_;
    Strip strip;
    std::vector<std::uint32_t>& vertices = strip.vertices;
    vertices = {triangles_[corner], triangles_[next(corner)]};
    while (corner != none && !is_used_[corner / 3] && seen_[corner / 3] != round_) {
      seen_[corner / 3] = round_;
      strip.triangles.push_back(corner / 3);
      vertices.push_back(triangles_[next(next(corner))]);
      const std::uint32_t a = vertices[vertices.size() - 2], b = vertices.back();
      corner = vertices.size() % 2 == 0 ? corner_at(a, b) : corner_at(b, a);
    }
    return strip;
  }

  static constexpr std::uint32_t none = 0xFFFFFFFF;

  std::span<const std::uint32_t> triangles_;
  std::unordered_map<std::uint64_t, std::uint32_t> corner_of_;  // the first corner of each directed edge
  std::vector<bool> is_used_;
  std::vector<std::uint32_t> seen_;  // the last round that had each triangle
  std::uint32_t round_ = 0;
};

}  // namespace

TriangleStrips strips_of(std::span<const std::uint32_t> triangles) { return StripBuilder(triangles).build(); }

}  // namespace glark::maps
