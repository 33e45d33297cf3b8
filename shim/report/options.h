// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "glark/settings/settings.h"

namespace glark::shim {

// Returns the settings of this process. The first call reads them from the environment and logs their errors.
const settings::Settings& options();

// Returns whether keys of the user count: that of the panel, or --toggle-key.
bool wants_keys();

// The environment when options() was called first; the program may change its own while we read. Ends with null.
const char* const* first_environment();

// The names that this program may have in the configuration file: settings::program_names().
const std::vector<std::string>& program_names();

}  // namespace glark::shim
