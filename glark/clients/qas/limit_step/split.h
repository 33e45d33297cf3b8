// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The topology of a mesh after one step of subdivision.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "glark/clients/qas/topology.h"

namespace glark::qas {

// Returns the topology after the step. Its vertices are those of `topology`, then the middles of its edges. Each
// triangle becomes three triangles at its corners, then the middle one.
// patches: the patches of `topology`. Their positions are these vertices.
Topology split(const Topology& topology, const std::vector<Patch>& patches);

// Returns for each vertex after the step the two vertices that it lies between. A vertex from before the step appears
// twice.
std::vector<std::array<std::uint32_t, 2>> parents(const Topology& topology);

}  // namespace glark::qas
