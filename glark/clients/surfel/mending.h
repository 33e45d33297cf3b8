// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Where leaves do not agree: of the triangles that only some have, those are drawn that together are a surface, and what is left open
// between them is closed. Triangles on which all agree are one already, for around each point they are of one triangulation.
// In place of the dual pairs of Boubekeur 2007, ch. 5.2.2, which know of two triangles at a time.
#pragma once

#include <span>
#include <vector>

#include "glark/clients/surfel/layer.h"

namespace glark::surfel {

// Of leaves whose candidates have new states. Fills in `mended` of these and of all others that share a place of disagreement with
// them, which are returned: ascending, and with all of `leaves`.
std::vector<std::uint32_t> mend(Layer& layer, std::span<const std::uint32_t> leaves, const LayerOptions& options,
                                const Workers& workers);

}  // namespace glark::surfel
