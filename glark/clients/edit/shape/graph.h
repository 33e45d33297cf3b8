// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Which samples are neighbours. The relation is symmetric: the Laplacian over it is, too.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/common/workers.h"

namespace glark::edit {

struct Graph {
  std::vector<std::uint32_t> begins{0};   // [samples + 1]
  std::vector<std::uint32_t> neighbours;  // of sample i: from begins[i] to begins[i + 1], in ascending order

  std::size_t size() const { return begins.size() - 1; }
  std::span<const std::uint32_t> of(std::size_t sample) const {
    return std::span(neighbours).subspan(begins[sample], begins[sample + 1] - begins[sample]);
  }
};

// Each sample and its eight nearest ones are neighbours. positions: [3 * samples].
Graph nearest_graph(std::span<const double> positions, const common::Workers& workers);
// The ends of the triangles' edges are neighbours.
Graph triangle_graph(std::size_t samples, std::span<const std::uint32_t> triangles);

}  // namespace glark::edit
