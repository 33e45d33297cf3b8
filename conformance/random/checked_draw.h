// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// One draw of a random sequence: its picture, its errors, the state that it leaves and the triangles that it counts.
#pragma once

#include <optional>

#include "conformance/random/sequence.h"

namespace glark::conformance {

// Refinement is enabled afterwards.
std::optional<WrongDraw> checked_draw(World& w, const RandomStep& step);

}  // namespace glark::conformance
