// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Moves points between the leaves of a level's tree.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "glark/clients/surfel/level/level.h"
#include "glark/clients/surfel/update/index_set.h"

namespace glark::surfel {

class PointMover {
 public:
  // moved: see update_level(). The caller keeps the arguments.
  PointMover(Level& level, std::span<const Surfel> moved, const LevelOptions& options)
      : level_(level), tree_(level.tree), moved_(moved), options_(options) {}

  // Moves the points, and rebuilds the leaves that points leave or enter. Returns all leaves whose triangulations may
  // change.
  std::vector<std::uint32_t> run();

 private:
  void touch(std::uint32_t leaf, Vector position);
  void touch_old_leaves();
  void touch_new_leaves();
  void add_touched_and_neighbours();
  void remove_moved_points();
  void remove_from_leaf(Leaf& leaf, const std::vector<std::uint8_t>& is_moved, bool keep_box);
  std::uint32_t new_leaf_of(const Surfel& surfel) const;
  void resize_point_arrays();
  void rebuild_touched_leaves();
  void rebuild(std::uint32_t leaf);
  void refit_ancestors();

  // A moved point and its new leaf.
  struct Arrival {
    std::uint32_t leaf;
    std::size_t point;  // an index in moved_
  };

  Level& level_;
  StrippingTree& tree_;
  std::span<const Surfel> moved_;
  const LevelOptions& options_;
  IndexSet affected_;  // the result
  IndexSet touched_;   // leaves that points leave or enter
  std::vector<std::vector<Vector>>
      touched_positions_;                     // for each leaf: the old and new positions of the points that touch it
  std::vector<std::uint32_t> touched_index_;  // for each leaf: its index among the first touched leaves
  std::vector<bool> moves_as_whole_;          // for each of the first touched leaves
  std::vector<Arrival> arrivals_;             // sorted by leaf
};

}  // namespace glark::surfel
