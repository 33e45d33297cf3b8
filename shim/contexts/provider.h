// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The three window systems that give OpenGL contexts, and the real GL functions of each.
#pragma once

#include "glark/gl/dispatch.h"

namespace glark::shim {

enum class Provider { glx, egl, osmesa };
inline constexpr int provider_count = 3;

// Returns the functions from the provider's own GetProcAddress; the first call loads them. No member is null: a
// function that the driver lacks does nothing, returns 0 and logs that once.
const gl::Dispatch& dispatch_of(Provider provider);

// Returns the functions for a thread without a context, from the GL library that is loaded.
const gl::Dispatch& dispatch_without_context();

}  // namespace glark::shim
