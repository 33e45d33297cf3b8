// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Checks of options and triangles. common/points/point_set.h checks points.
#pragma once

#include <glark/vstree.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace glark::vstree {

// Both functions throw Error.
void check(const Options& options);
void check_triangles(std::span<const std::uint32_t> triangles, std::size_t points);

}  // namespace glark::vstree
