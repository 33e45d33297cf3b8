// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Competitors count only if they draw the same picture.
#pragma once

#include <string>

#include "tests/bench/interleave.h"
#include "tests/bench/offscreen.h"

namespace glark::bench {

Picture picture_of(const Competitor& competitor);

// Throws if the pictures differ. The refined draw is repeated, because later pictures come from the cache.
void expect_same(const std::string& name, const Competitor& refined, const Competitor& other);

}  // namespace glark::bench
