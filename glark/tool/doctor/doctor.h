// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "glark/tool/run.h"

namespace glark::tool {

// The exit status if the program ran, but nothing was refined.
inline constexpr int exit_nothing_refined = 1;

// Runs the program for some seconds, and says in words what was refined, what was not, and why. Returns an exit status: 0
// if a draw was refined.
int doctor(const RunOptions& options, const std::vector<std::string>& command, double seconds);

}  // namespace glark::tool
