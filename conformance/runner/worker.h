// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The process in which cases run. It reports in lines of JSON, so that earlier messages survive a crash:
//   {"environment": {...}}
//   {"begin": "ark.x"}
//   {"shown": "the calls of a case"}
//   {"end": "ark.x", "verdict": "Fail", "messages": [...], "images": [...]}
#pragma once

#include <string>
#include <vector>

#include "conformance/runner/run_options.h"

namespace glark::conformance {

enum class WorkerTask { describe, run, show };

// Writes to the file descriptor `channel`; images go to the report's directory. Returns the exit status.
int work(WorkerTask task, const RunOptions& options, const std::vector<std::string>& names, int channel);

}  // namespace glark::conformance
