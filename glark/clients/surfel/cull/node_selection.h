// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Selects what one view of a level of detail draws: strips of leaves, and points for nodes that are too small for
// strips.
// Based on: Boubekeur 2007, ch. 5.2.5 and 5.2.6; Rusinkiewicz and Levoy, QSplat, 2000.
#pragma once

#include <glark/surfel.h>

#include <functional>
#include <span>

#include "glark/clients/surfel/cull/camera.h"

namespace glark::surfel {

// Appends the points of a node to the list.
using AddPoints = std::function<void(std::uint32_t node, std::vector<std::uint32_t>& points)>;

// Appends the selected nodes to the frame. A leaf that has a box but no strip has no surface: its points are drawn.
void select_nodes(std::span<const Node> nodes, const View& view, const Camera& camera, const AddPoints& add_points,
                  Frame& frame);

}  // namespace glark::surfel
