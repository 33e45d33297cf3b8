// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "glark/core/context.h"
#include "shim/contexts/surface.h"

namespace glark::shim {

// Returns the frame as rows from the top, red, green and blue. The alpha of a window has no meaning. The context must be
// current; its state and errors do not change.
std::vector<unsigned char> read_frame(core::Context& context, Size size);

}  // namespace glark::shim
