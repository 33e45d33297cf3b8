// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "conformance/report/record.h"
#include "conformance/runner/run_options.h"

namespace glark::conformance {

// Asks a process of its own. Throws std::runtime_error where no context can be made.
Environment describe_environment(const RunOptions& options);

// Hears of each case as it ends; false: no other is begun.
using Progress = std::function<bool(const Record&)>;

// One record for every name, in their order, but for those that were not begun.
std::vector<Record> run(const std::vector<std::string>& names, const RunOptions& options, const Progress& progress);

}  // namespace glark::conformance
