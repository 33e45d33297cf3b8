// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Checks of the caller's arguments. All throw Error.
#pragma once

#include <glark/surfel.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace glark::surfel {

void check_options(const Options& options);
void check_array_sizes(const Cloud& cloud);
void check_point(const Cloud& cloud, std::size_t point);
// had_points: the number of points before the update. had_normals: whether the cloud had normals then.
void check_update(const Cloud& cloud, std::span<const std::uint32_t> moved, std::size_t had_points, bool had_normals);
void check_level(unsigned level, unsigned level_count);
void check_view(const View& view);

}  // namespace glark::surfel
