// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The triangles of a patch as runs: sequences in which each triangle has an edge in common with the next.
// Based on: Stewart, Tunneling for Triangle Strips, 2001: a walk over the triangles, then edges that join two runs, or that join
// them in another way, as long as that has fewer indices.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace glark::surfel {

using StripTriangle = std::array<std::uint32_t, 3>;  // counter-clockwise

// Makes runs, one patch after the other, in memory that it keeps.
class Runs {
 public:
  static constexpr std::uint32_t none = 0xFFFFFFFFU;

  // All triangles, each in one run. The same for the same triangles.
  void make(std::span<const StripTriangle> triangles);

  std::size_t size() const { return crossed_.size(); }
  // Sides of a triangle that its run crosses, a bit for each; at most two.
  std::uint8_t crossed(std::uint32_t triangle) const { return crossed_[triangle]; }
  bool is_end(std::uint32_t triangle) const;
  // Triangles of the run that begins or ends there, from there on.
  void follow(std::uint32_t end, std::vector<std::uint32_t>& triangles) const;

 private:
  static std::uint32_t triangle_of(std::uint32_t link) { return link >> 2; }
  static std::uint32_t side_of(std::uint32_t link) { return link & 3; }

  void find_neighbours(std::span<const StripTriangle> triangles);
  void walk();
  void walk_from(std::uint32_t triangle);
  std::uint32_t next_start();
  void use(std::uint32_t triangle);
  void note_if_lonely(std::uint32_t triangle);
  // The triangle there; as many as there are where there is none.
  std::uint32_t beyond(std::uint32_t triangle, std::size_t side) const {
    return std::min(triangle_of(sides_[triangle][side]), static_cast<std::uint32_t>(size()));
  }
  void improve();
  void go_on(std::uint32_t end, std::uint32_t random);
  int cost_of(std::uint32_t end, std::uint32_t side, std::uint32_t left) const;
  static int turn_at(std::uint8_t crossed, std::uint32_t side, std::uint8_t crossed_there, std::uint32_t side_there);
  int turn_with(std::uint32_t triangle, std::uint32_t side, std::uint8_t crossed) const;
  int loosened(std::uint32_t triangle, std::uint32_t side) const;
  void join(std::uint32_t triangle, std::uint32_t side);
  void part(std::uint32_t triangle, std::uint32_t side);
  bool is_loop(std::uint32_t first, std::uint32_t next) const;

  std::vector<std::array<std::uint32_t, 3>>
      sides_;  // across the edge opposite to each corner: a triangle, and its side; one more than triangles
  std::vector<std::uint8_t> crossed_;
  std::vector<std::uint32_t> beside_;  // of its run's neighbours one more than their numbers, exclusively ored
  std::vector<std::uint64_t> edges_;   // where they run from and to, by their links
  std::vector<std::uint32_t> table_;   // links, by a hash of both ends
  std::vector<std::uint32_t> free_;    // neighbours that are not used; more than any number of these: it is used itself
  std::vector<std::uint32_t> lonely_;  // triangles that had few of these left
  std::size_t lonely_count_ = 0;
  std::vector<std::uint32_t> ends_;  // some of which are none any more
  std::uint32_t first_unused_ = 0;   // none before
};

}  // namespace glark::surfel
