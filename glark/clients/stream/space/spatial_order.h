// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/common/vector.h"

namespace glark::stream {

// Returns the indices of the points in an order in which near points follow one another: that of their Morton codes in
// a grid of 256^3 cubes over their box. Points that are not finite come first. At most 2^32 points.
std::vector<std::uint32_t> spatial_order(std::span<const common::Vector3f> points);

}  // namespace glark::stream
