// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Which estimated normals are likely to be right.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/common/points/record.h"
#include "glark/clients/common/workers.h"

namespace glark::vstree {

using namespace common;  // Float4 and workers

// Returns the trust in each normal, 0 to 1. It is the mean agreement of the normal with those of the neighbours that lie
// in its sample's plane. It is small where the plane joins the two sides of a thin wall. neighbours: [each * points], as from nearest().
std::vector<float> trust_in(std::span<const Float4> normals, std::span<const Float4> points,
                            std::span<const std::uint32_t> neighbours, std::size_t each, const Workers& workers);

// Replaces each doubtful normal by the mean of trusted ones: those of the neighbours on whose planes the sample lies, if
// there are several and they agree. The normals must be oriented. Normals that are `given` stay as they are.
void mend_doubtful(std::span<Float4> normals, std::span<const Float4> points, std::span<const std::uint32_t> neighbours,
                   std::size_t each, std::span<const float> trust, const std::vector<bool>& given,
                   const Workers& workers);

}  // namespace glark::vstree
