// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The first thing that every wrapper reads: the calling thread's real functions and its context.
#pragma once

#include "glark/gl/dispatch.h"

#define GLARK_EXPORT extern "C" __attribute__((visibility("default")))

namespace glark::core {
class Context;
}

namespace glark::shim {

// `gl` is never null, and no member of it that a wrapper calls is null. `context` is null while the thread has no
// context of ours.
struct Thread {
  const gl::Dispatch* gl;
  core::Context* context;
};

// The functions of a thread that has not called GL yet: each one adopts the current context and calls its wrapper
// again.
extern constinit const gl::Dispatch first_call;

extern constinit thread_local Thread current_thread __attribute__((tls_model("initial-exec")));

inline Thread& thread() { return current_thread; }

}  // namespace glark::shim
