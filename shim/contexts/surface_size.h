// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include "shim/contexts/surface.h"

namespace glark::shim {

// Returns the size in pixels of the target of the calling thread's context. Without a surface it is the size of the
// viewport.
Size surface_size(Provider provider, const Surface& surface, const gl::Dispatch& gl);

}  // namespace glark::shim
