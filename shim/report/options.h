// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include "glark/settings/settings.h"

namespace glark::shim {

// Returns the settings of this process. The first call reads them from the environment and logs their errors.
const settings::Settings& options();

}  // namespace glark::shim
