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

// Returns `each` neighbours of every point, the nearest first: [each * points]. The point itself is among them.
// `each` is at most the number of points. Near points should have near indices. Then a search finds the data of the
// search before in the cache.
std::vector<std::uint32_t> nearest(std::span<const Float4> points, std::size_t each, const Workers& workers);

}  // namespace glark::vstree
