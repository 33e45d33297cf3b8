// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "glark/tool/doctor/observation.h"

namespace glark::tool {

// Runs the program with the environment of this process for at most so many seconds, then stops it and all processes that
// it has started. An interrupt (Ctrl-C) stops it earlier. Returns the ending and the processes; the rest is empty. If the
// program could not be started, its ending is `left` with the status of become_program().
Observation watch(const std::vector<std::string>& command, double seconds);

}  // namespace glark::tool
