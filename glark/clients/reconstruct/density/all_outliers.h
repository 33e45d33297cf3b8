// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Finds the outliers of a whole cloud: first among all samples, then among the sparse ones of the rest.
#pragma once

#include <span>
#include <vector>

#include "glark/clients/reconstruct/samples/spacing.h"

namespace glark::reconstruct {

inline constexpr double samples_a_cell = 6;  // in the cells whose side is the unit of these numbers
inline constexpr double spacing_share =
    1.0 / 3;  // of the side; a plane fills about 1.5 cells for each square of a side
inline constexpr std::size_t least_looked_at = 50;  // fewer samples tell nothing about their density

// Returns the outliers among all samples, as entries in ascending order. Empty if there are hardly any, which a few
// samples show, or if most samples are outliers.
std::vector<std::uint32_t> outliers_among_all(const PointSet& points, const Cube& cube,
                                              const std::vector<Entry>& entries, const Workers& workers);

// Returns the entries in cells with few samples around.
std::vector<std::uint32_t> sparse_entries(const std::vector<Entry>& entries, double side);

// Returns the outliers among sparse samples.
std::vector<std::uint32_t> outliers_among_sparse(std::span<const std::uint32_t> sparse, const PointSet& points,
                                                 const Cube& cube, const std::vector<Entry>& entries,
                                                 const Workers& workers);

// removed: in ascending order.
std::vector<Entry> without_entries(const std::vector<Entry>& entries, std::span<const std::uint32_t> removed);

// Returns the indices of all outliers in ascending order.
std::vector<std::uint32_t> all_outliers(const PointSet& points, const Workers& workers);

}  // namespace glark::reconstruct
