// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Finds samples that lie on no surface.
//
// A sample is supported if several of its neighbours agree with it: each lies near the tangent plane of the other, and
// their normals are similar. In sparse regions, its neighbours must also lie near to a plane. Groups of supported
// samples that are larger than chance makes them are parts of a surface, however sparse. A sample beside such a part
// belongs to it if it lies on the planes of some of its samples, as corners do.
//
// Dense samples tell nothing about places far from them: a surface would have more samples there. So an outlier beside
// the boundary of a surface does not belong to it. A sample in a surface that faces away from it is an outlier, too.
#pragma once

#include <span>
#include <vector>

#include "glark/clients/reconstruct/density/neighbours.h"

namespace glark::reconstruct {

// Samples that are no suspects have several others within this share of `sparse`, a squared distance.
inline constexpr float support_share = 0.5F;

// Returns the entries that may be outliers, in ascending order. Each of the others has several samples near by, in its
// own cell, that agree with it. sparse: as below. This is much quicker than looking for the neighbours of all samples.
std::vector<std::uint32_t> suspects_of(const Neighbours& neighbours, float sparse, float noise, const Workers& workers);

// Returns the outliers among the suspects. suspects: entries in ascending order; all others are taken to be on a
// surface. sparse: the square of the distance of the sixth neighbour in sparse regions. Denser outliers must be farther from
// their neighbours than these are from theirs. others: the same distance for samples that are no suspects, at most.
// noise: relative to the cube.
std::vector<std::uint32_t> outliers_among(std::span<const std::uint32_t> suspects, const Neighbours& neighbours,
                                          float sparse, float others, float noise, const Workers& workers);

// What some of the samples show.
struct Sampling {
  double unsupported = 0;  // the share of samples without support
  float sixth_square = 0;  // the median squared distance of the sixth neighbour of samples with support
};
Sampling look_at_some(const Neighbours& neighbours, float noise, const Workers& workers);

}  // namespace glark::reconstruct
