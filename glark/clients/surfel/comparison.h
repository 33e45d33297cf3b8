// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What leaves look up in one another's triangulations.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "glark/clients/surfel/layer.h"

namespace glark::surfel {

// Ascending.
Corners sorted(std::uint32_t a, std::uint32_t b, std::uint32_t c);

inline constexpr std::size_t not_found = static_cast<std::size_t>(-1);

// Among those of a leaf's candidates that other leaves could have.
std::size_t find(const Layer& layer, std::uint32_t leaf, const Corners& corners);

// Of its longest edge.
float squared_size(const Layer& layer, const Corners& corners);

// Whether no edge is too long for the distances of the corners: the same for all leaves, so that they agree on what is a hole.
bool in_reach(const Layer& layer, const Corners& corners, float reach);

// Of the leaves that have a triangle, the one that draws it.
inline std::uint32_t drawing_leaf(const Layer& layer, const Corners& corners) {
  return std::min({layer.owner[corners[0]], layer.owner[corners[1]], layer.owner[corners[2]]});
}

// Fills in the states of a leaf's candidates. Reads no states of others.
void agree(Layer& layer, std::uint32_t leaf, const LayerOptions& options);

}  // namespace glark::surfel
