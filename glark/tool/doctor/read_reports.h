// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "glark/tool/doctor/observation.h"

namespace glark::tool {

// Reads the statistics file of a process. The name is empty if the text is not one.
ProcessReport read_report(std::string_view text);

// Reads all statistics files of the folder, those with most draws first.
std::vector<ProcessReport> read_reports(const std::string& folder);

}  // namespace glark::tool
