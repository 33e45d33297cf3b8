// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Knows which contexts exist, which contexts share objects, and which context is current in the calling thread.
#pragma once

#include <cstdint>

#include "shim/contexts/surface.h"

namespace glark::shim {

// `native` is the GLXContext, EGLContext or OSMesaContext; null means none.
void context_created(Provider provider, void* native, void* share);
void context_destroyed(Provider provider, void* native);
// The program copied state into a context, which is current in no thread.
void context_copied(Provider provider, void* native);
// Call it before the real MakeCurrent: it is the last chance to free our objects in a context that the program
// destroyed.
void make_current_begins(Provider provider, void* native);
// Call it after a successful MakeCurrent.
void make_current_done(Provider provider, void* native, const Surface& surface);
// The calling thread's context ends a frame: it shows a window, or has none and waits for GL.
void current_ends_frame();

// These describe the current context of the calling thread. Without a context they are null or zero.
Provider current_provider();
void* current_native();
std::uint64_t current_number();  // counts the contexts of the process, from 1; no number is given twice
Surface current_surface();
Size current_size();
// True without a window: a frame then ends at glFinish or glFlush.
bool current_is_offscreen();

}  // namespace glark::shim
