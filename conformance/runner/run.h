// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "conformance/runner/record.h"

namespace glark::conformance {

// Asks a process of its own. Throws std::runtime_error where no context can be made.
Environment describe_environment(const RunOptions& options);

// One record for every name, in their order. `progress` hears of each as it ends.
std::vector<Record> run(const std::vector<std::string>& names, const RunOptions& options,
                        const std::function<void(const Record&)>& progress);

}  // namespace glark::conformance
