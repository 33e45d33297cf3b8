// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "glark/settings/settings.h"

namespace glark::tool {

// As shells have them.
inline constexpr int exit_usage = 2;
inline constexpr int exit_not_executable = 126;
inline constexpr int exit_not_found = 127;

// Values as they go to the environment, already checked; empty leaves the environment as it is.
struct RunOptions {
  std::string level;
  std::string max_level;
  std::string refine;
  std::string edge_pixels;
  std::string curvature;
  std::string budget;
  bool wireframe = false;
  std::vector<std::string> captures;  // FRAME:FILE.png each
  std::string log;
  std::string statistics;
};

// Becomes the program. Returns only if that fails: an exit status, after a message on standard error.
int run(const RunOptions& options, const std::vector<std::string>& command);

}  // namespace glark::tool
