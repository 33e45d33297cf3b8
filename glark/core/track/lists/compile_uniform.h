// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include "glark/core/context.h"

namespace glark::core::track {

// Called when a command that sets a uniform is compiled into a display list.
void compile_uniform(Context& context, const char* function, GLint location);

}  // namespace glark::core::track
