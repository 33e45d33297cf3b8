// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Selects what one view of a level of detail draws: strips of leaves, and points for nodes that are too small for
// strips.
// Based on: Boubekeur 2007, ch. 5.2.5 and 5.2.6; Rusinkiewicz and Levoy, QSplat, 2000.
#pragma once

#include <glark/surfel.h>

#include <span>

#include "glark/clients/surfel/cull/camera.h"

namespace glark::surfel {

// Appends the selected nodes to the frame.
void select_nodes(std::span<const Node> nodes, const View& view, const Camera& camera, Frame& frame);

}  // namespace glark::surfel
