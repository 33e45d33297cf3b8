// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Which triangles of a leaf's patch are drawn.
// Based on: Boubekeur 2007, ch. 5.2.2. A leaf is compared with those of lower numbers, whatever has been made first.
#pragma once

#include <vector>

#include "glark/clients/surfel/layer.h"
#include "glark/clients/surfel/strip_path.h"

namespace glark::surfel {

// The valid triangles of a leaf, counter-clockwise, by the layer's points; fills in what the patch says of them.
void decimate(const Layer& layer, std::uint32_t leaf, Patch& patch, std::vector<StripTriangle>& valid);

}  // namespace glark::surfel
