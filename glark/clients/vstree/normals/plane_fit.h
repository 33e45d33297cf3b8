// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The tangent plane of a surface at one of its samples.
#pragma once

#include <cstdint>
#include <span>

#include "glark/clients/common/points/record.h"

namespace glark::vstree {

using namespace common;  // Float4

inline constexpr std::size_t most_neighbours = 256;

// Returns the noise of points on a surface: how far a point lies from the plane of its nearest neighbours, relative to
// its farthest neighbour. It is the median over some thousand points, so edges and thin parts do not count.
// `neighbours` has `each` indices for each point, its own first, then the nearest.
float median_noise(std::span<const Float4> points, std::span<const std::uint32_t> neighbours, std::size_t each);

// Returns the unit normal at the first of the samples `which`, or zero if they lie on a line. The others are its
// neighbours, the nearest first, at most `most_neighbours` with the sample. `noise` is that of all points.
//
// Where the neighbours lie near to one plane, this is the direction in which they extend least. Otherwise some may lie
// on the other side of a thin wall, or beyond a sharp edge. Then planes through three near samples are tried, and the
// plane that is near to most of the neighbours is fitted to those alone. "Near" is a small part of the radius. If no
// plane has enough samples so near to it, it is 2.5 times the noise.
// Based on: M. Fischler, R. Bolles, Random Sample Consensus, 1981, but all planes of the nearest samples are tried.
Float4 fit_normal(std::span<const Float4> points, std::span<const std::uint32_t> which, float noise);

}  // namespace glark::vstree
