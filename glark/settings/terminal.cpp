// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/settings/terminal.h"

#include <unistd.h>

#include "glark/settings/settings.h"

namespace glark::settings {

bool allows_colors(const char* const* environment) {
  const auto refused = find_variable(environment, "NO_COLOR");
  const auto terminal = find_variable(environment, "TERM");
  return (!refused || refused->empty()) && terminal && !terminal->empty() && *terminal != "dumb";
}

bool has_colors(int file) { return isatty(file) != 0 && allows_colors(environ); }

}  // namespace glark::settings
