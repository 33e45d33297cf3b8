// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Sums over the points of small cubes, the micro-clusters, which replace the points of an unfinished cell in memory.
// A cube is a small part of what a sample stands for. So the sampling is nearly that of the points themselves, and an
// unfinished cell takes the same memory for any density of points. The sums are exact.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/common/resume/state_file.h"

namespace glark::stream {

// A point of a cell, ready to be summed up.
struct LocalPoint {
  std::uint32_t cell = 0;
  std::uint32_t key = 0;            // the Morton code of its micro-cluster within the cell
  std::array<float, 3> position{};  // from the centre of the micro-cluster
  std::array<float, 3> normal{};    // of unit length, or zero
  std::array<std::uint8_t, 4> colour{};
};

struct MicroCluster {
  std::uint32_t key = 0;
  float count = 0;
  std::array<float, 3> position{}, normal{}, colour{};  // sums
  // With normals: the quadric of the tangent planes n x + d = 0: xx yy zz xy yz zx of n, then n d, then d d.
  // Without: the products xx yy zz xy yz zx of the positions.
  std::array<float, 10> sums{};

  void add(const LocalPoint& point, bool has_normals);
};

// The micro-clusters of a cell. They lie in several tables, by their keys, so that several threads can add to a cell.
class MicroTable {
 public:
  static constexpr unsigned parts = 8;
  static unsigned part_of(std::uint32_t key) { return (key ^ (key >> 3) ^ (key >> 6)) & (parts - 1); }

  // Adds a point of this part.
  void add(unsigned part, const LocalPoint& point, bool has_normals);
  // Returns all micro-clusters, by their keys, and empties the tables.
  std::vector<MicroCluster> take();
  std::size_t size() const;  // micro-clusters
  std::size_t bytes() const;
  void save(common::StateWriter& state) const;
  bool load(common::StateReader& state);

 private:
  struct Part {
    std::vector<MicroCluster> clusters;
    std::vector<std::uint32_t> slots;  // an open hash table of indices + 1
    std::size_t last = 0;
  };
  static void rebuild(Part& table, std::size_t slots);

  std::array<Part, parts> parts_;
};

}  // namespace glark::stream
