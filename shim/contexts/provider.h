// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The three ways to an OpenGL context, and the real GL functions of each.
#pragma once

#include "glark/gl/dispatch.h"

namespace glark::shim {

enum class Provider { glx, egl, osmesa };
inline constexpr int provider_count = 3;

// The functions that the provider's own GetProcAddress gives, loaded at the first call. No member is null: one that the
// driver lacks does nothing, returns 0 and says so once in the log.
const gl::Dispatch& dispatch_of(Provider provider);

// For a thread without a context: whatever GL is loaded.
const gl::Dispatch& dispatch_without_context();

}  // namespace glark::shim
