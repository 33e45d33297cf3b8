// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "conformance/report/record.h"
#include "conformance/runner/run_options.h"

namespace glark::conformance {

// Asks a separate process. Throws std::runtime_error if no context can be made.
Environment describe_environment(const RunOptions& options);

// The calls of a case as a program in C; another process runs it. Throws std::runtime_error if it ends without them.
std::string show_case(const std::string& name, const RunOptions& options);

// Called for each case as it ends; false prevents further cases.
using Progress = std::function<bool(const Record&)>;

// Returns one record for every name, in the names' order, without cases that were not begun.
std::vector<Record> run(const std::vector<std::string>& names, const RunOptions& options, const Progress& progress);

}  // namespace glark::conformance
