// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// How a simplification changes the connections of a mesh: its connected parts, and edges of more than two triangles.
#pragma once

#include <string>

#include "glark/clients/geometry/geometry.h"
#include "glark/tool/scan/console.h"

namespace glark::tool {

// Reports the parts before and after, and how many more such edges there are. Warns if there are more or fewer parts, or
// more such edges. Points at the same position are one point. output: the name of the result.
Report connections_report(const geometry::Geometry& before, const geometry::Geometry& after, const std::string& output);

}  // namespace glark::tool
