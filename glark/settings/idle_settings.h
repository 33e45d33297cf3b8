// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "glark/settings/settings.h"

namespace glark::settings {

// Returns a sentence for each setting that the user gave, but that has no effect together with the others.
std::vector<std::string> idle_settings(const Settings& settings);

}  // namespace glark::settings
