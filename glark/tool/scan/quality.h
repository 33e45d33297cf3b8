// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// --measure REFERENCE: how far a result is from a reference, and what holds together in it.
#pragma once

#include <string>

#include "glark/tool/scan/files.h"

namespace glark::tool {

// Points at places of others, edges, components.
Report topology_report(const geometry::Geometry& geometry);

void describe_measure(CLI::App& command, std::string& reference);

// Distances in percent of the diagonal of the reference's bounding box.
Report quality_report(const geometry::Geometry& result, const std::string& reference, const Files& files);

}  // namespace glark::tool
