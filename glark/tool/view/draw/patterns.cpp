// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/view/draw/patterns.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vec4.hpp>
#include <utility>

#include "glark/tool/view/draw/shading.h"

namespace glark::tool {

std::string name_of(const Pattern& pattern) { return fmt::format("{}", fmt::join(pattern, " ")); }

std::array<std::uint8_t, 3> colour_of(const Pattern& pattern) {
  constexpr int deepest_sum = 3 * deepest_level;
  const float sum = static_cast<float>(pattern[0] + pattern[1] + pattern[2]);
  std::array<std::uint8_t, 3> colour = colour_between_blue_and_red(sum / deepest_sum);
  if (pattern[0] != pattern[2])
    for (std::uint8_t& channel : colour) channel = static_cast<std::uint8_t>(channel * 7 / 10);
  return colour;
}

EdgeDepths::EdgeDepths(const glm::mat4& clip_from_object, const DrawSettings& settings, int width, int height)
    : clip_from_object_(clip_from_object),
      half_size_(static_cast<float>(width) / 2, static_cast<float>(height) / 2),
      edge_pixels_(static_cast<float>(settings.edge_pixels)),
      level_(std::clamp(settings.level, 0, deepest_level)) {}

int EdgeDepths::of(const glm::vec3& from, const glm::vec3& to) const {
  if (!(edge_pixels_ > 0)) return level_;
  const glm::vec4 a = clip_from_object_ * glm::vec4(from, 1);
  const glm::vec4 b = clip_from_object_ * glm::vec4(to, 1);
  if (!(a.w > 0) || !(b.w > 0)) return deepest_level;  // it has no length on the screen
  const float length = glm::length((glm::vec2(a) / a.w - glm::vec2(b) / b.w) * half_size_);
  int depth = 0;
  for (float covered = edge_pixels_; depth < deepest_level && length > covered; covered *= 2) ++depth;
  return depth;
}

ColouredTriangles colour_by_pattern(std::span<const float> positions, std::span<const float> normals,
                                    std::span<const std::uint32_t> triangles, const EdgeDepths& depths) {
  ColouredTriangles coloured;
  coloured.positions.reserve(3 * triangles.size());
  coloured.normals.reserve(normals.empty() ? 0 : 3 * triangles.size());
  coloured.colours.reserve(4 * triangles.size());
  for (std::size_t first = 0; first + 2 < triangles.size(); first += 3) {
    const std::span<const std::uint32_t> corners = triangles.subspan(first, 3);
    const auto position = [&](std::size_t corner) {
      return glm::make_vec3(&positions[3 * std::size_t{corners[corner]}]);
    };
    Pattern pattern{depths.of(position(0), position(1)), depths.of(position(1), position(2)),
                    depths.of(position(2), position(0))};
    std::sort(pattern.begin(), pattern.end(), std::greater<>());
    ++coloured.counts[pattern];
    const std::array<std::uint8_t, 3> colour = colour_of(pattern);
    for (const std::size_t corner : corners) {
      coloured.positions.insert(coloured.positions.end(), &positions[3 * corner], &positions[3 * corner] + 3);
      if (!normals.empty())
        coloured.normals.insert(coloured.normals.end(), &normals[3 * corner], &normals[3 * corner] + 3);
      coloured.colours.insert(coloured.colours.end(), {colour[0], colour[1], colour[2], 255});
    }
  }
  return coloured;
}

std::vector<std::uint32_t> triangles_of_strips(std::span<const std::uint32_t> indices, const surfel::Frame& frame) {
  std::vector<std::uint32_t> triangles;
  triangles.reserve(3 * frame.indices);
  for (std::size_t strip = 0; strip < frame.counts.size(); ++strip) {
    const std::size_t first = std::bit_cast<std::size_t>(frame.offsets[strip]) / sizeof(std::uint32_t);
    for (std::size_t i = 0; i + 2 < static_cast<std::size_t>(frame.counts[strip]); ++i) {
      std::array<std::uint32_t, 3> corners{indices[first + i], indices[first + i + 1], indices[first + i + 2]};
      if (i % 2 == 1) std::swap(corners[0], corners[1]);  // every second triangle of a strip turns the other way
      if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
      triangles.insert(triangles.end(), corners.begin(), corners.end());
    }
  }
  return triangles;
}

}  // namespace glark::tool
