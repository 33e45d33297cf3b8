// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/contexts/contexts.h"
#include "shim/contexts/native_windows.h"
#include "shim/contexts/thread.h"
#include "shim/frames/frame.h"
#include "shim/names/real_functions.h"

using namespace glark::shim;

namespace {

const char* text(const GLubyte* name) { return reinterpret_cast<const char*>(name); }

// `visual`: null for a context that is made for a configuration.
void* glx_created(void* context, void* share, const void* visual = nullptr) {
  context_created(Provider::glx, context, share);
  note_glx_visual(context, visual);
  return context;
}

int switched(int succeeded, void* display, GlxDrawable draw, void* context) {
  if (succeeded) make_current_done(Provider::glx, context, {display, reinterpret_cast<void*>(draw)});
  return succeeded;
}

// A program may swap a window that its context does not draw to; that ends no frame.
void end_frame_of(GlxDrawable drawable) {
  if (current_native() != nullptr && current_surface().drawable == reinterpret_cast<void*>(drawable)) frame_ended();
}

}  // namespace

GLARK_EXPORT GlxProc glXGetProcAddress(const GLubyte* name) {
  return reinterpret_cast<GlxProc>(
      wrapper_or(text(name), reinterpret_cast<void*>(GLARK_REAL(glXGetProcAddress)(name))));
}

GLARK_EXPORT GlxProc glXGetProcAddressARB(const GLubyte* name) {
  return reinterpret_cast<GlxProc>(
      wrapper_or(text(name), reinterpret_cast<void*>(GLARK_REAL(glXGetProcAddressARB)(name))));
}

GLARK_EXPORT void* glXCreateContext(void* display, void* visual, void* share, int direct) {
  return glx_created(GLARK_REAL(glXCreateContext)(display, visual, share, direct), share, visual);
}

GLARK_EXPORT void* glXCreateNewContext(void* display, void* config, int type, void* share, int direct) {
  return glx_created(GLARK_REAL(glXCreateNewContext)(display, config, type, share, direct), share);
}

GLARK_EXPORT void* glXCreateContextAttribsARB(void* display, void* config, void* share, int direct,
                                              const int* attributes) {
  return glx_created(GLARK_REAL(glXCreateContextAttribsARB)(display, config, share, direct, attributes), share);
}

GLARK_EXPORT void* glXCreateContextWithConfigSGIX(void* display, void* config, int type, void* share, int direct) {
  return glx_created(GLARK_REAL(glXCreateContextWithConfigSGIX)(display, config, type, share, direct), share);
}

GLARK_EXPORT void glXDestroyContext(void* display, void* context) {
  context_destroyed(Provider::glx, context);
  GLARK_REAL(glXDestroyContext)(display, context);
}

// Frees an imported context of another process. That context lives on.
GLARK_EXPORT void glXFreeContextEXT(void* display, void* context) {
  context_destroyed(Provider::glx, context);
  GLARK_REAL(glXFreeContextEXT)(display, context);
}

GLARK_EXPORT void glXCopyContext(void* display, void* source, void* destination, unsigned long mask) {
  GLARK_REAL(glXCopyContext)(display, source, destination, mask);
  context_copied(Provider::glx, destination);
}

GLARK_EXPORT int glXMakeCurrent(void* display, GlxDrawable drawable, void* context) {
  make_current_begins(Provider::glx, context);
  return switched(GLARK_REAL(glXMakeCurrent)(display, drawable, context), display, drawable, context);
}

GLARK_EXPORT int glXMakeContextCurrent(void* display, GlxDrawable draw, GlxDrawable read, void* context) {
  make_current_begins(Provider::glx, context);
  return switched(GLARK_REAL(glXMakeContextCurrent)(display, draw, read, context), display, draw, context);
}

GLARK_EXPORT int glXMakeCurrentReadSGI(void* display, GlxDrawable draw, GlxDrawable read, void* context) {
  make_current_begins(Provider::glx, context);
  return switched(GLARK_REAL(glXMakeCurrentReadSGI)(display, draw, read, context), display, draw, context);
}

GLARK_EXPORT GlxDrawable glXCreateWindow(void* display, void* config, GlxDrawable window, const int* attributes) {
  const GlxDrawable drawable = GLARK_REAL(glXCreateWindow)(display, config, window, attributes);
  note_glx_window(window, drawable);
  return drawable;
}

GLARK_EXPORT void glXSwapBuffers(void* display, GlxDrawable drawable) {
  end_frame_of(drawable);
  GLARK_REAL(glXSwapBuffers)(display, drawable);
}

GLARK_EXPORT std::int64_t glXSwapBuffersMscOML(void* display, GlxDrawable drawable, std::int64_t target,
                                               std::int64_t divisor, std::int64_t remainder) {
  end_frame_of(drawable);
  return GLARK_REAL(glXSwapBuffersMscOML)(display, drawable, target, divisor, remainder);
}
