// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Which contexts exist, which share objects, and which is current on the calling thread.
#pragma once

#include "shim/contexts/surface.h"

namespace glark::shim {

// `native` is the GLXContext, EGLContext or OSMesaContext; null means none.
void context_created(Provider provider, void* native, void* share);
void context_destroyed(Provider provider, void* native);
// State was copied into a context that is current nowhere.
void context_copied(Provider provider, void* native);
// Before the real MakeCurrent: last chance to free the objects of ours in a context that the program has destroyed.
void make_current_begins(Provider provider, void* native);
// After it has succeeded.
void make_current_done(Provider provider, void* native, const Surface& surface);

// Of the calling thread; all are null or zero without a context.
Provider current_provider();
void* current_native();
Surface current_surface();
Size current_size();
// No window: a frame ends at glFinish or glFlush.
bool current_is_offscreen();

}  // namespace glark::shim
