// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The nearest neighbours of every sample.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/common/points/record.h"
#include "glark/clients/common/workers.h"

namespace glark::vstree {

using namespace common;  // Float4, records and workers

// Returns `each` neighbours of every point, nearest first, the point itself among them: [each * points]. `each` is at
// most the number of points. Near points should have near indices: then one search finds in the cache what the search
// before has read.
std::vector<std::uint32_t> nearest(std::span<const Float4> points, std::size_t each, const Workers& workers);

}  // namespace glark::vstree
