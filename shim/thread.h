// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What every wrapper looks at first: the real functions of the calling thread and its context.
#pragma once

#include "glark/gl/dispatch.h"

#define GLARK_EXPORT extern "C" __attribute__((visibility("default")))

namespace glark::core {
class Context;
}

namespace glark::shim {

// `gl` is never null and has no null member that a wrapper calls; `context` is null while no context of ours is current.
struct Thread {
  const gl::Dispatch* gl;
  core::Context* context;
};

// The dispatch of a thread that has not called GL yet.
extern constinit const gl::Dispatch first_call;

extern constinit thread_local Thread current_thread __attribute__((tls_model("initial-exec")));

inline Thread& thread() { return current_thread; }

// Looks for a context that was made current without our seeing it. Returns whether the thread has a context of ours now.
bool adopt_current_context();

}  // namespace glark::shim
