// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The nearest neighbours of every sample.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/common/workers.h"
#include "glark/clients/common/points/record.h"

namespace glark::vstree {

using namespace common;  // Float4, records and workers

// [each * points], nearest first, the sample itself among them; `each` is no more than there are points. Near ones should
// have near numbers: then what one search looks at is in the cache for the next.
std::vector<std::uint32_t> nearest(std::span<const Float4> points, std::size_t each, const Workers& workers);

}  // namespace glark::vstree
