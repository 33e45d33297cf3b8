// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Colours of the coarse mesh's vertices, as in LocalEstimate. A vertex gets the colour of the samples around it, or
// else of its neighbours.
#pragma once

#include "glark/clients/reconstruct/samples/local_surface.h"

namespace glark::reconstruct {

std::vector<Float4> coarse_colours(const std::vector<Float4>& points, const std::vector<Float4>& normals,
                                   const std::vector<std::uint32_t>& triangles, const Octree& octree,
                                   const Workers& workers);

}  // namespace glark::reconstruct
