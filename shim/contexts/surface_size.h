// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include "shim/contexts/surface.h"

namespace glark::shim {

// In pixels, of what the calling thread's context draws to. A context without a surface has the size of its viewport.
Size surface_size(Provider provider, const Surface& surface, const gl::Dispatch& gl);

}  // namespace glark::shim
