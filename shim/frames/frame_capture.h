// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include "glark/core/context.h"

namespace glark::shim {

// Writes the frame as a PNG file if GLARK_CAPTURE asks for it. The context must be current; its state and errors do not
// change.
void capture_frame(core::Context& context, unsigned long frame);

}  // namespace glark::shim
