// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glark/maps.h>

namespace glark::maps {

// Throws Error for an option out of its range.
void check(const BakeOptions& options);

}  // namespace glark::maps
