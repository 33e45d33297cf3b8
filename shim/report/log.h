// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include "glark/core/report/log.h"

namespace glark::shim {

// From now on, the core's messages of this level or a more serious one go to standard error, one line "glark: ..."
// each.
void install_log(core::LogLevel level);

}  // namespace glark::shim
