// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What glark doctor says about a program that it has watched. Pure.
#pragma once

#include <string>
#include <vector>

#include "glark/tool/doctor/observation.h"

namespace glark::tool {

// Lines for the user: how the program ended; for each process what was refined, what was not, and why; what to try.
std::vector<std::string> diagnosis(const Observation& observation);

// Returns whether any draw was refined.
bool is_refined(const Observation& observation);

}  // namespace glark::tool
