// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include "glark/core/context.h"

namespace glark::shim {

// Adds the frame to the film that --record asks for. The context must be current; its state and errors do not change.
void record_frame(core::Context& context);

}  // namespace glark::shim
