// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Peers that run as a program of their own: glark-bench-peers beside this one, which is built where CGAL is installed.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tests/bench_points/measure.h"

namespace glark::bench {

struct PeerWork {
  Work work;                             // its `run` is empty
  std::size_t found = 0;                 // leaves, or triangles
  std::vector<std::uint32_t> triangles;  // of "front"
};

// Nothing where there is no such program. Throws std::runtime_error where it fails. `task` is "octree" or "front".
std::optional<PeerWork> peer(const std::string& task, const std::string& name, std::span<const float> positions,
                             int rounds);

}  // namespace glark::bench
