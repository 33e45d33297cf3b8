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

// The vertices of `topology`, then the middles of its edges; of every triangle those at its corners, then the middle one.
// patches: of `topology`, whose positions are these vertices.
Topology split(const Topology& topology, const std::vector<Patch>& patches);

// Of each vertex after the step, the two that it lies between: the same twice for one that was there before.
std::vector<std::array<std::uint32_t, 2>> parents(const Topology& topology);

}  // namespace glark::qas
