// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Which way the normals of a whole part point.
#pragma once

#include <span>
#include <vector>

#include "glark/clients/common/points/record.h"
#include "glark/clients/vstree/normals/signed_parts.h"

namespace glark::vstree {

using namespace common;  // Float4

// Returns for each part, indexed by its root, whether its normals must be reversed. Samples whose normals are `given`
// stay as they are. Other parts point up: an open sheet, as a landscape, on the whole; and a closed surface at its
// highest sample. trust: of the samples' normals, 0 to 1.
std::vector<bool> reversed_parts(SignedParts& parts, std::span<const Float4> points, std::span<const Float4> normals,
                                 std::span<const float> trust, const std::vector<bool>& given);

}  // namespace glark::vstree
