// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Which refinement pattern a coarse triangle gets, and a colour for each pattern. The viewer computes the depths that the
// extension measures (GL_EDGE_PIXELS_ARK) a second time, because OpenGL does not tell them.
#pragma once

#include <glark/surfel.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "glark/tool/view/draw/draw_settings.h"

namespace glark::tool {

// The depths of a triangle's three edges, deepest first. The order of the edges does not change the pattern's triangles.
using Pattern = std::array<int, 3>;

// How often each pattern is drawn.
using PatternCounts = std::map<Pattern, std::size_t>;

// Triangles with corners of their own, for glDrawArrays. Normals may be empty.
struct ColouredTriangles {
  std::vector<float> positions;  // x y z of each corner
  std::vector<float> normals;
  std::vector<std::uint8_t> colours;  // red green blue alpha of each corner
  PatternCounts counts;
};

// "2 1 1": the depths.
std::string name_of(const Pattern& pattern);

// Blue for one triangle, then green and yellow, to red for the deepest pattern; darker if the depths differ.
std::array<std::uint8_t, 3> colour_of(const Pattern& pattern);

// Edge depths in a picture of width x height pixels.
class EdgeDepths {
 public:
  // Without settings.edge_pixels, all edges have the depth settings.level.
  EdgeDepths(const glm::mat4& clip_from_object, const DrawSettings& settings, int width, int height);

  // Returns the depth of the edge between two positions, in either order.
  int of(const glm::vec3& from, const glm::vec3& to) const;

 private:
  glm::mat4 clip_from_object_;
  glm::vec2 half_size_;
  float edge_pixels_;
  int level_;
};

// `triangles` are three indices each into positions and normals.
ColouredTriangles colour_by_pattern(std::span<const float> positions, std::span<const float> normals,
                                    std::span<const std::uint32_t> triangles, const EdgeDepths& depths);

// The triangles of the strips that a frame draws, three indices each, without those of no area. `indices` are those of
// surfel::Strips.
std::vector<std::uint32_t> triangles_of_strips(std::span<const std::uint32_t> indices, const surfel::Frame& frame);

}  // namespace glark::tool
