// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Peers that run in another program, glark-bench-peers, which is built if CGAL is installed.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tests/bench_points/measure/measure.h"

namespace glark::bench {

struct PeerWork {
  Work work;                             // its function `run` is empty
  std::size_t found = 0;                 // number of leaves, or of triangles
  std::vector<std::uint32_t> triangles;  // the triangles of "front"
};

// Returns nothing if there is no such program. Throws std::runtime_error if the program fails. `task` is "octree" or
// "front".
std::optional<PeerWork> peer(const std::string& task, const std::string& name, std::span<const float> positions,
                             int rounds);

}  // namespace glark::bench
