// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Joins the triangles of a patch to one triangle strip. Runs of triangles follow one another in the order that needs
// the fewest indices between the runs.
// Based on: Boubekeur 2007, ch. 5.2.3.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/surfel/level/candidate.h"
#include "glark/clients/surfel/strip/edge_flipper.h"
#include "glark/clients/surfel/strip/strip_builder.h"

namespace glark::surfel {

// Makes strips one by one, and reuses its memory.
class Stripifier {
 public:
  Stripifier(std::span<const Vector> positions, bool flip_edges) : flip_edges_(flip_edges), flipper_(positions) {}

  // Returns a strip with all triangles in their orientation, except for flipped edges. Degenerate triangles lie between
  // them. The strip is valid until the next call.
  std::span<const std::uint32_t> stripify(std::span<const Triangle> triangles);

  // The number of flipped edges of the last strip.
  std::size_t flipped_edges() const { return flipped_; }
  std::span<const Triangle> triangles() const { return triangles_; }

 private:
  struct Run {
    std::size_t first, count;  // a range of triangles_
  };
  // A way to begin a run: the end of the run, and the first two points.
  struct Entry {
    std::uint32_t first, second;
    bool clockwise;  // the orientation of `first`, `second` and the third point
    bool backwards;  // the run begins with its last triangle
    std::uint32_t run;
  };

  const Triangle& triangle_at(const Run& run, std::size_t i, bool backwards) const {
    return triangles_[run.first + (backwards ? run.count - 1 - i : i)];
  }
  void find_runs(std::span<const Triangle> triangles);
  void add_entries(std::uint32_t run, bool backwards);
  std::size_t cheapest_entry() const;
  int connecting_indices(const Entry& entry) const;
  void connect(const Entry& entry);
  void append(const Entry& entry);

  bool flip_edges_;
  StripBuilder builder_;
  EdgeFlipper flipper_;
  std::size_t flipped_ = 0;
  std::vector<Triangle> triangles_;  // sorted by runs
  std::vector<Run> runs_;
  std::vector<Entry> entries_;  // for the runs that are not in the strip yet, sorted by runs
  std::vector<std::uint32_t> run_;
  std::vector<std::uint32_t> strip_;
};

}  // namespace glark::surfel
