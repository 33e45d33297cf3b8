// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Triangles of a patch as one triangle strip.
// Based on: Boubekeur 2007, ch. 5.2.3. Runs of triangles, one after the other in the order that takes the fewest indices in between.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/surfel/runs.h"
#include "glark/clients/surfel/turning.h"

namespace glark::surfel {

// Makes strips, one after the other, in memory that it keeps.
class Stripper {
 public:
  Stripper(std::span<const Vector> positions, bool turn_edges) : turn_edges_(turn_edges), turning_(positions) {}

  // One strip that has all the triangles with their orientation, but for edges that have turned, and others without area. Valid
  // until the next one.
  std::span<const std::uint32_t> strip(std::span<const StripTriangle> triangles);

  std::size_t turned = 0;                                            // edges of the last strip
  std::span<const StripTriangle> drawn() const { return ordered_; }  // its triangles

 private:
  struct Run {
    std::size_t first, count;  // in ordered_
  };
  // How a run begins: the first two points, and whether the first, second and third are clockwise.
  struct Head {
    std::uint32_t first, second;
    bool clockwise, backwards;
    std::uint32_t run;
  };

  void find_runs(std::span<const StripTriangle> triangles);
  void add_heads(std::uint32_t number, bool backwards);
  int indices_between(const Head& head) const;
  void bridge(const Head& head);
  void append(const Head& head);

  bool turn_edges_;
  Runs runs_;
  Turning turning_;
  std::vector<StripTriangle> ordered_;  // run by run
  std::vector<Run> pieces_;
  std::vector<Head> heads_;
  std::vector<std::uint32_t> path_;
  std::vector<std::uint32_t> strip_;
};

}  // namespace glark::surfel
