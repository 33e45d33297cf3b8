// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include "glark/settings/settings.h"

namespace glark::shim {

// The settings of this process, read from its environment at the first call. What was wrong with them is logged then.
const settings::Settings& options();

}  // namespace glark::shim
