// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// --measure REFERENCE: measures the distance of a result from a reference, and reports the topology of the result.
#pragma once

#include <string>

#include "glark/tool/scan/files.h"

namespace glark::tool {

// Reports duplicate positions, edges and components.
Report topology_report(const geometry::Geometry& geometry);

void describe_measure(CLI::App& command, std::string& reference);

// Reports distances in percent of the diagonal of the reference's bounding box.
Report quality_report(const geometry::Geometry& result, const std::string& reference, const Files& files);

}  // namespace glark::tool
