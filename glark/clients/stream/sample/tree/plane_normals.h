// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "glark/clients/stream/sample/tree/micro_clusters.h"

namespace glark::stream {

// Gives micro-clusters of points without normals the normal of the plane that fits them and their neighbours best. The
// sums become quadrics. Neighbours agree on the side; the side itself is not known.
// bits: the cell has 2^bits micro-clusters along an edge. side: that of the cell. The clusters are sorted by key.
// Source: H. Hoppe et al., Surface Reconstruction from Unorganized Points, 1992.
void find_plane_normals(std::span<MicroCluster> clusters, unsigned bits, double side);

}  // namespace glark::stream
