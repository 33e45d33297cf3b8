// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// In which circumstances a change is tested: the draw, how its depths are chosen, how often it was drawn before, and so
// on. Most faults need only two circumstances at once (a command and a kind of draw, for example). So the combinations
// are a covering array of strength 2: each change meets each value of each circumstance, and over all changes each two
// values meet. What is kept for longest takes three: each change meets each kind of draw there as well.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace glark::conformance {

enum class Depths { uniform, tags, measured };
inline constexpr std::array<const char*, 3> depths_names = {"a uniform depth", "depth tags", "measured depths"};

// How often the draw was refined before the change: an implementation may keep more the more often a draw repeats.
inline constexpr std::array<int, 4> histories = {0, 1, 3, 24};

// The triangles of the mesh.
inline constexpr std::array<int, 2> sizes = {4, 192};

struct Combination {
  std::size_t path = 0;        // the kind of draw, see paths.h
  std::size_t refinement = 0;  // of `refinements`, see changed_draw.h
  Depths depths = Depths::uniform;
  int history = 0;
  int triangles = 4;
};

inline constexpr std::size_t refinement_count = 3;

// How a picture is compared with the right one: so many pixels may differ by more than `most_difference`, at the edges of
// triangles.
inline constexpr int most_difference = 4;
inline constexpr int most_edge_pixels = 80;

// Turns the refinement on, with the depths of the combination.
void set_refinement(const Combination& one);
// "DrawArrays of 4 triangles, linear inputs, depth tags"
std::string text_of(const Combination& one);

// The combinations of a change. Changes are numbered from 0; each gets two combinations for each path.
std::vector<Combination> combinations_of(std::size_t change, std::size_t paths);

}  // namespace glark::conformance
