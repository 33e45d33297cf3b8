// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/common/points/record.h"
#include "glark/clients/common/workers.h"

namespace glark::vstree {

using namespace common;  // Float4, records and workers

// Reverses normals so that neighbours agree. Samples are connected along a minimum spanning tree of the neighbours'
// graph while the surface is smooth. Then all edges between two of the parts decide together how these agree: samples
// on top of one another belong to the two sides of a thin wall. Normals that are `given` stay as they are; other parts
// point up (upright.h). Near samples should have near indices. trust: of the normals, from trust_in().
// Based on: H. Hoppe et al., Surface Reconstruction from Unorganized Points, 1992, section 3.3.
void orient(std::span<const Float4> points, std::span<Float4> normals, std::span<const std::uint32_t> neighbours,
            std::size_t each, std::span<const float> trust, const std::vector<bool>& given, const Workers& workers);

}  // namespace glark::vstree
