// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "glark/core/refine/assembly/program.h"

namespace glark::refine::assembly {

struct Parsed {
  bool ok = false;
  Program program;
  std::string error;  // "line 3: ..."
};

// Parses a program that the driver has accepted ("!!ARBvp1.0 ... END"). Fails on what glark does not know.
Parsed parse(std::string_view text);

}  // namespace glark::refine::assembly
