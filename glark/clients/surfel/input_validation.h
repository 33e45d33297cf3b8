// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Checks of the caller's arguments. All throw Error.
#pragma once

#include <glark/surfel.h>

#include <cstddef>

namespace glark::surfel {

void check_options(const Options& options);
void check_array_sizes(const Cloud& cloud);
void check_point(const Cloud& cloud, std::size_t point);

}  // namespace glark::surfel
