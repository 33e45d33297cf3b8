// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/common/workers.h"
#include "glark/clients/common/points/record.h"

namespace glark::vstree {

using namespace common;  // Float4, records and workers

// Reverses normals so that neighbours agree, over a minimum spanning tree of the graph of neighbours in which an edge weighs the angle
// between its lines. Those that are `given` stay as they are; a part without one points up at its highest sample.
// Near samples should have near numbers.
// Source: H. Hoppe et al., Surface Reconstruction from Unorganized Points, 1992, section 3.3.
void orient(std::span<const Float4> points, std::span<Float4> normals, std::span<const std::uint32_t> neighbours,
            std::size_t each, const std::vector<bool>& given, const Workers& workers);

}  // namespace glark::vstree
