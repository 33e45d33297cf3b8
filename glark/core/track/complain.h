// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "glark/core/context.h"

namespace glark::core::track {

// Records an error of ours for glGetError. Tells the application why by its debug output, and the user by the log, there
// once for each text. `why`: what is wrong, the value, the limit, and the remedy.
void complain(Context& context, GLenum error, const char* function, const std::string& why);

}  // namespace glark::core::track
